// Lists whose coefficients grow or fall faster than any power, and lists that no linear equation describes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::convergence {

/// The orders s in {1/6, 1/3, 1/2, 2/3, 1, 4/3, 3/2, 2, 3, 4} near |gamma|, the nearest first, at most four.
std::vector<rational> gevrey_orders_near(double gamma);

/// b_k/Gamma(1 + s k) for s > 0, b_k Gamma(1 - s k) for s < 0, in `bits` bits.
std::vector<mpfr> without_factorials(std::span<const mpfr> b, const rational& s, long bits);

/// Whether the first 60 % of the list grow with a gamma within a factor 1.6 of it.
bool is_steady_growth(std::span<const mpfr> b, double gamma);

/// log R and its uncertainty.
struct size_envelope {
    double log_radius, uncertainty;
};

/// From the largest |a_n| alone: the median of four forms of log|a_n| fitted to the upper points of three parts of the
/// list, or the largest |a_n|^(1/n) if fewer than six coefficients are nonzero.
std::optional<size_envelope> envelope_of(std::span<const mpfr> a);

}  // namespace libration::convergence
