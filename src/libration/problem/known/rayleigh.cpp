#include "far_start.hpp"
#include "known_problems.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

using ode::equation_system;
using ode::explicit_system;

mpfr gamma_of(const mpfr& x) {
    mpfr result(0);
    mpfr_gamma(handle(result), handle(x), MPFR_RNDN);
    return result;
}

// R0 sqrt(pi/6) Gamma(5/6)/Gamma(4/3) from rest.
far_behaviour far_from_rayleigh(const equation_system& given) {
    const explicit_system system(given);
    if (far::start_of(system, 0, 1) != 0) {
        throw error(error_kind::argument, error_subject::start, "",
                    "of rayleigh is not at rest, and its collapse is known only from rest");
    }
    const mpfr end = far::start_of(system, 0, 0) * sqrt(mpfr(pi<mpfr>() / 6)) * gamma_of(mpfr(mpfr(5) / 6)) /
                     gamma_of(mpfr(mpfr(4) / 3));
    return {"rayleigh", "R", far_form::branch, system, far::polynomial({mpfr(0)}), mpfr(0), end, {{"collapse", end}}};
}

}  // namespace

known_facts facts_of_rayleigh() {
    return {.problem = "rayleigh", .far = [](const equation_system& given, long /*digits*/, const std::string&) {
                return far_from_rayleigh(given);
            }};
}

}  // namespace libration
