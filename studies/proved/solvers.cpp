// How many digits do solvers of initial value problems deliver, and for how many evaluations of the right-hand side? Of
// stiff problems, implicit solvers.
#include "judged_solvers.hpp"
#include "text/members.hpp"

namespace libration::studies {

namespace solvers_study {

namespace {

// Stiff and nonstiff problems whose reference values take two minutes at most.
const std::vector<std::string>& problems() {
    static const std::vector<std::string> result{"arenstorf",
                                                 "brusselator",
                                                 "detest_a3",
                                                 "detest_d5",
                                                 "double_pendulum",
                                                 "duffing",
                                                 "fitzhugh_nagumo",
                                                 "henon_heiles",
                                                 "hires",
                                                 "kepler",
                                                 "logistic",
                                                 "lorenz",
                                                 "lotka_volterra",
                                                 "oregonator",
                                                 "pendulum_179deg",
                                                 "robertson",
                                                 "seir",
                                                 "three_body_figure_8",
                                                 "van_der_pol",
                                                 "van_der_pol_100"};
    return result;
}

std::vector<std::string> stiff_problems() {
    std::vector<proved::test_problem> all = proved::test_problems();
    std::erase_if(all, [](const proved::test_problem& each) { return !each.is_stiff(); });
    return members_of(all, &proved::test_problem::name);
}

std::vector<std::string> peers_with_implicit_methods() {
    std::vector<proved::solver_peer> all = proved::solver_peers();
    std::erase_if(all, [](const proved::solver_peer& each) { return each.implicit_methods.empty(); });
    return members_of(all, &proved::solver_peer::name);
}

const proved::solver_choices& choices() {
    static const proved::solver_choices result(
        proved::choice_of_problems("write names such as lorenz,kepler, or all", problems()),
        proved::choice_of_solvers("LIST of odeint, gsl, sundials, scipy and mpmath, or all",
                                  "write names such as odeint,gsl, or all",
                                  members_of(proved::solver_peers(), &proved::solver_peer::name)));
    return result;
}

const proved::solver_choices& stiff_choices() {
    static const proved::solver_choices result(
        proved::choice_of_problems("write names such as robertson_1e11,hires_421, or all", stiff_problems()),
        proved::choice_of_solvers("LIST of gsl, sundials and scipy, or all", "write names such as gsl,sundials, or all",
                                  peers_with_implicit_methods()));
    return result;
}

// A study of the problems and solvers of these choices, without its texts.
study study_of(const proved::solver_choices& choices, const std::string& problems, const std::string& quick_problem,
               const std::string& quick_solver) {
    study of;
    of.of = &choices.family();
    of.parameters = {{"--problems", "all", problems},
                     {"--solvers", "all", "libraries"},
                     {"--tolerances", "1e-3,1e-5,1e-7,1e-9,1e-11,1e-13", "relative and absolute"}};
    of.quick = {{"--problems", quick_problem, ""}, {"--solvers", quick_solver, ""}, {"--tolerances", "1e-4,1e-8", ""}};
    of.seconds = 300;
    of.plan = [&choices](const study_request& request) { return choices.plan(request); };
    of.offers = arithmetics::proved_too;
    of.script = "solver_panels";
    return of;
}

}  // namespace
}  // namespace solvers_study

const study& solvers() {
    using namespace solvers_study;
    static const study result = [] {
        study of = study_of(choices(), "twenty problems of the reference set", "logistic", "odeint");
        of.name = "solvers";
        of.title = "Solvers of initial value problems, judged";
        of.question =
            "How many digits do solvers of initial value problems deliver, and for how many evaluations of the right "
            "sides?";
        of.reading =
            "Digits against the number of evaluations, one panel a problem, one curve a method: a point for each "
            "tolerance that was asked. The error is the largest over eight times and all unknowns, measured from "
            "proved values, each unknown by its largest value. Solvers work in double and are handed starts and "
            "parameters that are rounded to it; dotted is the error, to first order, that this alone makes. A run ends "
            "at 200000 evaluations, of mpmath at 20000, for each takes it long. Boost.odeint, "
            "GSL, SUNDIALS, SciPy and mpmath answer where they are installed.";
        return of;
    }();
    return result;
}

const study& stiff_solvers() {
    using namespace solvers_study;
    static const study result = [] {
        study of = study_of(stiff_choices(), "stiff problems of the reference set", "stiff_b1", "gsl");
        of.name = "stiff_solvers";
        of.title = "Solvers of stiff initial value problems, judged";
        of.question =
            "How many digits do implicit solvers deliver of stiff problems, and for how many evaluations of the right "
            "sides?";
        of.reading =
            "Digits against the number of evaluations, those for the Jacobian among them, one panel a problem, one "
            "curve a method: a point for each tolerance. The error is the largest over eleven times, each twice or ten "
            "times the one before, and all unknowns, measured from proved values, each unknown by its largest value; "
            "the absolute tolerance of an unknown is relative to the same. A method without a point gave up, or took "
            "more than 200000 evaluations. GSL, SUNDIALS and SciPy answer where they are installed.";
        return of;
    }();
    return result;
}

}  // namespace libration::studies
