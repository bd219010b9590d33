// The remaining drift of an exponent: the error that corrections decaying like 1/log n hide from estimates that agree.
//
// Of (1 - x/x0)^nu log(1 - x/x0)^k the coefficients are x0^-n n^(-nu-1) (log n)^k (1 + ...): every estimate from
// coefficients near n yields the local exponent nu - k/log n, and all estimates from one list share that error however
// well they agree. It shows in lists of different lengths: over a factor f < 1 of n the local exponent moves by about k
// log(1/f)/(log n)^2, the part log(1/f)/log n of its error.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "libration/convergence/fitted_singularities.hpp"
#include "libration/number/exact.hpp"

namespace libration::convergence {

/// Exponents from the recurrence of smallest degree for lists that end at n, f n and f^2 n, f < 1.
template <rounding_scalar T>
struct local_exponents {
    std::array<T, 3> at;
    T factor;

    /// The last steps: from f n to n, of the exponents and of (e_n - f e_{f n})/(1 - f), which are without a 1/n part.
    std::array<T, 2> last_steps() const {
        const auto step = [&](std::size_t i) { return T(at[i] - at[i + 1]); };
        return {step(0), T((step(0) - factor * step(1)) / (1 - factor))};
    }
};

namespace fitting {

/// The exponent at the root nearest to w. Returns std::nullopt if that is further away than a quarter of |w|.
inline std::optional<mpfr> exponent_near(const leading_polynomials& q, const complex_number<mpfr>& w,
                                         const recurrence_form& form, int stride) {
    const auto roots = starting_roots(q.top);
    if (roots.empty()) {
        return std::nullopt;
    }
    const auto nearest = *std::min_element(roots.begin(), roots.end(), [&](const auto& a, const auto& b) {
        return modulus_of(a - w) < modulus_of(b - w);
    });
    const auto root = polished(q.top, nearest);
    if (!root || modulus_of(*root - w) * 4 > modulus_of(w)) {
        return std::nullopt;
    }
    return exponent_at(q, *root, form, stride);
}

/// The ends n, f n, f^2 n of the lists, and f.
struct shorter_lists {
    std::vector<int> lasts;
    rational factor;
};

/// f is 1/2, or 2/3 if f^3 n is less than `needed`: the exponents of lists not much longer than that have not begun to
/// settle. Returns std::nullopt if neither does.
inline std::optional<shorter_lists> shorter_lists_of(int last, int needed) {
    for (const auto& [above, below] : {std::pair(1, 2), std::pair(2, 3)}) {
        const int once = last * above / below;
        const int twice = last * above * above / (below * below);
        if (twice * above / below >= needed) {
            return shorter_lists{{last, once, twice}, rational(above, below)};
        }
    }
    return std::nullopt;
}

/// The exponents at the root w of the fits. Returns std::nullopt if one has no root near w.
inline std::optional<std::vector<mpfr>> exponents_near(const wide_series& series, const std::vector<int>& lasts,
                                                       int degree, const complex_number<mpfr>& w) {
    constexpr recurrence_form form{0, 1};
    const auto fits = recurrence_fits(series, form).up_to(lasts, degree);
    std::vector<mpfr> exponents;
    for (std::size_t i = 0; fits && i < fits->size(); ++i) {
        auto exponent = exponent_near((*fits)[i], w, form, series.stride);
        if (!exponent) {
            return std::nullopt;
        }
        exponents.push_back(*std::move(exponent));
    }
    return fits ? std::optional(std::move(exponents)) : std::nullopt;
}

/// x0^stride with im >= 0.
template <rounding_scalar T>
complex_number<mpfr> upper_power(const complex_number<T>& x0, int stride) {
    complex_number<mpfr> w{mpfr(1)};
    for (int i = 0; i < stride; ++i) {
        w = w * complex_number<mpfr>{widen(x0.re), widen(x0.im)};
    }
    return {w.re, mpfr(abs(w.im))};
}

}  // namespace fitting

/// The local exponents at a singularity x0 (im >= 0), one of `count` on the circle of convergence. Returns std::nullopt
/// if the list is too short for three of them or one has no root near x0. Computed with 20 digits more than T has.
/// O(N).
template <rounding_scalar T>
std::optional<local_exponents<T>> local_exponents_of(const strided_series<T>& c, const complex_number<T>& x0,
                                                     int count) {
    constexpr long guard_digits = 20;
    constexpr int most_degree = 4;
    const int degree = std::clamp(count / c.stride(), x0.im == 0 ? 1 : 2, most_degree);
    const auto lists = fitting::shorter_lists_of(c.last(), unknowns_of({0, 1}, degree) + degree);
    if (!lists) {
        return std::nullopt;
    }
    const auto exponents = [&] {
        const precision_scope scope(decimal_digits(digits<T>()) + guard_digits);
        return fitting::exponents_near(fitting::widened(c), lists->lasts, degree, fitting::upper_power(x0, c.stride()));
    }();
    if (!exponents) {
        return std::nullopt;
    }
    local_exponents<T> found{{}, from_rational<T>(lists->factor)};
    std::transform(exponents->begin(), exponents->end(), found.at.begin(), [](const mpfr& e) { return narrow<T>(e); });
    return found;
}

/// The error of an exponent due to corrections like 1/log n, n the last power. Of nu + k/(log n + c) the last step is
/// the part log(1/f)/(log n + c) at least, whatever else contributes to it; c is not known, and c <= log n is allowed
/// for, calibrated.
template <rounding_scalar T>
T drift_of_exponent(const local_exponents<T>& local, const T& exponent, const list_quality<T>& list) {
    using std::abs;
    using std::log;
    const T steps = log(T(list.order)) * 2 / -log(local.factor);
    const T noise = list.noise * list.order * list.order * 8;
    T drift(0);
    for (const T& step : local.last_steps()) {
        if (abs(step) > noise) {
            drift = std::max(drift, T(abs(step) * steps + abs(T(local.at[0] - exponent))));
        }
    }
    return drift;
}

/// drift_of_exponent() without local exponents: that of one logarithm as a factor.
template <rounding_scalar T>
T unseen_drift(const list_quality<T>& list) {
    using std::log;
    return 1 / log(T(list.order));
}

}  // namespace libration::convergence
