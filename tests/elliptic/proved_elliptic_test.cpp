// The elliptic functions on balls: every value of the tables is contained, and the balls are narrow.
#include <catch2/catch.hpp>
#include <string>

#include "libration/elliptic/complete_integral_series.hpp"
#include "libration/elliptic/incomplete_integral.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "proved.hpp"
#include "reference_table.hpp"

namespace elliptic_proved_elliptic_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::tests;

namespace {

// A typed number as a ball: the digits that it misses are in the radius.
ball typed_ball(const std::string& text) { return from_exact<ball>(read_exact(text)); }

modulus<ball> modulus_of_complement(const std::string& kc) { return modulus<ball>::from_complement(typed_ball(kc)); }

}  // namespace

TEST_CASE("balls of the complete integral contain the table", "[elliptic][ball]") {
    for (const long asked : {20L, 50L, 90L}) {
        const precision_scope scope(asked);
        for (const table_row& row : reference_table("complete.csv")) {
            INFO(row.at("kc"));
            const auto m = modulus_of_complement(row.at("kc"));
            // A rounding a level, at most 20 levels, and the rounding of k' (condition below 1).
            CHECK_THAT(complete_integral(m), encloses(decimal(row.at("K")), 60));
            // k is rounded where k' is given, and K' has the condition of k next to 0: both are taken from the pair.
            if (row.at("kc") != "1") {
                const ball other = complete_integral(m.swapped());
                CHECK(contains(enclose(other, ball(decimal(row.at("K_complementary")).uncertainty)),
                               ball(decimal(row.at("K_complementary")).value)));
            }
        }
        CHECK_THROWS_AS(complete_integral(modulus_of_complement("0")), libration::error);
    }
}

TEST_CASE("the bounds of both partial sums of K hold between balls", "[elliptic][ball]") {
    const precision_scope scope(60);
    for (const std::string kc : {"0.99", "0.7", "0.1", "1e-3", "1e-10"}) {
        const auto m = modulus_of_complement(kc);
        const ball truth = complete_integral(m);
        for (const int order : {0, 1, 5, 40}) {
            INFO(kc << ", order " << order);
            const ball bound = complete_integral_series_bound(m, order);
            const ball left_out = truth - complete_integral_series(m, order);
            CHECK(overlaps(enclose(complete_integral_series(m, order), bound), truth));
            // Proved: 0 < K - sum <= bound, unless what is left out is below the digits at hand.
            CHECK((contains_zero(left_out) || certainly_less(ball(0), left_out)));
            CHECK_FALSE(certainly_less(bound, left_out));
            CHECK_FALSE(certainly_less(complete_integral_resummed_bound(m, order),
                                       truth - complete_integral_resummed(m, order)));
        }
    }
}

TEST_CASE("balls of the Jacobi functions contain the table", "[elliptic][ball]") {
    for (const long asked : {20L, 50L, 90L}) {
        const precision_scope scope(asked);
        for (const table_row& row : reference_table("jacobi.csv")) {
            INFO("u = " << row.at("u") << ", k' = " << row.at("kc"));
            const ball u = typed_ball(row.at("u"));
            const auto m = modulus_of_complement(row.at("kc"));
            const auto v = jacobi(u, m);
            // The radius of u, a rounding of up to |u| epsilon, times slopes up to 1, and the levels as above; am grows
            // with u. A k' that is rounded moves values by u k'^2 of its rounding.
            const mpfr spread = 1 + abs(midpoint_of(u));
            CHECK_THAT(v.sn, encloses(decimal(row.at("sn")), 5'000, spread));
            CHECK_THAT(v.cn, encloses(decimal(row.at("cn")), 5'000, spread));
            CHECK_THAT(v.dn, encloses(decimal(row.at("dn")), 5'000, spread));
            CHECK_THAT(amplitude(u, m), encloses(decimal(row.at("am")), 5'000, spread));
            CHECK(contains_zero(v.sn * v.sn + v.cn * v.cn - 1));
            CHECK(contains_zero(v.dn * v.dn + m.k * m.k * v.sn * v.sn - 1));
        }
    }
}

TEST_CASE("balls of the incomplete integral contain the table", "[elliptic][ball]") {
    for (const long asked : {20L, 50L, 90L}) {
        const precision_scope scope(asked);
        for (const table_row& row : reference_table("incomplete.csv")) {
            INFO("phi = " << row.at("phi") << ", k' = " << row.at("kc"));
            const ball phi = typed_ball(row.at("phi"));
            const ball value = incomplete_integral(phi, modulus_of_complement(row.at("kc")));
            const expected_value expected = decimal(row.at("F"));
            CHECK(contains(enclose(value, ball(expected.uncertainty)), ball(expected.value)));
        }
    }
}

TEST_CASE("an argument that may lie beyond K is refused by the quarter formula", "[elliptic][ball]") {
    const precision_scope scope(30);
    const auto m = modulus_of_complement("0.5");
    const landen_chain<ball> chain(m);
    const ball quarter = complete_integral(chain);
    CHECK_NOTHROW(jacobi_at(ball(quarter / 2), chain));
    CHECK_THROWS_AS(jacobi_at(quarter, chain), precision_exhausted);
    CHECK_THROWS_AS(jacobi_at(ball(quarter * 3 / 2), chain), precision_exhausted);
    CHECK_THROWS_AS(jacobi_at(enclose(ball(1), ball(10)), chain), precision_exhausted);
}

}  // namespace elliptic_proved_elliptic_test
