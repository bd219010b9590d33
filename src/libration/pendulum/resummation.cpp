// The templates of the header for the scalars that round.
#include "libration/pendulum/resummation.hpp"

namespace libration::pendulum {

#define LIBRATION_DEFINE(T)                                                                  \
    template fundamental_arc<T> arc_of(const motion&, const period_rule&);                   \
    template series::power_series<T> arc_series(const fundamental_arc<T>&, int, recurrence); \
    template series::power_series<T> arc_series(const fundamental_arc<T>&, int);             \
    template endpoint_approximant<T> resummation_from_top(const fundamental_arc<T>&, int);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::pendulum
