// The templates of the header for the rounding scalars.
#include "libration/elliptic/incomplete_integral.hpp"

namespace libration::elliptic {

#define LIBRATION_DEFINE(T) template T incomplete_integral(const T&, const T&, const landen_chain<T>&);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DEFINE)
#undef LIBRATION_DEFINE

}  // namespace libration::elliptic
