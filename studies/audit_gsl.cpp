// How many digits of theta does the GNU Scientific Library leave, near the separatrix?
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "audit.hpp"
#include "sweep/child_program.hpp"
#include "sweep/input_error.hpp"

namespace libration::studies {

namespace {

// GSL is under the GPL, so it is asked in a process of its own. Throws input_error where that program was not built.
std::string gsl_program() {
#ifdef LIBRATION_GSL_THETA
    if (std::filesystem::exists(LIBRATION_GSL_THETA)) {
        return LIBRATION_GSL_THETA;
    }
#endif
    throw input_error(
        "the study audit_gsl asks the GNU Scientific Library, whose program is not here: install it (Debian: apt-get "
        "install libgsl-dev), configure and build again, and run the program of the build folder");
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
        throw std::runtime_error(fmt::format("GSL answered {} of {} questions", thetas.size(), inputs.size()));
    }
    return thetas;
}

}  // namespace

const study& audit_gsl() {
    static const study result{
        .name = "audit_gsl",
        .title = "The GNU Scientific Library, judged",
        .label = "",
        .question = "How many digits of theta does GSL leave in double when the energy comes close to 2?",
        .reading = "TODO.",
        .parameters = audit_parameters(),
        .quick = quick_audit(),
        .seconds = 1,
        .run = [](const study_request& request) { return run_audit("audit_gsl", "gsl", by_gsl, request); }};
    return result;
}

}  // namespace libration::studies
