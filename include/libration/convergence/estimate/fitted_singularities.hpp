// The nearest singularities as roots of fitted recurrences, each with an exponent and an estimate of its error.
//
// The systems are solved in 20 digits more than the coefficients have, and so are their roots: what elimination rounds
// is what coefficients that are 20 digits more certain would change, far less than their own rounding does. What a
// recurrence leaves out and what that rounding spoils shows in the uncertainty: every root is compared with those from
// the list without its last one, its last two and so on up to its last quarter of coefficients.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/convergence/estimate/followed_root.hpp"
#include "libration/convergence/estimate/recurrence_fit.hpp"
#include "libration/convergence/estimate/visible_root.hpp"

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
    mpfr nearer = mpfr(0);  ///< how much nearer another degree has one; 0 where none has
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

/// A root followed through the recurrences from fewer coefficients. Nothing where one of them has no root near.
inline std::optional<fitted_singularity> followed(const std::vector<leading_polynomials>& fits,
                                                  complex_number<mpfr> start, const recurrence_form& form, int stride,
                                                  int s) {
    std::vector<complex_number<mpfr>> at;
    std::vector<complex_number<mpfr>> exponents;
    for (const auto& q : fits) {
        // Of all but the first one, how far it is away is asked.
        const auto root = polished(q.top, start, !at.empty());
        if (!root) {
            return std::nullopt;
        }
        start = *root;
        at.push_back(*root);
        complex_number<mpfr> exponent{exponent_at(q, *root, form, stride)};
        exponents.push_back(std::move(exponent));
    }
    return fitted_singularity{at[0], exponents[0].re, left_after(at, s), left_after(exponents, s).likely};
}

/// A list and what the fits of all degrees share.
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

/// The first of the roots, by growing modulus, that the coefficients show, judged beside those up to two and a half
/// times as far from 0, six at most; their number where they show none.
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

/// The singularities of one degree: the root nearest to 0 that the coefficients show and the others no further than a
/// tenth more.
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

/// Where a degree is the one of an exact recurrence, how many of its last steps the error may be: 4 where it is certain
/// to fine^(7/8) of its root; 16 where it is to ten digits, four more than the degree before, and no less than the
/// next, which agrees, for there rounding alone is left, and grows; 0 otherwise.
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

/// Steps may be small by chance: unless the degree is that of an exact recurrence, the error is thought to be four
/// times what the steps say, or four times the second smallest distance from the roots of the two next degrees on
/// either side; a single degree is believed two thirds of its digits. No error is thought to be below a sixteenth of
/// the last steps.
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
    for (std::size_t other = best < 2 ? 0 : best - 2; other < all.size() && other <= best + 2; ++other) {
        if (other != best) {
            apart.push_back(modulus_of(nearest_to(all[other], first.at).at - first.at));
        }
    }
    std::sort(apart.begin(), apart.end());
    first.moved.likely = std::max(first.moved.likely, apart[apart.size() > 1 ? 1 : 0]) * 4;
}

/// A weak singularity nearer than a strong one shows in some degrees only, and less certain than that: how much nearer
/// the furthest root is that lies before the best one and moves by less than an eighth of its distance; 0 for none.
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
/// unknowns, as far as the coefficients go; degrees grow more and more thinly, and growing ends where five in turn do
/// not halve it. Nothing where no degree gives a root that can be followed. Works in the precision of the caller, which
/// should have 20 digits more than the coefficients; `fine` is the relative uncertainty that these allow at best.
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

/// The exponent that the form presupposes is known no better than the position allows: another one moves the root by
/// about 1/K^2 of its size, K the number of coefficients.
inline mpfr uncertainty_of_assumption(const fitted_singularity& found, int count) {
    return found.moved.likely / modulus_of(found.at) * count * count;
}

/// The answer of a test that fits recurrences of one form, in the variable x. The uncertainty is four times the error
/// that is thought to be left, a factor chosen on the half "calibration" of the study radius_tournament, and a rounding
/// of the coefficients. A verdict takes three times that of a form that presupposes the exponent, unless six digits are
/// certain: what is neither a pole nor a logarithm settles slowly there.
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
    result.caution = result.exponent_assumed && first.moved.likely * 1'000'000 > radius ? 3 : 1;
    result.radius = in_scalar(radius);
    result.uncertainty = in_scalar(first.moved.likely) * safety + *result.radius * rounding;
    if (result.uncertainty >= *result.radius) {
        return no_estimate<T>(method, "its roots do not settle");
    }
    result.nearer = in_scalar(found->nearer);
    const int count = c.last() + 1;
    result.exponent = in_scalar(first.exponent);
    result.exponent_uncertainty =
        in_scalar(result.exponent_assumed ? uncertainty_of_assumption(first, count) : first.exponent_moved) * safety +
        rounding * count;
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
