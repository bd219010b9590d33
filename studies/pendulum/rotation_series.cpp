// How accurate is the series from the top, extended periodically, for a rotating pendulum? [paper fig:rotationfixed]
#include "extension.hpp"

namespace libration::studies {

const study& rotation_series() {
    static const study result{
        .name = "rotation_series",
        .title = "The series from the top over two periods of rotation",
        .label = "fig:rotationfixed",
        .question = "How well does the series from the top, extended periodically, follow a rotating pendulum?",
        .reading =
            "Dashed: the series about the top cut after the power N, on half a period T* and continued by its "
            "mirror image and by whole turns; thin line: the exact solution; circles: the numerical solution by "
            "the Runge-Kutta method in double. Only odd powers of the time since the top are there, so that N = 6"
            " is the same as N = 5. The error is largest at the bottom, T* after each top, and falls with N, but "
            "slowly: at this energy T* is 0.92 of the radius of convergence.",
        .of = &pendulum_problem(),
        .parameters = extension_parameters("2.02", "3,6,36", "N, last power of the series"),
        .quick = {{"--energies", "2.02", ""}, {"--orders", "3", ""}, {"--times", "0:T:9", ""}, {"--step", "1e-3", ""}},
        .seconds = 0.4,
        .excluded = without_period(),
        .plan = [](const study_request& request) { return plan_of_extension(pendulum::arc_method::series, request); }};
    return result;
}

}  // namespace libration::studies
