// The numbers of `libration period` compared with closed forms and the reference table.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/reference_motion.hpp"

namespace command_period_test {

using namespace libration;
using namespace libration::tests;

namespace {

using words = std::vector<std::string>;

table_row period_of(words motion) {
    motion.insert(motion.begin(), "period");
    const auto rows = rows_of(motion);
    REQUIRE(rows.size() == 1);
    return rows.front();
}

// ((2n)!/n!^2)^2 16^-n (E/2)^n, exactly.
rational binomial_term(int n, const rational& parameter) {
    rational term = 1;
    for (int i = 1; i <= n; ++i) {
        term *= rational((2 * i - 1) * (2 * i - 1), 4 * i * i) * parameter;
    }
    return term;
}

// |value - truth| as printed in the error column: 6 digits, of a value that is itself rounded to `value_unit`.
void check_error(const std::string& printed, const mpfr& error, const mpfr& value_unit) {
    const precision_scope scope(100);
    INFO("error " << printed << ", expected " << to_decimal(error, 12));
    CHECK(abs(number_of(printed) - error) <= last_place(printed) + value_unit);
}

}  // namespace

TEST_CASE("the period from 90 degrees is Gamma(1/4)^2/sqrt(pi)", "[command][period]") {
    const precision_scope scope(80);
    const mpfr gamma = tgamma(mpfr("0.25"));
    const mpfr expected = gamma * gamma / sqrt(pi<mpfr>());
    const table_row row = period_of({"--theta0", "90deg", "--omega0", "0", "--digits", "50"});
    CHECK_THAT(row.at("period"), right_to_the_last_digit_of(expected));
    CHECK_THAT(row.at("tstar"), right_to_the_last_digit_of(expected / 4));
    CHECK(period_of({"--energy", "1"}).at("period") == row.at("period"));
}

TEST_CASE("a gap of 1e-30 costs no digit", "[command][period]") {
    // K = L + (L-1) k'^2/4 + 9 (L-7/6) k'^4/64 + O(k'^6 L), L = log(4/k') [DLMF 19.12.1]; here k'^2 = 5e-31, so that
    // the omitted terms are below 1e-89.
    const precision_scope scope(100);
    const mpfr square("5e-31");
    const mpfr log = libration::mpfr(boost::multiprecision::log(mpfr(16) / square)) / 2;
    const mpfr expected = log + (log - 1) * square / 4 + (log - mpfr(7) / 6) * square * square * 9 / 64;
    for (const std::string digits : {"50", "80"}) {
        const table_row row = period_of({"--gap", "1e-30", "--digits", digits});
        CHECK_THAT(row.at("tstar"), right_to_the_last_digit_of(expected));
        CHECK_THAT(row.at("period"), right_to_the_last_digit_of(expected * 4));
    }
}

TEST_CASE("every motion of the reference table has its period to 50 digits", "[command][period]") {
    std::size_t motions = 0;
    for (const reference_motion& motion : reference_motions()) {
        INFO(command_line(motion.options));
        const table_row row = period_of(motion.options);
        CHECK_THAT(row.at("period"), right_to_the_last_digit(motion.rows.front().at("period")));
        CHECK_THAT(row.at("tstar"), right_to_the_last_digit(motion.rows.front().at("tstar")));
        ++motions;
    }
    CHECK(motions > 40);
}

TEST_CASE("the period has all the digits of any request", "[command][period]") {
    // T(150 deg) = sqrt 3 T(30 deg), whatever the digits.
    for (const std::string digits : {"3", "17", "400"}) {
        const precision_scope scope(500);
        const std::string high = period_of({"--theta0", "150deg", "--omega0", "0", "--digits", digits}).at("period");
        const std::string low = period_of({"--theta0", "30deg", "--omega0", "0", "--digits", digits}).at("period");
        mpfr large;
        mpfr small;
        mpfr_set_str(handle(large), high.c_str(), 10, MPFR_RNDN);
        mpfr_set_str(handle(small), low.c_str(), 10, MPFR_RNDN);
        CHECK(abs(large - sqrt(mpfr(3)) * small) <= last_place(high) + last_place(low) * 2);
    }
}

TEST_CASE("the partial sum of the series is the sum of its exact terms", "[command][period]") {
    const precision_scope scope(100);
    const rational parameter(171, 200);
    rational sum = 0;
    for (int n = 0; n <= 10; ++n) {
        sum += binomial_term(n, parameter);
    }
    const mpfr expected = from_rational<mpfr>(sum) * pi<mpfr>() / 2;
    const table_row row = period_of({"--energy", "1.71", "--method", "series", "--order", "10"});
    CHECK(row.at("method") == "series");
    CHECK(row.at("order") == "10");
    CHECK_THAT(row.at("tstar"), right_to_the_last_digit_of(expected));
    CHECK_THAT(row.at("period"), right_to_the_last_digit_of(expected * 4));
    const mpfr truth = number_of(reference_motion_of("1.71").rows.front().at("tstar"));
    check_error(row.at("error"), abs(truth - expected), last_place(row.at("tstar")));
}

TEST_CASE("the resummed period adds artanh(k)/k and takes its series away", "[command][period]") {
    // Above E = 2, k^2 = 2/E and the unit of time is sqrt(2/E).
    const precision_scope scope(100);
    for (const std::string energy : {"1.71", "2.02"}) {
        const rational e = read_exact(energy).coefficient;
        const rational parameter = e < 2 ? rational(e / 2) : rational(2 / e);
        const mpfr rate = e < 2 ? mpfr(1) : mpfr(sqrt(from_rational<mpfr>(rational(e / 2))));
        const mpfr k = sqrt(from_rational<mpfr>(parameter));
        mpfr expected = log((1 + k) / (1 - k)) / (k * 2);
        rational power = 1;
        for (int n = 0; n <= 7; ++n) {
            expected += from_rational<mpfr>(binomial_term(n, parameter)) * pi<mpfr>() / 2 -
                        from_rational<mpfr>(rational(power / (2 * n + 1)));
            power *= parameter;
        }
        expected /= rate;
        const table_row row = period_of({"--energy", energy, "--method", "resummed", "--order", "7"});
        CHECK_THAT(row.at("tstar"), right_to_the_last_digit_of(expected));
        const mpfr truth = number_of(reference_motion_of(energy).rows.front().at("tstar"));
        check_error(row.at("error"), abs(truth - expected), last_place(row.at("tstar")));
    }
}

TEST_CASE("each fixed scalar gives the period to a few of its own units and says how far it is", "[command][period]") {
    struct fixed {
        std::string name;
        int bits;
    };
    for (const fixed& scalar : {fixed{"double", 53}, fixed{"long-double", 64}, fixed{"quad", 113}}) {
        INFO(scalar.name);
        const precision_scope scope(100);
        for (const std::string energy : {"0.5", "1.71", "1.9998", "2.02"}) {
            const mpfr truth = number_of(reference_motion_of(energy).rows.front().at("tstar"));
            const table_row row = period_of({"--energy", energy, "--scalar", scalar.name});
            const mpfr error = abs(number_of(row.at("tstar")) - truth);
            // The mean, its initial k' and the division: within 8 units in the last place.
            CHECK(error <= truth * ldexp(mpfr(1), 4 - scalar.bits));
            check_error(row.at("error"), error, last_place(row.at("tstar")));
        }
    }
}

}  // namespace command_period_test
