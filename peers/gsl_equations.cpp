// Initial value problems in double by the Runge-Kutta method of Prince and Dormand of order 8 (rk8pd) of the GNU
// Scientific Library, and how long that takes, for the benchmark `equations`. GSL is under the GPL: this is a separate
// program, which shares no code with the library and talks to it in text.
//
//   stdin    problem tolerance passes end count solutions, then the starts of each: count numbers x, x', y, y', ...
//   stdout   the CPU time of one pass over all solutions in nanoseconds, then their values at the end, hexadecimal floats
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <vector>

#include "slopes.hpp"

namespace {

double cpu_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

template <peers::slope_function<double> slope_of>
int slopes(double /*t*/, const double x[], double out[], void* /*unused*/) {
    slope_of(x, out);
    return GSL_SUCCESS;
}

}  // namespace

int main() {
    gsl_set_error_handler_off();
    char name[32] = "";
    double tolerance = 0;
    int passes = 0;
    double end = 0;
    std::size_t count = 0;
    std::size_t solutions = 0;
    if (std::scanf("%31s %la %d %la %zu %zu", name, &tolerance, &passes, &end, &count, &solutions) != 6) {
        return 2;
    }
    std::vector<double> start(count * solutions);
    for (double& each : start) {
        if (std::scanf("%la", &each) != 1) {
            return 2;
        }
    }
    const auto of_problem = std::strcmp(name, "lorenz") == 0     ? slopes<peers::lorenz<double>>
                            : std::strcmp(name, "kepler") == 0   ? slopes<peers::kepler<double>>
                            : std::strcmp(name, "pendulum") == 0 ? slopes<peers::pendulum<double>>
                                                                 : slopes<peers::four_body<double>>;
    gsl_odeiv2_system system{of_problem, nullptr, count, nullptr};
    gsl_odeiv2_driver* const driver =
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, tolerance, tolerance);
    std::vector<double> x;
    const double begin = cpu_nanoseconds();
    for (int pass = 0; pass < passes; ++pass) {
        x = start;
        for (std::size_t i = 0; i < solutions; ++i) {
            double t = 0;
            gsl_odeiv2_driver_reset_hstart(driver, 1e-3);
            if (gsl_odeiv2_driver_apply(driver, &t, end, x.data() + i * count) != GSL_SUCCESS) {
                return 1;
            }
        }
    }
    std::printf("%.6f\n", (cpu_nanoseconds() - begin) / passes);
    for (const double each : x) {
        std::printf("%a\n", each);
    }
    gsl_odeiv2_driver_free(driver);
    return 0;
}
