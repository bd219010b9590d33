// The amplitude of a singularity on the positive or negative real axis.
#pragma once

#include <optional>
#include <span>

#include "libration/convergence/verdict.hpp"

namespace libration::convergence {

/// A of f ~ A (1 - x/x0)^t, for a logarithm of A (1 - x/x0)^t log(1 - x/x0), where x0 is the only singularity on the circle
/// of convergence of f = sum b_k x^k: the limit of b_k/c_k, c_k the coefficients of the function with A = 1, by Neville's
/// extrapolation in 1/k of the order 0 .. 6 whose last two values differ least. The uncertainty is the larger of four
/// times the difference to the neighbouring orders and the effect of the uncertainties of x0 and t. std::nullopt if that
/// is not smaller than |A|, or if t is not negative, an integer and no logarithm.
std::optional<exponent_estimate> amplitude_of(std::span<const mpfr> b, const exponent_estimate& position,
                                              const exponent_estimate& exponent, bool is_logarithm);

}  // namespace libration::convergence
