// A linear recurrence with polynomials in n as coefficients, fitted to the last coefficients of a series: the engine of
// the pole tests and of the differential approximants.
//
// f is taken to obey a linear differential equation sum_i Q_i(w) (x d/dx)^i f = P(w), x d/dx x^n = n x^n, with
// polynomials Q_i of degree M in w = x^stride. Beyond the degree of P its coefficients satisfy
//     sum_{j=0}^{M} sum_{i=lowest}^{highest} q_ij n_{k-j}^i c_{k-j} = 0,   n_k = first + stride k,
// a linear system for the q_ij (q of the highest i and j = 0 is 1). f is singular at the roots of Q_highest
// [Guttmann1989, 3.2; Hunter1979]. With one power of n alone this is the Pade approximant [K-M/M] of f (i = 0: poles)
// or of x f' (i = 1: logarithms), that is Prony's fit of a sum of exponentials to the last 2M coefficients.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/convergence/estimate/strided_series.hpp"

namespace libration::convergence {

/// Which powers of n the recurrence has: the i of (x d/dx)^i.
struct recurrence_form {
    int lowest;
    int highest;
    int powers() const { return highest - lowest + 1; }
};

/// The q_ij of degree M but the one that is 1.
inline int unknowns_of(const recurrence_form& form, int degree) { return (degree + 1) * form.powers() - 1; }

/// The coefficients that a fit takes: one for each unknown, as many before them as the recurrence looks
/// back, and four for comparison.
inline int coefficients_needed(const recurrence_form& form, int degree) {
    return unknowns_of(form, degree) + degree + 4;
}

namespace fitting {

/// The coefficients in working precision.
struct wide_series {
    std::vector<mpfr> c;
    int first;
    int stride;
};

template <rounding_scalar T>
wide_series widened(const strided_series<T>& series) {
    wide_series wide{{}, series.first(), series.stride()};
    wide.c.reserve(static_cast<std::size_t>(series.last()) + 1);
    for (int k = 0; k <= series.last(); ++k) {
        wide.c.push_back(narrow<mpfr>(widen(series[k])));
    }
    return wide;
}

/// Q_highest and Q_{highest-1} (0 where the form has none) in the variable w, of the recurrence for n/n_last.
struct leading_polynomials {
    series::power_series<mpfr> top;
    series::power_series<mpfr> below;
};

/// The recurrence from the coefficients up to `last`. Nothing where they do not determine it, as an exact recurrence of
/// smaller degree does not.
inline std::optional<leading_polynomials> fit_recurrence(const wide_series& series, const recurrence_form& form,
                                                         int degree, int last) {
    const int unknowns = unknowns_of(form, degree);
    const mpfr size(series.first + series.stride * last);
    std::vector<std::vector<mpfr>> a;
    std::vector<mpfr> b;
    for (int k = last - unknowns + 1; k <= last; ++k) {
        std::vector<mpfr> row;
        for (int j = 0; j <= degree; ++j) {
            const mpfr n = (series.first + series.stride * (k - j)) / size;
            mpfr term = series.c[static_cast<std::size_t>(k - j)] * pow(n, form.lowest);
            for (int i = form.lowest; i <= form.highest; ++i, term *= n) {
                if (j > 0 || i < form.highest) {
                    row.push_back(term);
                } else {
                    b.push_back(-term);
                }
            }
        }
        a.push_back(std::move(row));
    }
    if (const auto solution = solve_linear(std::move(a), std::move(b), mpfr(epsilon<mpfr>() * (8 * (unknowns + 1))))) {
        const std::vector<mpfr>& q = *solution;
        leading_polynomials found{series::power_series<mpfr>::zero(degree), series::power_series<mpfr>::zero(degree)};
        found.top[0] = 1;
        const auto at = [&](int j, int i) {
            return static_cast<std::size_t>(j * form.powers() + i - form.lowest - (j > 0 ? 1 : 0));
        };
        for (int j = 0; j <= degree; ++j) {
            if (j > 0) {
                found.top[j] = q[at(j, form.highest)];
            }
            if (form.highest > form.lowest) {
                found.below[j] = q[at(j, form.highest - 1)] * size;
            }
        }
        return found;
    }
    return std::nullopt;
}

}  // namespace fitting

}  // namespace libration::convergence
