// The names of the functions of formulas and equations.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace libration {

/// The functions of formulas and equations; described in function/NAME.hpp.
enum class function_kind {
    exp,
    log,
    sqrt,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    sinh,
    cosh,
    tanh,
    asinh,
    acosh,
    atanh,
    log10,
    log2,
    exp2,
    cbrt,
    sinc,
    expm1,
    log1p,
    erf,
    erfc,
    bessel_j,
    bessel_y,
    bessel_i,
    bessel_k,
    airy_ai,
    airy_ai_prime,
    airy_bi,
    airy_bi_prime,
    lambertw,
    exprel,
    cosrel
};
inline constexpr std::size_t function_kinds = 35;

/// The function with this name, for example "exp", and the name of a function.
std::optional<function_kind> function_named(std::string_view name);
std::string_view name_of(function_kind f);
/// All names, separated by blanks.
std::string function_names();
/// Whether it takes a constant order before its argument: bessel_j(0, x).
bool has_order(function_kind f);

}  // namespace libration
