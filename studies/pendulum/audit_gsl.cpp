// How many correct digits of theta does the GNU Scientific Library deliver near the separatrix?
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "audit.hpp"
#include "run/child_program.hpp"
#include "run/program_files.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

namespace audit_gsl_study {
namespace {

// GSL is under the GPL, so it is called in a separate process. Throws input_error if that program was not built.
std::string gsl_program() {
    std::string path = peer_program("libration-gsl-theta");
    if (!std::filesystem::exists(path)) {
        throw input_error(
            "the study audit_gsl asks the GNU Scientific Library, whose program is not here: install it (Debian: "
            "apt-get install libgsl-dev), configure, build and install again");
    }
    return path;
}

std::vector<double> by_gsl(const std::vector<audited_input>& inputs) {
    std::string questions;
    for (const audited_input& given : inputs) {
        questions += fmt::format("{:a} {:a}\n", given.k, given.time);
    }
    std::istringstream answers(output_of_program(gsl_program(), questions));
    std::vector<double> thetas;
    thetas.reserve(inputs.size());
    for (std::string line; std::getline(answers, line);) {
        thetas.push_back(std::strtod(line.c_str(), nullptr));
    }
    if (thetas.size() != inputs.size()) {
        throw std::runtime_error(fmt::format("GSL returned {} of {} values", thetas.size(), inputs.size()));
    }
    return thetas;
}

}  // namespace
}  // namespace audit_gsl_study

const study& audit_gsl() {
    using namespace audit_gsl_study;
    static const study result{
        .name = "audit_gsl",
        .title = "The GNU Scientific Library, judged",
        .question = "How many digits of theta does GSL leave in double when the energy comes close to 2?",
        .reading =
            "Correct digits of theta (absolute where |theta| < 1) against the gap 2 - E, one panel a time. Circles: "
            "our own double from the exact gap, at most {{max error_ulp of audit_gsl where library=libration to 2}} "
            "units in the last place of max(1, |theta|) off. "
            "Dots: GSL from the nearest double of k = sqrt(E/2), by 2 asin(k cd(t, k)). Dashed: how far theta of that "
            "double is from the theta that was meant, so what no code can win back that takes k alone. Most of the "
            "loss is that: at a gap of 1e-15 and t = 3T/16 "
            "{{the correct_digits of audit_gsl where gap=1e-15 time_typed=3T/16 library=gsl to 2}} digits are left. "
            "GSL adds its own, up to {{max own_ulp of audit_gsl where time=0.7 library=gsl to 2}} units at t = 0.7, "
            "where the arcsine of a number next to 1 keeps half of its digits, and at gaps about 2e-8, up to "
            "{{max own_ulp of audit_gsl where time=10 library=gsl to 1}} units at t = 10, where Boost.Math loses "
            "{{max own_ulp of audit_boost where time=10 library=boost to 1}} at most.",
        .of = &pendulum_problem(),
        .parameters = audit_parameters(),
        .quick = quick_audit(),
        .seconds = 1,
        .excluded = without_modulus(),
        .plan = [](const study_request& request) { return plan_of_audit("gsl", by_gsl, request); }};
    return result;
}

}  // namespace libration::studies
