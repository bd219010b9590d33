// theta = 2 asin(k cd(t, k)) and omega = -2 k k' sn/dn in double by the GNU Scientific Library at many times, and how
// long that takes, for the benchmark `trajectory`. GSL is under the GPL: this is a separate program, which shares no
// code with libration and talks to it in text.
//
//   stdin    k k' passes count, then count times, hexadecimal floats
//   stdout   passes lines with the CPU time of one pass over the times, in nanoseconds a time, then count lines "theta
//            omega", hexadecimal floats
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

namespace {

double cpu_nanoseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

}  // namespace

int main() {
    gsl_set_error_handler_off();
    double k = 0;
    double complement = 0;
    int passes = 0;
    std::size_t count = 0;
    if (std::scanf("%la %la %d %zu", &k, &complement, &passes, &count) != 4) {
        return 2;
    }
    std::vector<double> times(count);
    for (double& t : times) {
        if (std::scanf("%la", &t) != 1) {
            return 2;
        }
    }
    std::vector<double> theta(count);
    std::vector<double> omega(count);
    for (int pass = 0; pass < passes; ++pass) {
        const double start = cpu_nanoseconds();
        for (std::size_t i = 0; i < count; ++i) {
            double sn = 0;
            double cn = 0;
            double dn = 0;
            gsl_sf_elljac_e(times[i], k * k, &sn, &cn, &dn);
            theta[i] = 2 * std::asin(k * (cn / dn));
            omega[i] = -2 * k * complement * (sn / dn);
        }
        std::printf("%.6f\n", (cpu_nanoseconds() - start) / static_cast<double>(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::printf("%a %a\n", theta[i], omega[i]);
    }
    return 0;
}
