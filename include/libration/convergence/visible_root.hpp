// Whether a singularity is visible in the coefficients at all: a differential equation fitted to them may be singular
// where its solution is not.
//
// A singularity at w with the exponent nu adds A w^-k k^(-nu-1) (1 + a/k + ...) to c_k. If the coefficients fall as
// slowly as that, it is the nearest one. If they fall faster, A is small, or 0 at an apparent singularity. The A of
// both are unknowns of a linear system from the last coefficients; the amplitude of an actual singularity is stable
// when the last coefficients are left out, whereas one that is 0 except for rounding or the rest of the function is
// not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/convergence/recurrence_fit.hpp"
#include "libration/scalar/complex_number.hpp"

namespace libration::convergence::fitting {

/// log2 |x| of x != 0, to double precision.
inline double log2_of(const mpfr& x) {
    long exponent = 0;
    const double mantissa = mpfr_get_d_2exp(&exponent, handle(x), MPFR_RNDN);
    return std::log2(std::abs(mantissa)) + static_cast<double>(exponent);
}

/// A root w (im >= 0) and the exponent there.
struct root_with_exponent {
    complex_number<mpfr> at;
    mpfr exponent;
};

/// Whether the largest |c_k w^k| k^(nu+1) of the last eighth is more than 2^-10 of that at half of the list, by binary
/// logarithms in double.
inline bool as_large_as_coefficients(const wide_series& series, const root_with_exponent& root) {
    const auto count = static_cast<int>(series.c.size());
    const double size = log2_of(modulus_of(root.at));
    const double falling = narrow<double>(root.exponent) + 1;
    const auto largest = [&](int first, int last) {
        std::optional<double> most;
        for (int k = std::max(1, first); k <= last; ++k) {
            const mpfr& c = series.c[static_cast<std::size_t>(k)];
            if (c != 0) {
                const double now = log2_of(c) + size * k + falling * std::log2(k);
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

/// Whether there is a reason to doubt a root: the coefficients have fallen below it by 2^10, or its exponent is an
/// integer >= 1, as for an analytic solution.
inline bool is_doubtful(const wide_series& series, const root_with_exponent& root) {
    const mpfr whole(nearest_integer(root.exponent));
    const bool analytic = whole >= 1 && abs(root.exponent - whole) * 100 < 1;
    return analytic || !as_large_as_coefficients(series, root);
}

/// log(last/k), 0 < k <= last, each computed once, in the working precision, which must not change.
class falling_logarithms {
public:
    explicit falling_logarithms(int last) : known_(static_cast<std::size_t>(last) + 1), last_(last) {}

    const mpfr& at(int k) {
        auto& known = known_[static_cast<std::size_t>(k)];
        if (!known) {
            known = log(mpfr(mpfr(last_) / k));
        }
        return *known;
    }

private:
    std::vector<std::optional<mpfr>> known_;
    int last_;
};

/// c_k as a sum of A_s w^-(k - last) (k/last)^-(nu + 1 + s) over roots and s < terms: for each root and s the
/// coefficient of the real and, off the axis, of the imaginary part of A_s; then c_k. Equations k = last, last - 1, ..
class amplitude_equations {
public:
    amplitude_equations(const wide_series& series, falling_logarithms& logarithms,
                        std::vector<root_with_exponent> roots, int terms)
        : series_(series),
          logarithms_(logarithms),
          roots_(std::move(roots)),
          terms_(terms),
          last_(static_cast<int>(series.c.size()) - 1),
          powers_(roots_.size(), complex_number<mpfr>{mpfr(1)}) {}

    const std::vector<mpfr>& operator()(int k) {
        while (static_cast<int>(rows_.size()) <= last_ - k) {
            add_next();
        }
        return rows_[static_cast<std::size_t>(last_ - k)];
    }

private:
    void add_next() {
        const int k = last_ - static_cast<int>(rows_.size());
        const mpfr falling = mpfr(last_) / k;
        const mpfr& logarithm = logarithms_.at(k);
        std::vector<mpfr> row;
        for (std::size_t r = 0; r < roots_.size(); ++r) {
            const root_with_exponent& root = roots_[r];
            mpfr factor = exp(mpfr(logarithm * (root.exponent + 1)));
            for (int s = 0; s < terms_; ++s, factor *= falling) {
                row.push_back(powers_[r].re * factor);
                if (root.at.im != 0) {
                    row.push_back(powers_[r].im * factor);
                }
            }
            powers_[r] = powers_[r] * root.at;
        }
        row.push_back(narrow<mpfr>(series_.c[static_cast<std::size_t>(k)]));
        rows_.push_back(std::move(row));
    }

    const wide_series& series_;
    falling_logarithms& logarithms_;
    std::vector<root_with_exponent> roots_;
    int terms_;
    int last_;
    std::vector<complex_number<mpfr>> powers_;  // w^(last - k) for the next k
    std::vector<std::vector<mpfr>> rows_;
};

/// Whether the amplitude |A_0| of the first root, with the others determined from the coefficients at the same time, is
/// stable to within a quarter from all coefficients to three quarters of the list. Precision: 20 digits more than the
/// coefficients have, since the equations magnify the error of these 20 digits less than the rounding of the
/// coefficients themselves.
inline bool amplitude_stays(const wide_series& series, falling_logarithms& logarithms,
                            const std::vector<root_with_exponent>& roots) {
    const int last = static_cast<int>(series.c.size()) - 1;
    int columns = 0;
    for (const auto& root : roots) {
        columns += root.at.im == 0 ? 1 : 2;
    }
    const int terms = std::clamp(last / 3 / columns, 1, 8);
    const int unknowns = terms * columns;
    const std::array<int, 4> lasts{last, last - 1, last - std::max(2, last / 8), last - std::max(3, last / 4)};
    if (lasts.back() < unknowns) {
        return false;
    }
    amplitude_equations equations(series, logarithms, roots, terms);
    sliding_systems systems(static_cast<std::size_t>(unknowns), mpfr(epsilon<mpfr>() * 64),
                            [&](int k) -> const std::vector<mpfr>& { return equations(k); });
    std::optional<mpfr> whole;
    return systems.solve(lasts, [&](const std::vector<mpfr>& x) {
        const mpfr amplitude =
            roots.front().at.im == 0 ? mpfr(abs(x[0])) : modulus_of(complex_number<mpfr>{x[0], x[1]});
        if (!whole) {
            whole = amplitude;
            return *whole > 0;
        }
        return abs(amplitude - *whole) * 4 < *whole;
    });
}

}  // namespace libration::convergence::fitting
