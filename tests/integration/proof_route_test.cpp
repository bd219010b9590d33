// Two routes to the same statements: both hold the closed form, they share little, and a wrong product in the first is
// seen by the second.
#include "libration/integration/proof_route.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "certificates/checked.hpp"
#include "command/temporary_folder.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/exact.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/query/certificate/certificate.hpp"
#include "libration/query/problem_coefficients.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/query/shooting/periodic_orbit.hpp"
#include "libration/query/shooting/proved_unknowns.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/polynomial.hpp"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

namespace integration_proof_route_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system system_of(const std::string& text) { return explicit_system(parse(text)); }

rational fraction_of(const std::string& text) { return read_exact(text).coefficient; }

bool holds(const proved_decimal& printed, const rational& truth) {
    return abs(rational(fraction_of(printed.text) - truth)) <= fraction_of(printed.uncertainty);
}

// FLINT's product of ball polynomials without a guard: up to 3.6 it takes the sign of a transformed coefficient from
// its top limbs.
class unguarded_product final : public series::block_product<ball> {
public:
    void add_middle(ball* sums, int count, const ball* a, int length, const ball* b, int terms) const override {
        std::vector<ball> c(static_cast<std::size_t>(length + count));
        const int used = std::min(terms, length + count);
        _arb_poly_mullow(c.front().handle(), b->handle(), used, a->handle(), length, length + count,
                         ball::working_bits());
        for (int i = 0; i < count; ++i) {
            sums[i] += c[static_cast<std::size_t>(length) + static_cast<std::size_t>(i)];
        }
    }
    int least_length() const override { return fast_product<ball>()->least_length(); }
};

// A product that is wrong in one coefficient, by a part of 2^-100, and counts how often it is asked.
class wrong_product final : public series::block_product<ball> {
public:
    void add_middle(ball* sums, int count, const ball* a, int length, const ball* b, int terms) const override {
        ++calls;
        fast_product<ball>()->add_middle(sums, count, a, length, b, terms);
        sums[0] += ldexp(sums[0], -100L);
    }
    int least_length() const override { return fast_product<ball>()->least_length(); }
    mutable long calls = 0;
};

proved_decimal value_by(const explicit_system& system, const number& time, long digits, const proof_route& route) {
    return proved_trajectory(system, {time}, digits, {}, route).front().front();
}

// -c^2/15, of c = 1 - 2^-349.
constexpr const char* all_ones = "y' = (c/(1-t))*(c/(t-1)); y(0)=0; c = 1 - 2^(-349)";

rational truth_of_all_ones() {
    const rational c = 1 - rational(1, integer(1) << 349U);
    return -c * c / 15;
}

}  // namespace

TEST_CASE("a second proof sees a wrong product of the first", "[proof_route]") {
    const explicit_system system = system_of(all_ones);
    const number time(rational(1, 16));
    const long digits = 197;
    const auto second = value_by(system, time, digits + more_digits_of_second_proof, proof_route::second());
    REQUIRE(holds(second, truth_of_all_ones()));
    const auto right = value_by(system, time, digits, {});
    CHECK(holds(right, truth_of_all_ones()));
    CHECK_NOTHROW(require_agreement(right, second, "y"));

    const wrong_product wrong;
    const auto false_one = value_by(system, time, digits, {0, 8, &wrong});
    REQUIRE(wrong.calls > 0);
    REQUIRE_FALSE(holds(false_one, truth_of_all_ones()));
    CHECK_FALSE(enclosures_meet(false_one, second));
    CHECK_THROWS_WITH(require_agreement(false_one, second, "y at time 1/16"), Catch::Contains("y at time 1/16") &&
                                                                                  Catch::Contains(false_one.text) &&
                                                                                  Catch::Contains(second.text));

    const unguarded_product unguarded;
    const auto perhaps = value_by(system, time, digits, {0, 8, &unguarded});
    CHECK(enclosures_meet(perhaps, second) == holds(perhaps, truth_of_all_ones()));
}

// With 197 digits FLINT's product is wrong from about the 118th on, up to FLINT 3.6; the other one always is.
TEST_CASE("the digits of a wrong product have no certificate", "[proof_route][certificate]") {
    const explicit_system system = system_of(all_ones);
    const rational time(1, 16);
    const long digits = 197;
    const long certified_digits = 121;
    const auto first_digits = [&](const proof_route& route) {
        const std::string all = value_by(system, number(time), digits, route).text;  // -0.0666...
        return within_one_unit(all.substr(0, static_cast<std::size_t>(certified_digits) + 4), certified_digits);
    };
    const decimal_interval right = first_digits({});
    const std::string text = certificate_of(system, {{{time, 0, right}}}, certified_digits);
    const tests::temporary_folder folder;
    const auto checked_with = [&](const decimal_interval& claim) {
        std::string changed = text;
        const std::string before = right.lower + " " + right.upper;
        changed.replace(changed.find(before), before.size(), claim.lower + " " + claim.upper);
        return tests::checked_text(changed, folder.path() / "a.cert");
    };
    REQUIRE(checked_with(right).exit_code == 0);
    const rational truth = truth_of_all_ones();
    const unguarded_product unguarded;
    const wrong_product wrong;
    for (const series::block_product<ball>* const product :
         {static_cast<const series::block_product<ball>*>(&unguarded),
          static_cast<const series::block_product<ball>*>(&wrong)}) {
        const decimal_interval perhaps = first_digits({0, 8, product});
        const bool true_digits = perhaps.low < truth && truth < perhaps.high;
        const auto checked = checked_with(perhaps);
        INFO(perhaps.lower << "\n" << checked.out);
        CHECK((checked.exit_code == 0) == true_digits);
        CHECK((true_digits || tests::contains(checked.out, "the value of y at 1/16 is not proved")));
        CHECK((product == &unguarded || !true_digits));
    }
}

