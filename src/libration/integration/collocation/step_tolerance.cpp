#include "step_tolerance.hpp"

#include <algorithm>
#include <limits>

namespace libration::ode {

namespace {

// The binary exponent of the smallest number of a type with all digits, also of a sum with it.
template <class T>
constexpr long least_scale_of() {
    return std::numeric_limits<T>::min_exponent + std::numeric_limits<T>::digits;
}

}  // namespace

template <>
step_tolerance step_tolerance::of<double>() {
    return {15.2, 16.6, 18, least_scale_of<double>()};
}
template <>
step_tolerance step_tolerance::of<long double>() {
    return {16.5, 18, 20, least_scale_of<long double>()};
}
template <>
step_tolerance step_tolerance::of<quad>() {
    return {30, 32, 36, least_scale_of<long double>()};
}
template <>
step_tolerance step_tolerance::of<mpfr>() {
    const double aimed = std::max(12., static_cast<double>(working_digits()) - 3);
    return {aimed - 4, aimed, std::max(18, static_cast<int>(1.3 * aimed)), least_scale_of<long double>()};
}

}  // namespace libration::ode
