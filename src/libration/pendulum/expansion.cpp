// The templates of the header for the scalars that round.
#include "libration/pendulum/expansion.hpp"

namespace libration::pendulum {

#define LIBRATION_DEFINE(T)                                                                             \
    template expansion<T> expand_by(recurrence, const exact_solution<T>&, const expansion_point&, int); \
    template expansion<T> expand(const exact_solution<T>&, const expansion_point&, int);                \
    template std::vector<T> coefficients_about(const exact_solution<T>&, const expansion_point&, const T&, long, long);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::pendulum