TEST_CASE("a second proof of coefficients sees a wrong product of the first", "[proof_route]") {
    const coefficient_request request{system_of(all_ones), 0, 150};
    const auto second = proved_coefficients(request, 150 + more_digits_of_second_proof, proof_route::second()).values;
    const auto first = proved_coefficients(request, 150).values;
    const wrong_product wrong;
    const auto false_ones = proved_coefficients(request, 150, {0, 8, &wrong}).values;
    bool seen = false;
    for (std::size_t n = 0; n < first.size(); ++n) {
        CHECK(holds(second[n], n == 0 ? rational(0) : truth_of_all_ones() * 15));
        CHECK(enclosures_meet(first[n], second[n]));
        seen = seen || !enclosures_meet(false_ones[n], second[n]);
    }
    CHECK(seen);
}

TEST_CASE("the routes of a proof differ in steps, order and products", "[proof_route]") {
    const explicit_system system = system_of("y' = y*cos(t); y(0)=1");
    const auto steps_of = [&](const proof_route& route) {
        proved_march march(system, 200, {}, proved_march::usual_error_bits, route);
        REQUIRE(march.at(number(20)));
        return march.steps();
    };
    const long steps = steps_of({});
    CHECK(steps_of({0, 7, fast_product<ball>()}) > steps);
    CHECK(steps_of({5, 8, fast_product<ball>()}) < steps);
    CHECK(proof_route::second().product == nullptr);
    CHECK(proof_route::second().step_eighths < 8);
    CHECK(proof_route::second().more_terms > 0);
}

TEST_CASE("both routes prove events, unknowns, orbits, radii and starts that are singular", "[proof_route]") {
    const auto both = [](const auto& prove) {
        require_agreement(prove(20, proof_route{}), prove(20 + more_digits_of_second_proof, proof_route::second()),
                          "it");
    };
    event_request landing;
    landing.g = parse_condition(parse("x'' = -x; x(0)=1; x'(0)=0"), "x = 1/3");
    CHECK_NOTHROW(both([&](long digits, const proof_route& route) {
        return proved_events(system_of("x'' = -x; x(0)=1; x'(0)=0"), landing, digits, route).front().time;
    }));
    CHECK_NOTHROW(both([](long digits, const proof_route& route) {
        return proved_unknowns(parse("y' = k*y; y(0)=1; k=0.6"), {"k"}, {{"y", 0, number(1), number(2)}}, digits, route)
            .front();
    }));
    CHECK_NOTHROW(both([](long digits, const proof_route& route) {
        return proved_periodic_orbit(system_of("x' = x-y-x*(x^2+y^2); y' = x+y-y*(x^2+y^2); x(0)=1.01; y(0)=0"), digits,
                                     route)
            .period;
    }));
    CHECK_NOTHROW(both([](long digits, const proof_route& route) {
        return value_by(system_of("t*y'' + y' + t*y = 0; y(0)=1; y'(0)=0"), number(2), digits, route);
    }));
    const explicit_system tangent = system_of("y' = 1+y^2; y(0)=1");
    const auto first = outward_decimals(prove_radius(tangent, 3), 3);
    const auto second = outward_decimals(prove_radius(tangent, 3, proof_route::second()), 3);
    CHECK(intervals_meet(first.lower, first.upper, second.lower, second.upper));
}

TEST_CASE("enclosures that touch meet, and others do not", "[proof_route]") {
    CHECK(enclosures_meet({"1.0", "0.1"}, {"1.2", "0.1"}));
    CHECK_FALSE(enclosures_meet({"1.0", "0.1"}, {"1.20001", "0.1"}));
    CHECK_FALSE(enclosures_meet({"1.20001", "0.1"}, {"1.0", "0.1"}));
    CHECK(enclosures_meet({"0", "0"}, {"0", "0"}));
    CHECK_FALSE(enclosures_meet({"0", "0"}, {"1e-1000", "1e-1001"}));
    CHECK(intervals_meet("1", "2", "2", "3"));
    CHECK_FALSE(intervals_meet("1", "2", "2.001", "3"));
    CHECK_FALSE(intervals_meet("2.001", "3", "1", "2"));
    CHECK(intervals_meet("inf", "inf", "inf", "inf"));
    CHECK_FALSE(intervals_meet("inf", "inf", "1", "2"));
}

}  // namespace integration_proof_route_test
