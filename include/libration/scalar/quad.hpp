// The scalar `quad`: IEEE binary128, 113 bits. __float128 through Boost if libquadmath is available (GCC), and
// otherwise Boost's software cpp_bin_float_quad, which has the same precision and exponent range.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && __has_include(<quadmath.h>)
#define LIBRATION_HAS_FLOAT128 1
#include <boost/multiprecision/float128.hpp>
#else
#define LIBRATION_HAS_FLOAT128 0
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace libration {

#if LIBRATION_HAS_FLOAT128
using quad = boost::multiprecision::number<boost::multiprecision::float128_backend, boost::multiprecision::et_off>;
#else
using quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
#endif

}  // namespace libration
