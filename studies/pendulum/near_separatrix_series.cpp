// How accurate is the series from the top for a pendulum that almost stops upside down? [paper fig:librationseries]
#include "extension.hpp"

namespace libration::studies {

const study& near_separatrix_series() {
    static const study result{
        .name = "near_separatrix_series",
        .title = "The series from the top near the separatrix",
        .label = "fig:librationseries",
        .question = "How well does the series from the top follow a pendulum that almost stops upside down?",
        .reading =
            "Dashed: the series about the top cut after the power N, on a quarter of a period T* and mirrored from "
            "there; thin line: the exact solution; circles: the numerical solution by the Runge-Kutta method in "
            "double. So near to the separatrix the pendulum spends most of its time close to the top, and T* is 0.97 "
            "of the radius of convergence: the error at the bottom is "
            "{{max error of near_separatrix_series where order=5 to 2}} radians for N = 5 and still "
            "{{max error of near_separatrix_series where order=20 to 2}} for N = 20. "
            "The study near_separatrix_resummed shows what the resummation makes of the same coefficients.",
        .of = &pendulum_problem(),
        .parameters = extension_parameters("1.9998", "5,10,20", "N, last power of the series"),
        .quick = {{"--energies", "1.9998", ""},
                  {"--orders", "5", ""},
                  {"--times", "0:T:9", ""},
                  {"--step", "1e-3", ""}},
        .seconds = 0.6,
        .excluded = without_period(),
        .plan = [](const study_request& request) { return plan_of_extension(pendulum::arc_method::series, request); }};
    return result;
}

}  // namespace libration::studies
