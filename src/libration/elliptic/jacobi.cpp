// The templates of the header for the rounding scalars.
#include "libration/elliptic/jacobi.hpp"

namespace libration::elliptic {

#define LIBRATION_DEFINE(T) template jacobi_values<T> jacobi_at(const T&, const landen_chain<T>&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::elliptic
