// The nearest singularities as roots of fitted recurrences, each with an exponent and an estimate of its error.
//
// The systems and their roots are computed with 20 digits more than the coefficients have: rounding during elimination
// then has the effect of changing the coefficients 20 digits below their own rounding. The truncation error of a
// recurrence and the effect of that rounding appear in the uncertainty: every root is compared with those from the list
// without its last one, its last two and so on up to its last quarter of coefficients.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/followed_root.hpp"
#include "libration/convergence/recurrence_fit.hpp"
#include "libration/convergence/visible_root.hpp"

namespace libration::convergence {

/// A root w of Q_highest with im >= 0, the exponent of f there, and how far both moved when the last coefficients were
/// added.
struct fitted_singularity {
    complex_number<mpfr> at;
    mpfr exponent;
    fitting::leftover moved;
    mpfr exponent_moved;
    mpfr exponent_sensitivity;  ///< how the exponent changes with the root
};

/// The nearest singularities of one fit by increasing modulus, the first one defining the radius in w.
struct fitted_singularities {
    int degree = 0;  ///< M
    std::vector<fitted_singularity> nearest;
    mpfr nearer = mpfr(0);  ///< how much nearer the closest root of another degree is; 0 if there is none
};

namespace fitting {

/// nu at a root w of Q_d: d - 1 - Q_{d-1}/(stride w Q_d'); d - 1 for a recurrence with one power of n.
inline mpfr exponent_at(const leading_polynomials& q, const complex_number<mpfr>& w, const recurrence_form& form,
                        int stride) {
    if (form.highest == form.lowest) {
        mpfr assumed(form.highest - 1);
        return assumed;
    }
    const auto above = polynomial_values(q.below).at(w).value;
    const auto below = w * polynomial_values(q.top).at(w).slope * mpfr(stride);
    return form.highest - 1 - (above / below).re;
}

/// How much the exponent d - 1 + e at a root w of Q_d changes with the root: |e Q_d''/(2 Q_d')|, which is |e| over the
/// distance to a nearby root. If that distance is within the uncertainty of the root, as at a double root, the formula
/// for a simple root yields an arbitrary number.
inline mpfr sensitivity_of_exponent(const series::power_series<mpfr>& top, const complex_number<mpfr>& w,
                                    const mpfr& e) {
    if (e == 0 || top.order() < 2) {
        return 0;
    }
    auto slope = series::power_series<mpfr>::zero(top.order() - 1);
    for (int j = 1; j <= top.order(); ++j) {
        slope[j - 1] = top[j] * j;
    }
    const auto at = polynomial_values(slope).at(w);
    return abs(e) * modulus_of(at.slope) / (modulus_of(at.value) * 2);
}

/// A root followed through the recurrences from fewer coefficients. Returns std::nullopt if one of them has no root
/// near it.
inline std::optional<fitted_singularity> followed(const std::vector<leading_polynomials>& fits,
                                                  complex_number<mpfr> start, const recurrence_form& form, int stride,
                                                  int s) {
    std::vector<complex_number<mpfr>> at;
    std::vector<complex_number<mpfr>> exponents;
    for (const auto& q : fits) {
        // For all but the first one, only the distance is required.
        const auto root = polished(q.top, start, !at.empty());
        if (!root) {
            return std::nullopt;
        }
        start = *root;
        at.push_back(*root);
        complex_number<mpfr> exponent{exponent_at(q, *root, form, stride)};
        exponents.push_back(std::move(exponent));
    }
    return fitted_singularity{at[0], exponents[0].re, left_after(at, s), left_after(exponents, s).likely,
                              sensitivity_of_exponent(fits[0].top, at[0], mpfr(exponents[0].re - (form.highest - 1)))};
}

/// A list and the data shared by the fits of all degrees.
struct list_to_fit {
    list_to_fit(const wide_series& of_series, const recurrence_form& of_form)
        : series(of_series),
          form(of_form),
          fits(of_series, of_form),
          logarithms(static_cast<int>(of_series.c.size()) - 1) {}

