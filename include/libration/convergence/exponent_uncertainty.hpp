// The uncertainty of an exponent that is determined together with a radius.
#pragma once

#include <algorithm>
#include <optional>

#include "libration/convergence/radius_estimate.hpp"
#include "libration/number/exact.hpp"

namespace libration::convergence {

/// Whether an estimate is certain to N^-p of the radius. For coefficients of the form that its test assumes this holds
/// for any p as N grows; with corrections by logarithms or by other powers it does not.
template <rounding_scalar T>
bool is_certain_to_power(const radius_estimate<T>& estimate, const list_quality<T>& list, int p) {
    if (!estimate.radius || list.order < 1) {
        return false;
    }
    T scaled = estimate.uncertainty / *estimate.radius;
    for (int i = 0; i < p; ++i) {
        scaled *= list.order;
    }
    return scaled <= 1;
}

/// More certain than slow corrections allow.
template <rounding_scalar T>
bool is_sharp(const radius_estimate<T>& estimate, const list_quality<T>& list) {
    return is_certain_to_power(estimate, list, 4);
}

/// The fraction p/q, q <= most, with the smallest q that is within the uncertainty of the exponent, if there is one.
template <rounding_scalar T>
std::optional<rational> fraction_within(const radius_estimate<T>& estimate, int most) {
    using std::abs;
    for (int q = 1; q <= most; ++q) {
        const rational nearest(nearest_integer(widen(T(*estimate.exponent * q))), q);
        if (abs(T(*estimate.exponent - from_rational<T>(nearest))) <= estimate.exponent_uncertainty) {
            return nearest;
        }
    }
    return std::nullopt;
}

/// Adds to the uncertainty of the exponent that due to the radius. Coefficients near n do not distinguish a relative
/// change delta of the radius from a change n delta of the exponent. Logarithms and other slow corrections hide more:
/// of k/log n in the exponent, k/(n log^2 n) appears in the radius from a straight line through the ratios, and less in
/// that from a curve through them; if the radius is not sharp, n log^2(n) delta is added, calibrated, and 2 n log^3(n)
/// delta if no fraction with a denominator of at most 3 is within that: the exponents of most equations are such
/// fractions, and a local exponent shifted by a logarithm is near one only by chance.
template <rounding_scalar T>
void add_position_to_exponent(radius_estimate<T>& estimate, const list_quality<T>& list) {
    using std::log;
    if (!estimate.radius || !estimate.exponent || list.order < 2) {
        return;
    }
    constexpr int simple_denominator = 3;
    T allowed = estimate.uncertainty / *estimate.radius * list.order;
    const auto allow = [&] { estimate.exponent_uncertainty = std::max(estimate.exponent_uncertainty, allowed); };
    if (is_sharp(estimate, list)) {
        return allow();
    }
    const T logarithm = log(T(list.order));
    allowed *= logarithm * logarithm;
    allow();
    if (!fraction_within(estimate, simple_denominator)) {
        allowed *= logarithm * 2;
        allow();
    }
}

/// The exponent nu as a hypothesis: the fraction p/q, q <= 6, within the uncertainty of the estimate, with the smallest
/// q. Returns std::nullopt if there is none, or if the uncertainty is too large to distinguish such fractions.
template <rounding_scalar T>
std::optional<rational> simple_exponent(const radius_estimate<T>& estimate) {
    constexpr int largest_denominator = 6;
    if (!estimate.exponent || estimate.exponent_uncertainty * (4 * largest_denominator * largest_denominator) > 1) {
        return std::nullopt;
    }
    return fraction_within(estimate, largest_denominator);
}

}  // namespace libration::convergence
