// The templates of the header for the scalars that round.
#include "libration/pendulum/coefficients.hpp"

namespace libration::pendulum {

#define LIBRATION_DEFINE(T)                                                                              \
    template series::power_series<T> taylor_by_sine_cosine(const taylor_start<T>&, int, const T&);       \
    template series::power_series<T> taylor_by_symmetric_squares(const taylor_start<T>&, int, const T&); \
    template taylor_start<T> start_at(const exact_solution<T>&, const phase<T>&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::pendulum
