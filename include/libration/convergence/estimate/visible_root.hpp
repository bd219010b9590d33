// Whether the coefficients show a singularity at all: a differential equation fitted to them may be singular where its
// solution is not.
//
// A singularity at w with the exponent nu adds A w^-k k^(-nu-1) (1 + a/k + ...) to c_k. Where the coefficients fall as
// slowly as that, it is the nearest one. Where they fall faster, A is small, or 0 at an apparent singularity.
// The A of both are unknowns of a linear system from the last coefficients; one that is there stays as the last
// coefficients are left out, and what rounding or the rest of the function makes of a 0 does not.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/convergence/estimate/recurrence_fit.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::convergence::fitting {

/// A root w (im >= 0) and the exponent there.
struct root_with_exponent {
    complex_number<mpfr> at;
    mpfr exponent;
};

/// Whether the largest |c_k w^k| k^(nu+1) of the last eighth is more than 2^-10 of that at half of the list. Logarithms
/// of 20 digits tell.
inline bool as_large_as_coefficients(const wide_series& series, const root_with_exponent& root) {
    const precision_scope scope(20);
    const auto count = static_cast<int>(series.c.size());
    const mpfr size = log2(narrow<mpfr>(modulus_of(root.at)));
    const mpfr falling = narrow<mpfr>(root.exponent) + 1;
    const auto largest = [&](int first, int last) {
        std::optional<mpfr> most;
        for (int k = std::max(1, first); k <= last; ++k) {
            const mpfr& c = series.c[static_cast<std::size_t>(k)];
            if (c != 0) {
                const mpfr now = log2(narrow<mpfr>(abs(c))) + size * k + falling * log2(mpfr(k));
                most = most && *most > now ? *most : now;
            }
        }
        return most;
    };
    const int width = std::max(4, count / 8);
    const auto late = largest(count - width, count - 1);
    const auto early = largest(count / 2 - width / 2, count / 2 + width / 2);
    return !late || !early || *late + 10 >= *early;
}

/// w^-(k - k0) k^-(nu + 1 + s) at k = k0 - back as one or two columns: the real and, off the axis, the imaginary part.
/// `power` is w^back, `falling` k0/k, `logarithm` that of it.
inline void add_columns(std::vector<mpfr>& row, const root_with_exponent& root, const complex_number<mpfr>& power,
                        const mpfr& falling, const mpfr& logarithm, int terms) {
    mpfr factor = exp(mpfr(logarithm * (root.exponent + 1)));
    for (int s = 0; s < terms; ++s, factor *= falling) {
        row.push_back(power.re * factor);
        if (root.at.im != 0) {
            row.push_back(power.im * factor);
        }
    }
}

/// |A w^-k| k^(-nu-1) of the first root by the coefficients up to k0, the others taken from them at once; nothing where
/// the equations are singular.
inline std::optional<mpfr> amplitude_of_first(const wide_series& series, const std::vector<root_with_exponent>& roots,
                                              int k0, int terms) {
    std::vector<std::vector<mpfr>> a;
    std::vector<mpfr> b;
    std::size_t unknowns = 0;
    for (const auto& root : roots) {
        unknowns += static_cast<std::size_t>(terms) * (root.at.im == 0 ? 1 : 2);
    }
    std::vector<complex_number<mpfr>> powers(roots.size(), complex_number<mpfr>{mpfr(1)});
    for (std::size_t i = 0; i < unknowns; ++i) {
        const int k = k0 - static_cast<int>(i);
        if (k < 1) {
            return std::nullopt;
        }
        const mpfr falling = mpfr(k0) / k;
        const mpfr logarithm = log(falling);
        std::vector<mpfr> row;
        for (std::size_t r = 0; r < roots.size(); ++r) {
            add_columns(row, roots[r], powers[r], falling, logarithm, terms);
            powers[r] = powers[r] * roots[r].at;
        }
        a.push_back(std::move(row));
        b.push_back(narrow<mpfr>(series.c[static_cast<std::size_t>(k)]));
    }
    const auto solution = solve_linear(std::move(a), std::move(b), mpfr(epsilon<mpfr>() * 64));
    if (!solution) {
        return std::nullopt;
    }
    mpfr sum(0);
    const int parts = roots.front().at.im == 0 ? 1 : 2;
    for (int part = 0; part < parts; ++part) {
        const mpfr& x = (*solution)[static_cast<std::size_t>(part)];
        sum += x * x;
    }
    return mpfr(sqrt(sum));
}

/// Whether there is a reason to doubt a root: the coefficients have fallen below it by 2^10, or its exponent is a whole
/// number of 1 or more, as where a solution is analytic.
inline bool is_doubtful(const wide_series& series, const root_with_exponent& root) {
    const mpfr whole(nearest_integer(root.exponent));
    const bool analytic = whole >= 1 && abs(root.exponent - whole) * 100 < 1;
    return analytic || !as_large_as_coefficients(series, root);
}

/// |A w^-k| k^(-nu-1) of the first root at k = last as the coefficients up to last - back say; nothing where they say
/// nothing.
inline std::optional<mpfr> carried_amplitude(const wide_series& series, const std::vector<root_with_exponent>& roots,
                                             int last, int back, int terms) {
    const auto before = amplitude_of_first(series, roots, last - back, terms);
    if (!before) {
        return std::nullopt;
    }
    const mpfr carried = *before * pow(modulus_of(roots.front().at), -back);
    return mpfr(carried * pow(mpfr(last - back) / last, mpfr(roots.front().exponent + 1)));
}

/// Whether the amplitude of the first root, carried from k0 to the last coefficient, stays within a quarter for k0
/// down to three quarters of the list. In half of the digits, 20 more than the coefficients have: the equations magnify
/// these 20 digits less than the rounding of the coefficients themselves.
inline bool amplitude_stays(const wide_series& series, const std::vector<root_with_exponent>& given) {
    const precision_scope scope(working_digits() / 2);
    const int last = static_cast<int>(series.c.size()) - 1;
    std::vector<root_with_exponent> roots;
    int columns = 0;
    for (const auto& [at, exponent] : given) {
        roots.push_back({{narrow<mpfr>(at.re), narrow<mpfr>(at.im)}, narrow<mpfr>(exponent)});
        columns += at.im == 0 ? 1 : 2;
    }
    const int terms = std::clamp(last / 3 / columns, 1, 8);
    const auto now = amplitude_of_first(series, roots, last, terms);
    const std::array<int, 3> ways_back{1, std::max(2, last / 8), std::max(3, last / 4)};
    return now && std::ranges::all_of(ways_back, [&](int back) {
               const auto carried = carried_amplitude(series, roots, last, back, terms);
               return carried && abs(*carried - *now) * 4 < *now;
           });
}

/// Whether the first root is a singularity that the coefficients show, the others being those near it: nothing speaks
/// against it, or its amplitude stays.
inline bool is_visible(const wide_series& series, const std::vector<root_with_exponent>& roots) {
    return !is_doubtful(series, roots.front()) || amplitude_stays(series, roots);
}

}  // namespace libration::convergence::fitting
