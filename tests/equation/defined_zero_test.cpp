// Factors that are multiplied by 0 end solutions where they are not defined: in expressions, proofs and double.
#include "libration/equation/defined_zero.hpp"
#include "libration/equation/choice.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/integration/taylor/batch_march.hpp"
#include "libration/manifold/reduced_field.hpp"
#include "libration/query/limit.hpp"
#include "libration/query/states.hpp"
#include "libration/query/trajectory.hpp"
#include "libration/scalar/error.hpp"

namespace ode_domain_test {

using namespace libration;
using namespace libration::ode;
using Catch::Matchers::Contains;

namespace {

// The first unknown in 10 digits, or "" where it has none.
std::string proved_at(const std::string& problem, const std::string& time) {
    const auto found =
        proved_part_of_trajectory(explicit_system(parse(problem)), {parse_constant(time).constant()}, 10);
    const auto& state = found.states.front();
    REQUIRE((state.empty() || !state.front().decimal) == found.missing.has_value());
    return state.empty() || !state.front().decimal ? "" : state.front().decimal->text;
}

// Whether the first unknown is within 1e-12 of a value there, in double and in mpfr; no value: NaN.
double rounded_at(const std::string& problem, const std::string& time) {
    const auto of = [&](const auto& found) {
        const auto& values = found.states.front().front();
        return values.empty() ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(values.front());
    };
    const explicit_system system(parse(problem));
    const std::vector<number> times{parse_constant(time).constant()};
    const double in_double = of(part_of_march<double>(system, times));
    const double in_mpfr = of(part_of_trajectory(system, times, 20));
    CHECK((in_double == in_mpfr || std::abs(in_double - in_mpfr) < 1e-12 || std::isnan(in_double + in_mpfr)));
    return in_double;
}

// x = 0, and the equation has no value at t = 1.
const std::vector<std::string> ends_at_one{"x' = x*log(1 - t)",
                                           "x' = x/(1 - t)",
                                           "x' = x*sqrt(1 - t)",
                                           "x' = x*(1 - t)^(-1/2)",
                                           "x' = x*(1 - t)^(2/5)",
                                           "x' = x*acosh(2 - t)",
                                           "x' = x*asin(t)",
                                           "x' = x*lambertw(-t/e)",
                                           "x' = x*tan(pi*t/2)",
                                           "x' = x*bessel_k(0, 1 - t)",
                                           "x' = x*t/(1 - t)",
                                           "x' = 0*log(1 - t)",
                                           "x' = a*log(1 - t); a = 0",
                                           "x' = a*b; b = log(1 - t); a = 0",
                                           "x' = log(1 - t) - log(1 - t)",
                                           "x' = log(1 - t)^0 - 1",
                                           "x' = (2 - t)/(2 - t) - 1 + 0/(1 - t)",
                                           "x' = sin(x*log(1 - t))",
                                           "x' = x*atan(1/(1 - t))",
                                           "x' = 0*(0*log(1 - t))",
                                           "x' = -2*(0*log(1 - t))",
                                           "x' = x*log(1 + 0*x - t)",
                                           "0 = x*(x + 1 - t)",
                                           "0 = x*(1 + log(1 - t)^2)"};

}  // namespace

TEST_CASE("zeros keep the domain of what they multiply", "[ode]") {
    const ode::expression t = variable();
    const ode::expression x = unknown("x");
    const ode::expression zero = zero_where_defined(log(1 - t));
    CHECK(zero.is_unfolded_zero());
    CHECK(zero_where_defined(exp(t) + sin(x) * atan(t) * pow(x, 3)).is(0));
    CHECK_FALSE(zero_where_defined(cbrt(t)).is(0));
    CHECK_FALSE(zero_where_defined(pow(t, -1)).is(0));
    CHECK(same_form(3 * zero, zero));
    CHECK(same_form(-zero, zero));
    CHECK(same_form(zero + zero, zero));
    CHECK(same_form(partial(zero, t), zero));
    CHECK(partial(zero, x).is(0));
    CHECK(without_zeros(x + 2 * sin(zero)).is(0) == false);
    CHECK(same_form(without_zeros(x + 2 * zero), x));
    const auto at_two = [](const ode::expression& leaf) {
        return leaf.kind() == node_kind::variable ? std::optional(ode::expression(2)) : std::nullopt;
    };
    CHECK_THROWS_AS(replaced(zero, at_two), error);  // log(-1)
    const auto at_zero = [](const ode::expression& leaf) {
        return leaf.kind() == node_kind::unknown ? std::optional(ode::expression(0)) : std::nullopt;
    };
    CHECK(same_form(replaced_as_written(x * log(1 - t), at_zero), zero));
    CHECK(replaced_as_written(x * exp(t), at_zero).is(0));
    CHECK(zero_with_domain(x * log(1 - t), at_zero)->size() == 1);
    CHECK(zero_with_domain(x * exp(t) + x * log(x + 2), at_zero)->empty());
    CHECK_FALSE(zero_with_domain(x + log(1 - t), at_zero));
}

TEST_CASE("constant solutions end where their equations have no value", "[ode][proved]") {
    for (const std::string& each : ends_at_one) {
        CAPTURE(each);
        const std::string problem = each + "; x(0) = 0";
        CHECK(proved_at(problem, "1/2") == "0");
        CHECK(proved_at(problem, "2").empty());
        CHECK(proved_at(problem, "1.001").empty());
    }
    CHECK(proved_at("x' = x*log(1 + t); x(0) = 0", "-0.9") == "0");
    CHECK(proved_at("x' = x*log(1 + t); x(0) = 0", "-2").empty());
    CHECK(proved_at("x' = (x - c)*log(1 - t); x(0) = c; c = 3", "0.75") == "3.000000000");
    CHECK(proved_at("x' = x*log(y); y' = -1; x(0) = 0; y(0) = 1", "0.75") == "0");
    CHECK(proved_at("x' = x*log(y); y' = -1; x(0) = 0; y(0) = 1", "2").empty());
    CHECK(proved_at("x' = x*t/(1 - t); y' = y; x(0) = 0; y(0) = 1", "2").empty());
    CHECK(proved_at("(2 - t)*x' = 0; x(0) = 1", "3/2") == "1.000000000");
    CHECK(proved_at("(2 - t)*x' = 0; x(0) = 1", "3").empty());
    // Where the divisor of theorem D is 0 another branch crosses, and the solution is no longer the only one.
    CHECK(proved_at("0 = x*(x - t)*(1 + t); x(-1/2) = 0", "-0.1") == "0");
    CHECK(proved_at("0 = x*(x - t)*(1 + t); x(-1/2) = 0", "2").empty());
    CHECK(proved_at("0 = (x - 1)*(x - t); x(0) = 1", "2").empty());
    CHECK(proved_at("0 = (x - 1)*log(2 - t); x(0) = 1", "0.9") == "1.000000000");
    CHECK(proved_at("0 = (x - 1)*log(2 - t); x(0) = 1", "3").empty());
}

TEST_CASE("constant solutions of equations that are defined at all times", "[ode][proved]") {
    CHECK(proved_at("x' = x*exp(t) + sin(x)*t; x(0) = 0", "1e6") == "0");
    CHECK(proved_at("x' = (x - 2)*log(x); x(0) = 2", "-1e9") == "2.000000000");
    CHECK(proved_at("x' = x/cbrt(1 - t); x(0) = 0", "2") == "0");  // across the root
    CHECK(proved_at("x' = x/(1 + t^2); x(0) = 0", "100") == "0");
    CHECK(proved_at("t*x' = 0; x(0) = 1", "2") == "1.000000000");
}

TEST_CASE("other solutions end there, too", "[ode][proved]") {
    const std::string start = "; x(0) = 1";
    for (const std::string each : {"x' = x + 0*log(1 - t)", "x' = x + a*log(1 - t); a = 0", "x' = x*(1 - t)/(1 - t)",
                                   "x' = x + z*log(1 - t); z' = 0; z(0) = 0", "x' = x + log(1 - t) - log(1 - t)"}) {
        CAPTURE(each);
        CHECK(proved_at(each + start, "1/2") == "1.648721271");
        CHECK(proved_at(each + start, "1.1").empty());
    }
    // From a singular initial point, where the first step must not be longer, and beside a root of the time.
    CHECK(proved_at("x' = (1 - x)/t + 2*t + 0*log(1/100 - t); x(0) = 1", "1/200") == "1.000016667");
    CHECK(proved_at("x' = (1 - x)/t + 2*t + 0*log(1/100 - t); x(0) = 1", "1/50").empty());
    CHECK(proved_at("x' = cbrt(1 - t)*x + 0*log(1.01 - t); x(0) = 1", "1.005") != "");
    CHECK(proved_at("x' = cbrt(1 - t)*x + 0*log(1.01 - t); x(0) = 1", "1.02").empty());
}

TEST_CASE("rounded solutions end there, too", "[ode]") {
    for (const std::string each : {"x' = x*log(1 - t); x(0) = 0", "x' = x*t/(1 - t); x(0) = 0",
                                   "x' = 0/(1 - t); x(0) = 0", "x' = z*log(1 - t); z' = 0; x(0) = 0; z(0) = 0"}) {
        CAPTURE(each);
        CHECK(rounded_at(each, "1/2") == 0);
        CHECK(std::isnan(rounded_at(each, "2")));
    }
    // exp(0.9), to a rounding error or two of each of a few steps.
    CHECK(std::abs(rounded_at("x' = x + 0*log(1 - t); x(0) = 1", "0.9") - 2.4596031111569497) < 1e-14);
    CHECK(std::isnan(rounded_at("x' = x + 0*log(1 - t); x(0) = 1", "1.1")));
    batch_march many(explicit_system(parse("x' = x + 0*log(1 - t); x(0) = 1")));
    std::vector<double> values(4);
    many.run({0, std::vector<double>{1, 2}, std::vector<double>{0.9, 1.1}}, values);
    CHECK(std::abs(values[0] - 2.4596031111569497) < 1e-14);
    CHECK(std::abs(values[2] - 2 * 2.4596031111569497) < 1e-14);
    CHECK((std::isnan(values[1]) && std::isnan(values[3])));
}

TEST_CASE("branches that conditions do not choose need no value", "[ode]") {
    const ode::expression holds = parameter(name_of_positive("step 1"));
    const auto right_with = [&](const ode::expression& right, int value) {
        equation_system branch;
        branch.add(derivative(unknown("x")), right).begin(unknown("x"), 0, 0);
        branch.set(holds.name(), value);
        return explicit_system(branch).right().front();
    };
    const ode::expression log_of_rest = log(1 - variable());
    CHECK(same_form(right_with(choice_between(holds, log_of_rest, 1), 0), ode::expression(1)));
    CHECK(same_form(right_with(choice_between(holds, log_of_rest, 1), 1), log_of_rest));
    CHECK(same_form(right_with(choice_between(1 - holds, 2, log_of_rest), 0), ode::expression(2)));
    CHECK(same_form(right_with(choice_between(holds, choice_between(1 - holds, 3, log_of_rest), log_of_rest), 1),
                    log_of_rest));
    // A factor of what is chosen is not chosen.
    CHECK_FALSE(right_with(choice_between(holds, 1, 0) * log_of_rest + 1, 0).kind() == node_kind::constant);
    equation_system written;
    written.add(derivative(unknown("x")), parameter("k") * log(1 - variable()) + 1);
    written.begin(unknown("x"), 0, 0);
    written.set("k", 0);
    CHECK_FALSE(same_form(explicit_system(written).right().front(), ode::expression(1)));
}

TEST_CASE("singular starts are decided exactly", "[ode][proved]") {
    const auto refusal = Contains("has no power series with these initial values");
    for (const std::string each :
         {"x'' = -2*x'/t - pi*x; x(0) = 1; x'(0) = 1e-40", "x'' = -2*x'/t - pi*x; x(0) = 1; x'(0) = exp(-800)",
          "x'' = -2*x'/t - x; x(0) = pi; x'(0) = 1e-35", "x' = (1 - x)/(2*t); x(0) = 1 + exp(-80)",
          "x' = (1 - x)/t + y; y' = y; y(0) = sqrt(2); x(0) = 1 + 10^(-32)"}) {
        CAPTURE(each);
        CHECK_THROWS_WITH(proved_at(each, "1"), refusal);
        CHECK_THROWS_WITH(rounded_at(each, "1"), refusal);
    }
    // sin(w)/w for w^2 = pi, by mpmath.
    CHECK(proved_at("x'' = -2*x'/t - pi*x; x(0) = 1; x'(0) = 0", "1") == "0.5527568077");
    // 1 + sqrt(2), since the integral of s e^s from 0 to 1 is 1.
    CHECK(proved_at("x' = (1 - x)/t + y; y' = y; y(0) = sqrt(2); x(0) = 1", "1") == "2.414213562");
}

TEST_CASE("limits of constant solutions are their values", "[ode][proved][limit]") {
    const auto limit_of = [](const std::string& problem) {
        return limit_at_equilibrium(explicit_system(parse(problem)), 10).states.front().front().decimal->text;
    };
    CHECK(limit_of("x' = x; x(0) = 0") == "0");
    CHECK(limit_of("x' = x*(1 - x); y' = -y; x(0) = 1; y(0) = 1") == "1.000000000");
    CHECK(limit_of("x' = -x*y; y' = x*y - y; x(0) = 1; y(0) = 0") == "1.000000000");
    for (const std::string each :
         {"x' = -x + 0*log(x - 1/4)", "x' = -x*(x - 1/4)/(x - 1/4)", "x' = log(x - 1/4) - x - log(x - 1/4)"}) {
        CAPTURE(each);
        CHECK_THROWS_WITH(limit_of(each + "; x(0) = 1/2"), Contains("exist up to 0.693147180"));
    }
}

TEST_CASE("derivatives of a field have no value where the field has none", "[ode][proved][limit]") {
    for (const std::string each : {"x' = -x + 0*log(x - 1/4)", "x' = log(x - 1/4) - x - log(x - 1/4)"}) {
        CAPTURE(each);
        const reduced_field f(explicit_system(parse(each + "; x(0) = 1/2")));
        CHECK(is_finite(f.derivative({ball(1)})(0, 0)));
        CHECK_FALSE(is_finite(f.derivative({ball(0)})(0, 0)));
    }
}

}  // namespace ode_domain_test
