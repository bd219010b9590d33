// How accurate is the series from the top, extended periodically, for a librating pendulum? [paper fig:librationfixed]
#include "extension.hpp"

namespace libration::studies {

const study& libration_series() {
    static const study result{
        .name = "libration_series",
        .title = "The series from the top over two periods of libration",
        .label = "fig:librationfixed",
        .question = "How well does the series from the top, extended periodically, follow a swinging pendulum?",
        .reading =
            "Dashed: the series about the top cut after the power N, on a quarter of a period T* and mirrored "
            "from there; thin line: the exact solution; circles: the numerical solution by the Runge-Kutta method"
            " in double. The error is largest at the passages through the bottom, T* after each top, where the "
            "pieces meet with a jump: {{max error of libration_series where order=2 to 2}} radians for N = 2, "
            "{{max error of libration_series where order=4 to 2}} for N = 4 and "
            "{{max error of libration_series where order=6 to 2}} for N = 6. The panel below "
            "shows that error over time, and how small that of the numerical solution is beside it.",
        .of = &pendulum_problem(),
        .parameters = extension_parameters("1.71", "2,4,6", "N, last power of the series"),
        .quick = {{"--energies", "1.71", ""}, {"--orders", "2", ""}, {"--times", "0:T:9", ""}, {"--step", "1e-3", ""}},
        .seconds = 0.4,
        .excluded = without_period(),
        .plan = [](const study_request& request) { return plan_of_extension(pendulum::arc_method::series, request); }};
    return result;
}

}  // namespace libration::studies
