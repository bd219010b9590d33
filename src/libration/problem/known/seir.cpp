#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

// x^2 + (a + g) x + a (g - b S(inf)) = 0 for the exponents of E and I at S = S(inf): the smaller one dominates.
far_behaviour far_from_seir(const equation_system& given, long digits) {
    const explicit_system system(given);
    const mpfr a = far::parameter_of(given, "a");
    const mpfr b = far::parameter_of(given, "b");
    const mpfr g = far::parameter_of(given, "g");
    const mpfr rest = far::start_of(system, 1, 0) + far::start_of(system, 2, 0);
    const mpfr s = far::left_of_epidemic(mpfr(g / b), far::start_of(system, 0, 0), rest);
    const mpfr rate = (a + g - sqrt(mpfr((a - g) * (a - g) + a * b * s * 4))) / 2;
    return {"seir",
            "S",
            far_form::damped_logarithm,
            system,
            far::polynomial({s}),
            rate,
            mpfr(-log(far::ten_to(-digits)) * 5 / 4 / rate),
            {{"S(inf)", s}, {"rate", rate}}};
}

}  // namespace

known_facts facts_of_seir() {
    return {.problem = "seir", .far = [](const equation_system& given, long digits, const std::string&) {
                return far_from_seir(given, digits);
            }};
}

}  // namespace libration
