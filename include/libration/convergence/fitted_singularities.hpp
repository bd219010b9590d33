// The nearest singularities as roots of fitted recurrences, each with an exponent and an estimate of its error.
//
// The systems are solved in twice the digits of the coefficients and 40 more, for they lose digits with every degree. What a
// recurrence leaves out and what rounding in the coefficients themselves spoils shows in the uncertainty: every root is
// compared with those from the list without its last one, its last two and so on up to its last quarter of coefficients.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/recurrence_fit.hpp"
#include "libration/series/polynomial_roots.hpp"

namespace libration {

/// A root w of Q_highest with im >= 0, the exponent of f there, and how far both moved with the last coefficients.
struct fitted_singularity {
    complex_number<mpfr> at;
    mpfr exponent;
    mpfr moved;
    mpfr exponent_moved;
};

/// The nearest singularities of one fit by growing modulus, the first one defining the radius in w.
struct fitted_singularities {
    int degree = 0;  ///< M
    std::vector<fitted_singularity> nearest;
};

namespace fitting {

/// Newton's iteration for a root of p from a good start; nothing where it does not settle. A real start stays real.
inline std::optional<complex_number<mpfr>> polished(const power_series<mpfr>& p, complex_number<mpfr> z) {
    constexpr int most_steps = 60;
    const mpfr fine = epsilon<mpfr>() * 16;
    for (int step = 0; step < most_steps; ++step) {
        const auto at = evaluate(p, z);
        if (modulus_of(at.slope) == 0) {
            return std::nullopt;
        }
        const auto by = at.value / at.slope;
        z = z - by;
        if (modulus_of(by) <= modulus_of(z) * fine || modulus_of(at.value) <= at.rounding) {
            return z;
        }
    }
    return std::nullopt;
}

/// Roots with im >= 0 by growing modulus, as starts for Newton, found in the arithmetic S. Nothing where S does not tell
/// every root to a thousandth of its size, or a conjugate pair from two real ones.
template <rounding_scalar S>
std::optional<std::vector<complex_number<mpfr>>> roots_in(const power_series<mpfr>& p) {
    auto rounded = power_series<S>::zero(p.order());
    for (int j = 0; j <= p.order(); ++j) {
        rounded[j] = narrow<S>(p[j]);
    }
    if (rounded[rounded.order()] == 0) {
        return std::nullopt;
    }
    std::vector<complex_number<mpfr>> upper;
    std::size_t seen = 0;
    for (const auto& root : roots_of(rounded).all) {
        using std::abs;
        if (root.error_bound * 1000 > modulus_of(root.at)) {
            return std::nullopt;
        }
        const bool real = abs(root.at.im) <= root.error_bound;
        if (real || root.at.im > 0) {
            upper.push_back({widen(root.at.re), real ? mpfr(0) : widen(root.at.im)});
            seen += real ? 1 : 2;
        }
    }
    if (seen != static_cast<std::size_t>(p.order())) {
        return std::nullopt;
    }
    std::sort(upper.begin(), upper.end(), [](const auto& a, const auto& b) { return modulus_of(a) < modulus_of(b); });
    return upper;
}

/// The same in long double, or in 40 digits where that does not do; none where these do not do either.
inline std::vector<complex_number<mpfr>> starting_roots(const power_series<mpfr>& p) {
    auto found = roots_in<long double>(p);
    if (!found) {
        const precision_scope scope(40);
        found = roots_in<mpfr>(p);
    }
    return found ? *std::move(found) : std::vector<complex_number<mpfr>>{};
}

/// nu at a root w of Q_d: d - 1 - Q_{d-1}/(stride w Q_d'); d - 1 for a recurrence with one power of n.
inline mpfr exponent_at(const leading_polynomials& q, const complex_number<mpfr>& w, const recurrence_form& form,
                        int stride) {
    if (form.highest == form.lowest) {
        return mpfr(form.highest - 1);
    }
    const auto above = evaluate(q.below, w).value;
    const auto below = w * evaluate(q.top, w).slope * mpfr(stride);
    return form.highest - 1 - (above / below).re;
}

/// The lists that a root is followed through, by how many coefficients they have less: 0, 1, 2, 3, then s and 2 s, s an
/// eighth of all or what the degree can spare.
inline std::vector<int> fewer_coefficients(int count, int needed) {
    const int eighth = std::max(2, std::min(count / 8, (count - needed) / 2));
    return {0, 1, 2, 3, eighth, 2 * eighth};
}

/// The error of a value x_0 from x_1, x_2, ... with the fewer coefficients of fewer_coefficients(). An error that falls like
/// rho^K makes |x_0 - x_s| and |x_0 - x_2s| differ by rho^s: what is left is their continuation |x_0 - x_s|^2/|x_0 - x_2s|, or
/// rounding, as the last steps show. Where the two hardly differ the error falls like a power of 1/K, or it is rounding
/// alone: then 8 |x_0 - x_s|, for s = K/8 the error of a fall like 1/K.
inline mpfr left_after(const std::vector<complex_number<mpfr>>& x) {
    const auto apart = [&](std::size_t i, std::size_t j) { return modulus_of(x[i] - x[j]); };
    std::vector<mpfr> steps{apart(0, 1), apart(1, 2), apart(2, 3)};
    std::sort(steps.begin(), steps.end());
    const mpfr middle = apart(0, 4);
    const mpfr far = apart(0, 5);
    if (far > middle * 6) {
        return std::max(steps[1], mpfr(middle * middle * 2 / far));
    }
    return mpfr(std::max(middle, steps[2]) * 8);
}

/// A root followed through the recurrences from fewer coefficients. Nothing where one of them has no root near.
inline std::optional<fitted_singularity> followed(const std::vector<leading_polynomials>& fits,
                                                  complex_number<mpfr> start, const recurrence_form& form, int stride) {
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
    return fitted_singularity{at[0], exponents[0].re, left_after(at), left_after(exponents)};
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
        auto singularity = followed(fits, start, form, series.stride);
        if (!singularity && found.nearest.empty()) {
            return std::nullopt;
        }
        if (singularity) {
            found.nearest.push_back(*std::move(singularity));
        }
    }
    return found.nearest.empty() ? std::nullopt : std::optional(std::move(found));
}

}  // namespace fitting

