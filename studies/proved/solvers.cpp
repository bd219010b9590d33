// How many digits do solvers of initial value problems deliver, and for how many evaluations of the right-hand side?
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

const proved::solver_choices& choices() {
    static const proved::solver_choices result(
        proved::choice_of_problems("write names such as lorenz,kepler, or all", problems()),
        proved::choice_of_solvers("LIST of odeint, gsl, sundials, scipy and mpmath, or all",
                                  "write names such as odeint,gsl, or all",
                                  members_of(proved::solver_peers(), &proved::solver_peer::name)));
    return result;
}

}  // namespace
}  // namespace solvers_study

const study& solvers() {
    using namespace solvers_study;
    static const study result{
        .name = "solvers",
        .title = "Solvers of initial value problems, judged",
        .question =
            "How many digits do solvers of initial value problems deliver, and for how many evaluations of the right "
            "sides?",
        .reading =
            "Digits against the number of evaluations, one panel a problem, one curve a method: a point for each "
            "tolerance that was asked. The error is the largest over eight times and all unknowns, measured from "
            "proved values, each unknown by its largest value. Solvers work in double and are handed starts and "
            "parameters that are rounded to it; dotted is the error, to first order, that this alone makes. A run ends "
            "at 200000 evaluations, of mpmath at 20000, for each takes it long. Boost.odeint, "
            "GSL, SUNDIALS, SciPy and mpmath answer where they are installed.",
        .of = &choices().family(),
        .parameters = {{"--problems", "all", "twenty problems of the reference set"},
                       {"--solvers", "all", "libraries"},
                       {"--tolerances", "1e-3,1e-5,1e-7,1e-9,1e-11,1e-13", "relative and absolute"}},
        .quick = {{"--problems", "logistic", ""}, {"--solvers", "odeint", ""}, {"--tolerances", "1e-4,1e-8", ""}},
        .seconds = 300,
        .plan = [](const study_request& request) { return choices().plan(request); },
        .offers = arithmetics::proved_too};
    return result;
}

}  // namespace libration::studies
