// The result of a test that fits recurrences: its radius, its exponent, the number of singularities on the circle, and
// the uncertainties that follow from how the roots move.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/fitted_singularities.hpp"

namespace libration::convergence {

namespace fitting {

/// The number of roots, ordered by distance, that are on the circle of the nearest one; roots that are not resolved, as
/// those that a fit produces for a confluent singularity, count as one. `certain` is the error of the nearest one, and
/// `safety` times the errors is allowed.
inline int number_on_circle(const std::vector<fitted_singularity>& roots, const mpfr& certain, const mpfr& safety) {
    const mpfr radius = modulus_of(roots.front().at);
    std::vector<complex_number<mpfr>> counted;
    int count = 0;
    for (const fitted_singularity& each : roots) {
        const mpfr error = (each.moved.likely + certain) * safety;
        // Spurious roots may lie near the circle too, but they do not stay there: half of the digits are required.
        const bool stays = each.moved.safe * each.moved.safe <= certain * radius;
        const bool on_circle = abs(modulus_of(each.at) - radius) <= error;
        const bool apart = std::none_of(counted.begin(), counted.end(),
                                        [&](const auto& other) { return modulus_of(other - each.at) <= error; });
        if (stays && on_circle && apart) {
            count += each.at.im * 2 <= error ? 1 : 2;
            counted.push_back(each.at);
        }
    }
    return count;
}

}  // namespace fitting

/// The exponent that the form assumes is known no better than the position allows: a different one moves the root by
/// about 1/K^2 of its size, K the number of coefficients.
inline mpfr uncertainty_of_assumption(const fitted_singularity& found, int count) {
    return found.moved.likely / modulus_of(found.at) * count * count;
}

/// The result of a test that fits recurrences of one form, in the variable x. The uncertainty is four times the
/// estimated remaining error, a factor chosen on the half "calibration" of the study radius_tournament, plus a rounding
/// of the coefficients. A verdict uses three times that of a form that assumes the exponent, unless six digits are
/// certain: for a singularity that is neither a pole nor a logarithm, such a form converges slowly.
template <rounding_scalar T>
radius_estimate<T> estimate_by_recurrence(const std::string& method, const strided_series<T>& c,
                                          const recurrence_form& form) {
    constexpr int safety = 4;
    constexpr long guard_digits = 20;
    const int needed = coefficients_needed(form, 1);
    if (c.last() + 1 < needed) {
        return too_short<T>(method, needed, c.last() + 1);
    }
    const T rounding = epsilon<T>();
    std::optional<fitted_singularities> found;
    {
        const precision_scope scope(decimal_digits(digits<T>()) + guard_digits);
        found = nearest_singularities(fitting::widened(c), form, widen(rounding));
    }
    if (!found) {
        return no_estimate<T>(method, "no degree of its recurrence has a root that settles");
    }
    const auto in_scalar = [](const mpfr& x) { return narrow<T>(x); };
    const fitted_singularity& first = found->nearest.front();
    radius_estimate<T> result;
    result.method = method;
    result.position = complex_number<T>{in_scalar(first.at.re), in_scalar(first.at.im)};
    const mpfr radius = modulus_of(first.at);
    result.exponent_assumed = form.highest == form.lowest;
    const int caution = result.exponent_assumed && first.moved.likely * 1'000'000 > radius ? 3 : 1;
    result.radius = in_scalar(radius);
    result.uncertainty = (in_scalar(first.moved.likely) * safety + *result.radius * rounding) * caution;
    if (result.uncertainty >= *result.radius) {
        return no_estimate<T>(method, "its roots do not settle");
    }
    result.nearer = in_scalar(found->nearer);
    const int count = c.last() + 1;
    const mpfr exponent_moved = std::max(first.exponent_moved, mpfr(first.exponent_sensitivity * first.moved.likely));
    result.exponent = in_scalar(first.exponent);
    result.exponent_uncertainty =
        in_scalar(result.exponent_assumed ? uncertainty_of_assumption(first, count) : exponent_moved) * safety +
        rounding * count;
    const mpfr certain = first.moved.likely + radius * widen(rounding);
    result.count = fitting::number_on_circle(found->nearest, certain, mpfr(safety));
    if (first.at.im * 2 <= (first.moved.likely + certain) * safety) {
        result.position->im = T(0);
    }
    result.note = "denominator of degree " + std::to_string(found->degree);
    return in_variable(std::move(result), c.stride());
}

}  // namespace libration::convergence
