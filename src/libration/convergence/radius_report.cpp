// The templates of the header for the rounding scalars.
#include "libration/convergence/radius_report.hpp"

namespace libration::convergence {

#define LIBRATION_DEFINE(T) template radius_report<T> report_on_radius(const series::power_series<T>&, const T&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::convergence
