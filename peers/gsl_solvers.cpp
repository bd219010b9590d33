// Initial value problems in double by the GNU Scientific Library, for the study `solvers`: see equation_code.hpp. GSL
// is under the GPL: this is a separate program.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>

#include <memory>

#include "equation_code.hpp"

namespace {

int slopes(double t, const double y[], double out[], void* of) {
    return static_cast<peers::equations*>(of)->slopes(t, y, out) ? GSL_SUCCESS : GSL_EBADFUNC;
}

int jacobian(double t, const double y[], double* by_state, double by_time[], void* of) {
    return static_cast<peers::equations*>(of)->jacobian(t, y, by_state, by_time) ? GSL_SUCCESS : GSL_EBADFUNC;
}

void solve(peers::equations& of, const std::string& method, double tolerance, std::vector<double>& values) {
    const gsl_odeiv2_step_type* const type = method == "rk8pd"     ? gsl_odeiv2_step_rk8pd
                                             : method == "rkf45"   ? gsl_odeiv2_step_rkf45
                                             : method == "msadams" ? gsl_odeiv2_step_msadams
                                             : method == "msbdf"   ? gsl_odeiv2_step_msbdf
                                                                   : nullptr;
    if (type == nullptr) {
        throw peers::no_answer();
    }
    gsl_odeiv2_system system{slopes, jacobian, of.size(), &of};
    const double first = (of.times.front() - of.begin) * 1e-3;
    const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
        gsl_odeiv2_driver_alloc_scaled_new(&system, type, first, tolerance, tolerance, 1, 0, of.scale.data()),
        gsl_odeiv2_driver_free);
    double t = of.begin;
    std::vector<double> y = of.start;
    for (const double end : of.times) {
        if (gsl_odeiv2_driver_apply(driver.get(), &t, end, y.data()) != GSL_SUCCESS) {
            throw peers::no_answer();
        }
        values.insert(values.end(), y.begin(), y.end());
    }
}

}  // namespace

int main() {
    gsl_set_error_handler_off();
    return peers::answer("GSL " GSL_VERSION, solve);
}
