// The templates of the header for the scalars that round.
#include "libration/pendulum/arc/resummation.hpp"

namespace libration {

#define LIBRATION_DEFINE(T)                                                      \
    template descent<T> descent_of(const motion&, const period_rule&);           \
    template power_series<T> descent_series(const descent<T>&, int, recurrence); \
    template power_series<T> descent_series(const descent<T>&, int);             \
    template endpoint_approximant<T> resummation_from_top(const descent<T>&, int);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration
