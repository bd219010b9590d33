// How many digits of theta does Boost.Math leave, near the separatrix?
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "audit.hpp"

namespace libration::studies {

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

const study& audit_boost() {
    static const study result{
        .name = "audit_boost",
        .title = "Boost.Math, judged",
        .label = "",
        .question = "How many digits of theta does Boost.Math leave in double when the energy comes close to 2?",
        .reading = "TODO.",
        .parameters = audit_parameters(),
        .quick = quick_audit(),
        .seconds = 1,
        .run = [](const study_request& request) { return run_audit("audit_boost", "boost", by_boost, request); }};
    return result;
}

}  // namespace libration::studies
