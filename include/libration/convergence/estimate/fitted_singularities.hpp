// The nearest singularities as roots of fitted recurrences, each with an exponent and an estimate of its error.
//
// The systems are solved in twice the digits of the coefficients and 40 more, for they lose digits with every
// degree. What a recurrence leaves out and what rounding in the coefficients themselves spoils shows in the
// uncertainty: every root is compared with those from the list without its last one, its last two and so on up to
// its last quarter of coefficients.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/estimate/followed_root.hpp"
#include "libration/convergence/estimate/recurrence_fit.hpp"

namespace libration::convergence {

/// A root w of Q_highest with im >= 0, the exponent of f there, and how far both moved with the last coefficients.
struct fitted_singularity {
    complex_number<mpfr> at;
    mpfr exponent;
    fitting::leftover moved;
    mpfr exponent_moved;
};

/// The nearest singularities of one fit by growing modulus, the first one defining the radius in w.
struct fitted_singularities {
    int degree = 0;  ///< M
    std::vector<fitted_singularity> nearest;
};

namespace fitting {

/// nu at a root w of Q_d: d - 1 - Q_{d-1}/(stride w Q_d'); d - 1 for a recurrence with one power of n.
inline mpfr exponent_at(const leading_polynomials& q, const complex_number<mpfr>& w, const recurrence_form& form,
                        int stride) {
    if (form.highest == form.lowest) {
        mpfr assumed(form.highest - 1);
        return assumed;
    }
    const auto above = evaluate(q.below, w).value;
    const auto below = w * evaluate(q.top, w).slope * mpfr(stride);
    return form.highest - 1 - (above / below).re;
}

/// A root followed through the recurrences from fewer coefficients. Nothing where one of them has no root near.
inline std::optional<fitted_singularity> followed(const std::vector<leading_polynomials>& fits,
                                                  complex_number<mpfr> start, const recurrence_form& form, int stride,
                                                  int s) {
    std::vector<complex_number<mpfr>> at;
    std::vector<complex_number<mpfr>> exponents;
    for (const auto& q : fits) {
        const auto root = polished(q.top, start);
        if (!root) {
            return std::nullopt;
        }
        start = *root;
        at.push_back(*root);
        exponents.push_back({exponent_at(q, *root, form, stride)});
    }
    return fitted_singularity{at[0], exponents[0].re, left_after(at, s), left_after(exponents, s).likely};
}

/// The singularities of one degree: the root nearest to 0 and the others no further than a tenth more.
inline std::optional<fitted_singularities> singularities_of_degree(const wide_series& series,
                                                                   const recurrence_form& form, int degree) {
    const auto count = static_cast<int>(series.c.size());
    const auto fewer = fewer_coefficients(count, coefficients_needed(form, degree) - 4);
    std::vector<leading_polynomials> fits;
    for (const int without : fewer) {
        auto fit = fit_recurrence(series, form, degree, count - 1 - without);
        if (!fit) {
            return std::nullopt;
        }
        fits.push_back(*std::move(fit));
    }
    fitted_singularities found{degree, {}};
    const auto starts = starting_roots(fits[0].top);
    for (const auto& start : starts) {
        if (modulus_of(start) * 10 > modulus_of(starts.front()) * 11) {
            break;
        }
        auto singularity = followed(fits, start, form, series.stride, fewer[4]);
        if (!singularity && found.nearest.empty()) {
            return std::nullopt;
        }
        if (singularity) {
            found.nearest.push_back(*std::move(singularity));
        }
    }
    return found.nearest.empty() ? std::nullopt : std::optional(std::move(found));
}

/// Where few digits are certain, steps may be small by chance: the error is then thought to be four times what the
/// steps say, or four times the distance from the root of the next degree on either side, whichever is nearer.
inline void compare_with_neighbours(std::vector<fitted_singularities>& all, std::size_t best) {
    constexpr int few_digits = 1'000'000;
    fitted_singularity& first = all[best].nearest.front();
    if (first.moved.safe * few_digits < modulus_of(first.at) || all.size() == 1) {
        return;
    }
    std::optional<mpfr> nearest;
    for (const std::size_t other : {best - 1, best + 1}) {
        if (other < all.size()) {  // best - 1 wraps around at 0
            const mpfr apart = modulus_of(all[other].nearest.front().at - first.at);
            nearest = nearest && *nearest < apart ? *nearest : apart;
        }
    }
    first.moved.likely = std::max(first.moved.likely, *nearest) * 4;
}

}  // namespace fitting

/// The nearest singularities by the degree whose root is the most certain, among those whose system has at most 64
/// unknowns, as far as the coefficients go; degrees grow more and more thinly, and growing ends where five in turn do
/// not halve it. Nothing where no degree gives a root that can be followed. Works in the precision of the caller, which
/// should have twice the digits of the coefficients; `fine` is the relative uncertainty that these allow at best.
inline std::optional<fitted_singularities> nearest_singularities(const fitting::wide_series& series,
                                                                 const recurrence_form& form, const mpfr& fine) {
    constexpr int most_unknowns = 64;
    constexpr int most_degree = 40;
    constexpr int patience = 5;
    std::vector<fitted_singularities> all;
    std::size_t best = 0;
    int without_gain = 0;
    const auto relative = [](const fitted_singularities& f) {
        return mpfr(f.nearest.front().moved.safe / modulus_of(f.nearest.front().at));
    };
    const auto fits = [&](int degree) {
        return degree <= most_degree && unknowns_of(form, degree) <= most_unknowns &&
               coefficients_needed(form, degree) <= static_cast<int>(series.c.size());
    };
    for (int degree = 1; fits(degree) && without_gain < patience; degree += 1 + degree / 6) {
        ++without_gain;
        if (auto now = fitting::singularities_of_degree(series, form, degree)) {
            all.push_back(*std::move(now));
            if (relative(all.back()) <= fine) {
                return all.back();
            }
            if (relative(all.back()) * 2 <= relative(all[best]) || all.size() == 1) {
                without_gain = 0;
            }
            best = relative(all.back()) < relative(all[best]) ? all.size() - 1 : best;
        }
    }
    if (all.empty()) {
        return std::nullopt;
    }
    fitting::compare_with_neighbours(all, best);
    return all[best];
}

/// The answer of a test that fits recurrences of one form, in the variable x. The uncertainty is four times the
/// error that is thought to be left, a factor chosen on the half "calibration" of the study radius_tournament, and
/// a rounding of the coefficients.
template <rounding_scalar T>
radius_estimate<T> estimate_by_recurrence(const std::string& method, const strided_series<T>& c,
                                          const recurrence_form& form) {
    constexpr int safety = 4;
    const int needed = coefficients_needed(form, 1);
    if (c.last() + 1 < needed) {
        return too_short<T>(method, needed, c.last() + 1);
    }
    const T rounding = epsilon<T>();
    std::optional<fitted_singularities> found;
    {
        const precision_scope scope(2 * decimal_digits(digits<T>()) + 40);
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
    result.radius = in_scalar(radius);
    result.uncertainty = in_scalar(first.moved.likely) * safety + *result.radius * rounding;
    if (result.uncertainty >= *result.radius) {
        return no_estimate<T>(method, "its roots do not settle");
    }
    result.exponent = in_scalar(first.exponent);
    result.exponent_uncertainty = in_scalar(first.exponent_moved) * safety;
    const mpfr certain = first.moved.likely + radius * widen(rounding);
    for (const fitted_singularity& each : found->nearest) {
        // Roots that mean nothing lie near the circle too, but they do not stay: half of the digits are asked for.
        const bool stays = each.moved.safe * each.moved.safe <= certain * radius;
        const bool on_circle = abs(modulus_of(each.at) - radius) <= (each.moved.likely + certain) * safety;
        result.count += stays && on_circle ? (each.at.im == 0 ? 1 : 2) : 0;
    }
    result.note = "denominator of degree " + std::to_string(found->degree);
    return in_variable(std::move(result), c.stride());
}

}  // namespace libration::convergence
