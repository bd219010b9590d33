// The templates of the header for the scalars that round.
#include "libration/pendulum/uniform_resummation.hpp"

namespace libration::pendulum {

#define LIBRATION_DEFINE(T) template uniform_resummation<T> uniform_from_top(const motion&, int, int);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::pendulum
