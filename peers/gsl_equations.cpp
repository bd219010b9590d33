// Initial value problems in double by the Runge-Kutta method of Prince and Dormand of order 8 (rk8pd) of the GNU
// Scientific Library, and how long that takes, for the benchmark `equations`. GSL is under the GPL: this is a program
// of its own, which shares no code with libration and talks to it in text.
//
//   stdin    problem tolerance passes end count, then count starts: x, x', y, y', ...
//   stdout   the CPU time of one pass in nanoseconds, then count values at the end, hexadecimal floats
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <vector>

namespace {

double cpu_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

int lorenz(double /*t*/, const double x[], double slope[], void* /*unused*/) {
    slope[0] = 10 * (x[1] - x[0]);
    slope[1] = x[0] * (28 - x[2]) - x[1];
    slope[2] = x[0] * x[1] - 8 * x[2] / 3;
    return GSL_SUCCESS;
}

int kepler(double /*t*/, const double x[], double slope[], void* /*unused*/) {
    const double square = x[0] * x[0] + x[2] * x[2];
    const double cube = square * std::sqrt(square);
    slope[0] = x[1];
    slope[1] = -x[0] / cube;
    slope[2] = x[3];
    slope[3] = -x[2] / cube;
    return GSL_SUCCESS;
}

int pendulum(double /*t*/, const double x[], double slope[], void* /*unused*/) {
    slope[0] = x[1];
    slope[1] = -std::sin(x[0]);
    return GSL_SUCCESS;
}

int four_body(double /*t*/, const double x[], double slope[], void* /*unused*/) {
    for (int i = 0; i < 16; i += 2) {
        slope[i] = x[i + 1];
        slope[i + 1] = 0;
    }
    for (int i = 0; i < 16; i += 4) {
        for (int j = i + 4; j < 16; j += 4) {
            const double dx = x[j] - x[i];
            const double dy = x[j + 2] - x[i + 2];
            const double square = dx * dx + dy * dy;
            const double cube = square * std::sqrt(square);
            slope[i + 1] += dx / cube;
            slope[i + 3] += dy / cube;
            slope[j + 1] -= dx / cube;
            slope[j + 3] -= dy / cube;
        }
    }
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
    if (std::scanf("%31s %la %d %la %zu", name, &tolerance, &passes, &end, &count) != 5) {
        return 2;
    }
    std::vector<double> start(count);
    for (double& each : start) {
        if (std::scanf("%la", &each) != 1) {
            return 2;
        }
    }
    const auto slope = std::strcmp(name, "lorenz") == 0     ? lorenz
                       : std::strcmp(name, "kepler") == 0   ? kepler
                       : std::strcmp(name, "pendulum") == 0 ? pendulum
                                                            : four_body;
    gsl_odeiv2_system system{slope, nullptr, count, nullptr};
    gsl_odeiv2_driver* const driver =
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, tolerance, tolerance);
    std::vector<double> x;
    const double begin = cpu_nanoseconds();
    for (int pass = 0; pass < passes; ++pass) {
        x = start;
        double t = 0;
        gsl_odeiv2_driver_reset_hstart(driver, 1e-3);
        if (gsl_odeiv2_driver_apply(driver, &t, end, x.data()) != GSL_SUCCESS) {
            return 1;
        }
    }
    std::printf("%.6f\n", (cpu_nanoseconds() - begin) / passes);
    for (const double each : x) {
        std::printf("%a\n", each);
    }
    gsl_odeiv2_driver_free(driver);
    return 0;
}
