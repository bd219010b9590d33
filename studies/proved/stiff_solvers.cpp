// How many digits do implicit solvers deliver of stiff problems, and for how many evaluations of the right-hand side?
#include "judged_solvers.hpp"

namespace libration::studies {

namespace stiff_solvers_study {

namespace {

std::vector<std::string> stiff_problems() {
    std::vector<std::string> names;
    for (const proved::test_problem& each : proved::test_problems()) {
        if (each.is_stiff()) {
            names.push_back(each.name);
        }
    }
    return names;
}

std::vector<std::string> peers_with_implicit_methods() {
    std::vector<std::string> names;
    for (const proved::solver_peer& each : proved::solver_peers()) {
        if (!each.implicit_methods.empty()) {
            names.push_back(each.name);
        }
    }
    return names;
}

const proved::solver_choices& choices() {
    static const proved::solver_choices result(
        proved::choice_of_problems("write names such as robertson_1e11,hires_421, or all", stiff_problems()),
        proved::choice_of_solvers("LIST of gsl, sundials and scipy, or all", "write names such as gsl,sundials, or all",
                                  peers_with_implicit_methods()));
    return result;
}

}  // namespace
}  // namespace stiff_solvers_study

const study& stiff_solvers() {
    using namespace stiff_solvers_study;
    static const study result{
        .name = "stiff_solvers",
        .title = "Solvers of stiff initial value problems, judged",
        .question =
            "How many digits do implicit solvers deliver of stiff problems, and for how many evaluations of the right "
            "sides?",
        .reading =
            "Digits against the number of evaluations, those for the Jacobian among them, one panel a problem, one "
            "curve a method: a point for each tolerance. The error is the largest over eleven times, each twice or ten "
            "times the one before, and all unknowns, measured from proved values, each unknown by its largest value; "
            "the absolute tolerance of an unknown is relative to the same. A method without a point gave up, or took "
            "more than 200000 evaluations. GSL, SUNDIALS and SciPy answer where they are installed.",
        .of = &choices().family(),
        .parameters = {{"--problems", "all", "stiff problems of the reference set"},
                       {"--solvers", "all", "libraries"},
                       {"--tolerances", "1e-3,1e-5,1e-7,1e-9,1e-11,1e-13", "relative and absolute"}},
        .quick = {{"--problems", "stiff_b1", ""}, {"--solvers", "gsl", ""}, {"--tolerances", "1e-4,1e-8", ""}},
        .seconds = 300,
        .plan = [](const study_request& request) { return choices().plan(request); },
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