    const wide_series& series;
    recurrence_form form;
    recurrence_fits fits;
    falling_logarithms logarithms;
};

/// The first of the roots, by increasing modulus, that is visible in the coefficients, fitted together with those up to
/// two and a half times as far from 0, six at most; the number of roots if none is visible.
inline std::size_t first_visible(list_to_fit& list, const leading_polynomials& q,
                                 const std::vector<complex_number<mpfr>>& roots) {
    constexpr std::size_t most = 6;
    std::vector<root_with_exponent> known;
    const auto with_exponent = [&](std::size_t i) -> const root_with_exponent& {
        while (known.size() <= i) {
            const auto& root = roots[known.size()];
            known.push_back({root, exponent_at(q, root, list.form, list.series.stride)});
        }
        return known[i];
    };
    std::size_t first = 0;
    for (; first < roots.size() && is_doubtful(list.series, with_exponent(first)); ++first) {
        std::vector<root_with_exponent> beside;
        for (std::size_t i = first; i < roots.size() && beside.size() < most; ++i) {
            if (modulus_of(roots[i]) * 2 <= modulus_of(roots[first]) * 5) {
                beside.push_back(with_exponent(i));
            }
        }
        if (amplitude_stays(list.series, list.logarithms, beside)) {
            break;
        }
    }
    return first;
}

/// The singularities of one degree: the nearest visible root and the others at most a tenth further away.
inline std::optional<fitted_singularities> singularities_of_degree(list_to_fit& list, int degree) {
    const recurrence_form& form = list.form;
    const wide_series& series = list.series;
    const auto count = static_cast<int>(series.c.size());
    const auto fewer = fewer_coefficients(count, coefficients_needed(form, degree) - 4);
    std::vector<int> lasts;
    lasts.reserve(fewer.size());
    for (const int without : fewer) {
        lasts.push_back(count - 1 - without);
    }
    const auto determined = list.fits.up_to(lasts, degree);
    if (!determined) {
        return std::nullopt;
    }
    const std::vector<leading_polynomials>& fits = *determined;
    fitted_singularities found{degree, {}, mpfr(0)};
    const auto starts = starting_roots(fits[0].top);
    const std::size_t first = form.highest > form.lowest ? first_visible(list, fits[0], starts) : 0;
    for (std::size_t i = first; i < starts.size() && modulus_of(starts[i]) * 10 <= modulus_of(starts[first]) * 11;
         ++i) {
        auto singularity = followed(fits, starts[i], form, series.stride, fewer[4]);
        if (!singularity && found.nearest.empty()) {
            return std::nullopt;
        }
        if (singularity) {
            found.nearest.push_back(*std::move(singularity));
        }
    }
    return found.nearest.empty() ? std::nullopt : std::optional(std::move(found));
}

/// The root of another degree that is nearest to a point.
inline const fitted_singularity& nearest_to(const fitted_singularities& other, const complex_number<mpfr>& at) {
    return *std::min_element(other.nearest.begin(), other.nearest.end(), [&](const auto& a, const auto& b) {
        return modulus_of(a.at - at) < modulus_of(b.at - at);
    });
}

/// For the degree of an exact recurrence, the error as a number of its last steps: 4 if it is certain to fine^(7/8) of
/// its root; 16 if it is certain to ten digits, four more than the previous degree, and no less than the next, which
/// agrees, since only rounding is left there, and it grows; 0 otherwise.
inline int steps_of_exact_degree(const std::vector<fitted_singularities>& all, std::size_t best, const mpfr& fine) {
    const auto safe = [&](std::size_t i) -> const mpfr& { return all[i].nearest.front().moved.safe; };
    const auto& at = all[best].nearest.front().at;
    if (safe(best) < modulus_of(at) * fine / sqrt(sqrt(sqrt(fine)))) {
        return 4;
    }
    const mpfr ten_digits = pow(mpfr(10), 10);
    if (best + 1 >= all.size() || safe(best) * ten_digits > modulus_of(at) ||
        (best > 0 && safe(best - 1) < safe(best) * 10'000)) {
        return 0;
    }
    const fitted_singularity& next = nearest_to(all[best + 1], at);
    return next.moved.safe >= safe(best) && modulus_of(next.at - at) <= next.moved.safe * 4 ? 16 : 0;
}

/// Steps may be small by chance: unless the degree is that of an exact recurrence, the error is taken to be four times
/// the estimate from the steps, or four times the second smallest distance from the roots of the two next degrees on
/// either side; for a single degree, two thirds of its digits are trusted. The error is never taken below a sixteenth
/// of the last steps.
inline void compare_with_neighbours(std::vector<fitted_singularities>& all, std::size_t best, const mpfr& fine) {
    fitted_singularity& first = all[best].nearest.front();
    first.moved.likely = std::max(first.moved.likely, mpfr(first.moved.safe / 16));
    if (const int steps = steps_of_exact_degree(all, best, fine); steps > 0) {
        first.moved.likely = std::max(first.moved.likely, mpfr(first.moved.safe * steps));
        return;
    }
    if (all.size() == 1) {
        const mpfr size = modulus_of(first.at);
        first.moved.likely = std::max(first.moved.likely, mpfr(size * cbrt(pow(mpfr(first.moved.safe / size), 2))));
        return;
    }
    std::vector<mpfr> apart;
    std::vector<mpfr> exponents_apart;
    for (std::size_t other = best < 2 ? 0 : best - 2; other < all.size() && other <= best + 2; ++other) {
        if (other != best) {
            const fitted_singularity& there = nearest_to(all[other], first.at);
            apart.push_back(modulus_of(there.at - first.at));
            exponents_apart.push_back(abs(there.exponent - first.exponent));
        }
    }
    const auto second_of = [](std::vector<mpfr>& of) -> const mpfr& {
        std::sort(of.begin(), of.end());
        return of[of.size() > 1 ? 1 : 0];
    };
    first.moved.likely = std::max(first.moved.likely, second_of(apart)) * 4;
    first.exponent_moved = std::max(first.exponent_moved, second_of(exponents_apart));
}

/// A weak singularity nearer than a strong one appears only in some degrees, and with a larger uncertainty: the largest
/// distance by which a root of any degree is nearer than the best one, among those that move by less than an eighth of
/// that distance; 0 if there is none.
inline mpfr distance_of_nearer(const std::vector<fitted_singularities>& all, std::size_t best) {
    const fitted_singularity& first = all[best].nearest.front();
    mpfr most(0);
    for (const fitted_singularities& other : all) {
        for (const fitted_singularity& root : other.nearest) {
            const mpfr nearer = modulus_of(first.at) - modulus_of(root.at);
            if (nearer > most && nearer > first.moved.likely && root.moved.safe * 8 < nearer) {
                most = nearer;
            }
        }
    }
    return most;
}

}  // namespace fitting

/// The nearest singularities by the degree whose root is the most certain, among those whose system has at most 64
/// unknowns, as far as the coefficients suffice; degrees are spaced more and more widely, and the search ends when five
/// in turn do not halve the uncertainty. Returns std::nullopt if no degree has a root that can be followed. Works in
/// the precision of the caller, which should have 20 digits more than the coefficients; `fine` is the smallest relative
/// uncertainty that these allow.
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
    fitting::list_to_fit list(series, form);
    for (int degree = 1; fits(degree) && without_gain < patience; degree += 1 + degree / 6) {
        ++without_gain;
        if (auto now = fitting::singularities_of_degree(list, degree)) {
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
    fitting::compare_with_neighbours(all, best, fine);
    all[best].nearer = fitting::distance_of_nearer(all, best);
    return std::move(all[best]);
}

}  // namespace libration::convergence
