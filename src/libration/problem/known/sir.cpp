#include "libration/problem/known/sir.hpp"

#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

ball epidemic_remainder(const ball& susceptible, const ball& infected, const ball& rho) {
    const ball x = -(susceptible / rho) * exp(-(susceptible + infected) / rho);
    ball w;
    arb_lambertw(w.handle(), x.handle(), 0, ball::working_bits());
    if (!is_finite(w)) {
        throw precision_exhausted("the final state of an epidemic");
    }
    return -rho * w;
}

}  // namespace libration::ode

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

far_behaviour far_from_sir(const std::string& name, const equation_system& given, long digits) {
    const explicit_system system(given);
    const mpfr a = far::parameter_of(given, "a");
    const mpfr r = far::parameter_of(given, "r");
    const mpfr s = far::left_of_epidemic(mpfr(a / r), far::start_of(system, 0, 0), far::start_of(system, 1, 0));
    const mpfr rate = a - r * s;
    return {name,
            "S",
            far_form::reciprocal_exponential,
            system,
            far::polynomial({s}),
            rate,
            mpfr(-log(far::ten_to(-digits)) * 5 / 4 / rate),
            {{"S(inf)", s}, {"rate", rate}}};
}

// S and I; the third of the populations is not an unknown.
std::vector<proved_decimal> what_sir_leaves(const equation_system& system, long digits) {
    const explicit_system solved(system);
    const auto value_of = [&](const char* name) {
        return ode::number_with_values(system.parameter_of(name)->value, system);
    };
    const auto left = proved_value(digits, [&] {
        return ode::epidemic_remainder(ode::constant_value<ball>::of(solved.starts()[0][0]),
                                       ode::constant_value<ball>::of(solved.starts()[1][0]),
                                       ode::constant_value<ball>::of(value_of("a") / value_of("r")));
    });
    return {left, {"0", "0"}};
}

}  // namespace

known_facts facts_of_sir() {
    return {.problem = "sir",
            .limits = what_sir_leaves,
            .far = [](const equation_system& given, long digits, const std::string&) {
                return far_from_sir("sir", given, digits);
            }};
}

known_facts facts_of_sir_japan() {
    return {.problem = "sir_japan", .far = [](const equation_system& given, long digits, const std::string&) {
                return far_from_sir("sir_japan", given, digits);
            }};
}

}  // namespace libration
