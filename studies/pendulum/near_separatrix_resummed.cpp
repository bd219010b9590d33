// How accurate is the resummation for a pendulum that almost stops upside down? [paper fig:librationapproximant]
#include "extension.hpp"

namespace libration::studies {

const study& near_separatrix_resummed() {
    static const study result{
        .name = "near_separatrix_resummed",
        .title = "The resummation near the separatrix",
        .label = "fig:librationapproximant",
        .question = "How well does the resummation follow a pendulum that almost stops upside down?",
        .reading =
            "Solid: the resummation with the last index N of the same series, which has the right angle and speed at "
            "the bottom too, extended periodically; thin line: the exact solution; circles: the numerical solution by "
            "the Runge-Kutta method in double. No jump is left, the error is largest in between, and at N = 20 it is "
            "{{max error of near_separatrix_series where order=20 / max error of near_separatrix_resummed where "
            "order=20 to 2}} times smaller than that of the series: compare with the study near_separatrix_series, "
            "which has the same energy and orders.",
        .of = &pendulum_problem(),
        .parameters = extension_parameters("1.9998", "5,10,20", "N, last index of the resummed series"),
        .quick = {{"--energies", "1.9998", ""},
                  {"--orders", "5", ""},
                  {"--times", "0:T:9", ""},
                  {"--step", "1e-3", ""}},
        .seconds = 0.6,
        .excluded = without_period(),
        .plan = [](const study_request& request) {
            return plan_of_extension(pendulum::arc_method::resummed, request);
        }};
    return result;
}

}  // namespace libration::studies