/// The nearest singularities by the degree whose root is the most certain, among those whose system has at most 64 unknowns,
/// as far as the coefficients go; degrees grow more and more thinly, and growing ends where five in turn do not halve it.
/// Nothing where no degree gives a root that can be followed. Works in the precision of the caller, which should have
/// twice the digits of the coefficients; `fine` is the relative uncertainty that these allow at best.
inline std::optional<fitted_singularities> nearest_singularities(const fitting::wide_series& series,
                                                                 const recurrence_form& form, const mpfr& fine) {
    constexpr int most_unknowns = 64;
    constexpr int most_degree = 40;
    constexpr int patience = 5;
    std::optional<fitted_singularities> best;
    int without_gain = 0;
    const auto relative = [](const fitted_singularities& f) {
        return mpfr(f.nearest.front().moved / modulus_of(f.nearest.front().at));
    };
    const auto fits = [&](int degree) {
        return degree <= most_degree && unknowns_of(form, degree) <= most_unknowns &&
               coefficients_needed(form, degree) <= static_cast<int>(series.c.size());
    };
    for (int degree = 1; fits(degree) && without_gain < patience; degree += 1 + degree / 6) {
        auto now = fitting::singularities_of_degree(series, form, degree);
        ++without_gain;
        if (now && (!best || relative(*now) < relative(*best))) {
            without_gain = best && relative(*now) * 2 > relative(*best) ? without_gain : 0;
            best = std::move(now);
        }
        if (best && relative(*best) <= fine) {
            break;
        }
    }
    return best;
}

/// The answer of a test that fits recurrences of one form, in the variable x. The uncertainty is four times what the root
/// moved, and not below a rounding of the coefficients: calibrated on the tournament's first half.
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
    result.uncertainty = in_scalar(first.moved) * safety + *result.radius * rounding * safety;
    result.exponent = in_scalar(first.exponent);
    result.exponent_uncertainty = in_scalar(first.exponent_moved) * safety;
    const mpfr certain = first.moved + radius * widen(rounding);
    for (const fitted_singularity& each : found->nearest) {
        // Roots that mean nothing lie near the circle too, but they do not stay: half of the digits are asked for.
        const bool stays = each.moved * each.moved <= certain * radius;
        const bool on_circle = abs(modulus_of(each.at) - radius) <= (each.moved + certain) * safety;
        result.count += stays && on_circle ? (each.at.im == 0 ? 1 : 2) : 0;
    }
    result.note = "denominator of degree " + std::to_string(found->degree);
    return in_variable(std::move(result), c.stride());
}

}  // namespace libration
