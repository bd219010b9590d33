// How many correct digits of theta does Boost.Math deliver near the separatrix?
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "audit.hpp"

namespace libration::studies {

namespace audit_boost_study {
namespace {

std::vector<double> by_boost(const std::vector<audited_input>& inputs) {
    std::vector<double> thetas;
    thetas.reserve(inputs.size());
    for (const audited_input& given : inputs) {
        thetas.push_back(2 * std::asin(given.k * boost::math::jacobi_cd(given.k, given.time)));
    }
    return thetas;
}

}  // namespace
}  // namespace audit_boost_study

const study& audit_boost() {
    using namespace audit_boost_study;
    static const study result{
        .name = "audit_boost",
        .title = "Boost.Math, judged",
        .question = "How many digits of theta does Boost.Math leave in double when the energy comes close to 2?",
        .reading =
            "Correct digits of theta (absolute where |theta| < 1) against the gap 2 - E, one panel a time. Circles: "
            "our own double from the exact gap, at most {{max error_ulp of audit_boost where library=libration to 2}} "
            "units in the last place of max(1, |theta|) off. "
            "Dots: Boost.Math from the nearest double of k = sqrt(E/2), by 2 asin(k cd(t, k)). Dashed: how far theta "
            "of that double is from the theta that was meant, so what no code can win back that takes k alone. Most of "
            "the loss is that: at a gap of 1e-15 and t = 3T/16 "
            "{{the correct_digits of audit_boost where gap=1e-15 time_typed=3T/16 library=boost to 2}} digits are "
            "left, and of {{the error_ulp of audit_boost where gap=1e-15 time_typed=3T/16 library=boost to 1}} lost "
            "units {{the own_ulp of audit_boost where gap=1e-15 time_typed=3T/16 library=boost to 2}} are of Boost's "
            "own making. Near the top it adds its own, up to "
            "{{max own_ulp of audit_boost where time=0.7 library=boost to 1}} units at t = 0.7, because the arcsine of "
            "a number next to 1 keeps half of its digits.",
        .of = &pendulum_problem(),
        .parameters = audit_parameters(),
        .quick = quick_audit(),
        .seconds = 1,
        .excluded = without_modulus(),
        .plan = [](const study_request& request) { return plan_of_audit("boost", by_boost, request); }};
    return result;
}

}  // namespace libration::studies
