// theta = 2 asin(k cd(t, k)) in double by the GNU Scientific Library, for the study audit_gsl. GSL is under the GPL:
// this is a separate program, which shares no code with libration and talks to it in text.
//
//   stdin    lines "k t", hexadecimal floats
//   stdout   a line with theta for each, nan where GSL fails
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>

#include <cmath>
#include <cstdio>

int main() {
    gsl_set_error_handler_off();
    double k = 0;
    double t = 0;
    while (std::scanf("%la %la", &k, &t) == 2) {
        double sn = 0;
        double cn = 0;
        double dn = 0;
        const bool done = gsl_sf_elljac_e(t, k * k, &sn, &cn, &dn) == GSL_SUCCESS;
        std::printf("%a\n", done ? 2 * std::asin(k * (cn / dn)) : std::nan(""));
    }
    return 0;
}
