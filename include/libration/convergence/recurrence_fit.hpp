// A linear recurrence with polynomials in n as coefficients, fitted to the last coefficients of a series: the basis of
// the pole tests and of the differential approximants.
//
// f is assumed to satisfy a linear differential equation sum_i Q_i(w) (x d/dx)^i f = P(w), x d/dx x^n = n x^n, with
// polynomials Q_i of degree M in w = x^stride. Beyond the degree of P its coefficients satisfy
//     sum_{j=0}^{M} sum_{i=lowest}^{highest} q_ij n_{k-j}^i c_{k-j} = 0,   n_k = first + stride k,
// a linear system for the q_ij (q of the highest i and j = 0 is 1). f is singular at the roots of Q_highest
// [Guttmann1989, 3.2; Hunter1979]. With one power of n alone this is the Pade approximant [K-M/M] of f (i = 0: poles)
// or of x f' (i = 1: logarithms), that is Prony's fit of a sum of exponentials to the last 2M coefficients.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/convergence/strided_series.hpp"

namespace libration::convergence {

/// The powers of n in the recurrence: the i of (x d/dx)^i.
struct recurrence_form {
    int lowest;
    int highest;
    int powers() const { return highest - lowest + 1; }
};

/// The number of q_ij of degree M, except the one that is 1.
inline int unknowns_of(const recurrence_form& form, int degree) { return (degree + 1) * form.powers() - 1; }

/// The number of coefficients that a fit uses: one per unknown, the order of the recurrence before them,
/// and four for comparison.
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

/// Q_highest and Q_{highest-1} (0 if the form has none) in the variable w, of the recurrence for n/n_last.
struct leading_polynomials {
    series::power_series<mpfr> top;
    series::power_series<mpfr> below;
};

/// The recurrences of one form from lists of different lengths, whose linear systems have equations in common.
class recurrence_fits {
public:
    recurrence_fits(const wide_series& series, const recurrence_form& form)
        : form_(form), size_(series.first + series.stride * (static_cast<int>(series.c.size()) - 1)) {
        add_terms(series);
    }

    /// Those of one degree from the coefficients up to each of `lasts`. Returns std::nullopt if one of the lists does
    /// not determine it, for example if an exact recurrence of smaller degree exists.
    std::optional<std::vector<leading_polynomials>> up_to(const std::vector<int>& lasts, int degree) const {
        const int unknowns = unknowns_of(form_, degree);
        std::vector<mpfr> equation(static_cast<std::size_t>(unknowns) + 1);
        sliding_systems systems(static_cast<std::size_t>(unknowns), mpfr(epsilon<mpfr>() * (8 * (unknowns + 1))),
                                [&](int k) -> const std::vector<mpfr>& {
                                    write_equation(k, degree, equation);
                                    return equation;
                                });
        std::vector<leading_polynomials> fits;
        fits.reserve(lasts.size());
        const bool all = systems.solve(lasts, [&](const std::vector<mpfr>& q) {
            fits.push_back(leading(q, degree));
            return true;
        });
        return all ? std::optional(std::move(fits)) : std::nullopt;
    }

private:
    // c_k n_k^i, n_k in units of the last one.
    void add_terms(const wide_series& series) {
        terms_.reserve(series.c.size() * static_cast<std::size_t>(form_.powers()));
        for (int k = 0; k < static_cast<int>(series.c.size()); ++k) {
            const mpfr n = (series.first + series.stride * k) / size_;
            mpfr term = series.c[static_cast<std::size_t>(k)] * pow(n, form_.lowest);
            for (int i = form_.lowest; i <= form_.highest; ++i, term *= n) {
                terms_.push_back(term);
            }
        }
    }

    // The equation at k: the terms of k, k - 1, .., k - degree, with the one whose factor is 1 on the right-hand side.
    void write_equation(int k, int degree, std::vector<mpfr>& equation) const {
        const auto powers = static_cast<std::size_t>(form_.powers());
        auto next = equation.begin();
        for (int j = 0; j <= degree; ++j) {
            const auto terms = terms_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(k - j) * powers);
            next = std::copy(terms, terms + static_cast<std::ptrdiff_t>(powers - (j > 0 ? 0 : 1)), next);
        }
        *next = -terms_[static_cast<std::size_t>(k + 1) * powers - 1];
    }

    leading_polynomials leading(const std::vector<mpfr>& q, int degree) const {
        leading_polynomials found{series::power_series<mpfr>::zero(degree), series::power_series<mpfr>::zero(degree)};
        found.top[0] = 1;
        const auto at = [&](int j, int i) {
            return static_cast<std::size_t>(j * form_.powers() + i - form_.lowest - (j > 0 ? 1 : 0));
        };
        for (int j = 0; j <= degree; ++j) {
            if (j > 0) {
                found.top[j] = q[at(j, form_.highest)];
            }
            if (form_.highest > form_.lowest) {
                found.below[j] = q[at(j, form_.highest - 1)] * size_;
            }
        }
        return found;
    }

    recurrence_form form_;
    mpfr size_;
    std::vector<mpfr> terms_;
};

/// The recurrence from the coefficients up to `last` only.
inline std::optional<leading_polynomials> fit_recurrence(const wide_series& series, const recurrence_form& form,
                                                         int degree, int last) {
    auto found = recurrence_fits(series, form).up_to({last}, degree);
    return found ? std::optional(std::move(found->front())) : std::nullopt;
}

}  // namespace fitting

}  // namespace libration::convergence
