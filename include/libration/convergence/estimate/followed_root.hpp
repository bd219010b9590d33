// Roots of polynomials that change a little: starts, Newton's iteration, and how uncertain a root is that was followed
// from fewer coefficients to more.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "libration/algebra/polynomial_roots.hpp"

namespace libration::convergence::fitting {

/// How uncertain a value is.
struct leftover {
    mpfr safe;    ///< what the last steps do not exceed: for choosing between degrees
    mpfr likely;  ///< the error that their decrease leaves
};

/// evaluate() of polynomial_roots.hpp at many points, without its temporaries, and on the real axis in real numbers.
class polynomial_values {
public:
    explicit polynomial_values(const series::power_series<mpfr>& p) : p_(p) {
        sizes_.reserve(p.coefficients().size());
        for (const mpfr& a : p.coefficients()) {
            sizes_.push_back(abs(a));
        }
    }

    polynomial_value<mpfr> at(const complex_number<mpfr>& z) const {
        const mpfr size = modulus_of(z);
        polynomial_value<mpfr> at{{p_[p_.order()]}, {mpfr(0)}, sizes_.back()};
        for (int n = p_.order() - 1; n >= 0; --n) {
            if (z.im == 0) {
                horner_step(at.slope.re, z.re, at.value.re);
                horner_step(at.value.re, z.re, p_[n]);
            } else {
                turn(at.slope, z);
                at.slope.re += at.value.re;
                at.slope.im += at.value.im;
                turn(at.value, z);
                at.value.re += p_[n];
            }
            horner_step(at.rounding, size, sizes_[static_cast<std::size_t>(n)]);
        }
        at.rounding *= epsilon<mpfr>() * (4 * p_.order());
        return at;
    }

private:
    // value *= z, as the operator of complex numbers rounds.
    static void turn(complex_number<mpfr>& value, const complex_number<mpfr>& z) {
        mpfr across = value.re;
        across *= z.im;
        value.re *= z.re;
        mpfr square = value.im;
        square *= z.im;
        value.re -= square;
        value.im *= z.re;
        value.im += across;
    }

    const series::power_series<mpfr>& p_;
    std::vector<mpfr> sizes_;
};

/// Newton's iteration for a root of p from a good start; nothing where it does not settle. A real start stays real.
inline std::optional<complex_number<mpfr>> polished(const series::power_series<mpfr>& p, complex_number<mpfr> z) {
    constexpr int most_steps = 60;
    const mpfr fine = epsilon<mpfr>() * 16;
    const polynomial_values values(p);
    for (int step = 0; step < most_steps; ++step) {
        const auto at = values.at(z);
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

/// Roots with im >= 0 by growing modulus, as starts for Newton, found in the arithmetic S. Nothing where S does not
/// tell every root to a thousandth of its size, or a conjugate pair from two real ones.
template <rounding_scalar S>
std::optional<std::vector<complex_number<mpfr>>> roots_in(const series::power_series<mpfr>& p) {
    auto rounded = series::power_series<S>::zero(p.order());
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
inline std::vector<complex_number<mpfr>> starting_roots(const series::power_series<mpfr>& p) {
    auto found = roots_in<long double>(p);
    if (!found) {
        const precision_scope scope(40);
        found = roots_in<mpfr>(p);
    }
    return found ? *std::move(found) : std::vector<complex_number<mpfr>>{};
}

/// The lists that a root is followed through, by how many coefficients they have less: 0, 1, 2, 3, then s and 2 s, s an
/// eighth of all or what the degree can spare.
inline std::vector<int> fewer_coefficients(int count, int needed) {
    const int eighth = std::max(2, std::min(count / 8, (count - needed) / 2));
    return {0, 1, 2, 3, eighth, 2 * eighth};
}

/// The error of a value x_0 from x_1, x_2, ... with the fewer coefficients of fewer_coefficients(); s = fewer[4].
///
/// An error that falls like rho^K makes |x_0 - x_s| and |x_0 - x_2s| differ by rho^s. Then each of the last steps
/// leaves |x_(j-1) - x_j| rho^j/(1 - rho), where rho is not taken for smaller than these steps themselves show:
/// where they are rounding they do not shrink. Where the two hardly differ the error falls like a power of 1/K
/// and is 8 |x_0 - x_s|, for s = K/8 the error of a fall like 1/K; or it is rounding alone, as large in one step
/// as in s of them.
inline leftover left_after(const std::vector<complex_number<mpfr>>& x, int s) {
    const auto apart = [&](std::size_t i, std::size_t j) { return modulus_of(x[i] - x[j]); };
    const std::array<mpfr, 3> steps{apart(0, 1), apart(1, 2), apart(2, 3)};
    const mpfr largest = std::max({steps[0], steps[1], steps[2]});
    const mpfr middle = apart(0, 4);
    const mpfr far = apart(0, 5);
    if (far <= middle * 6) {
        const bool rounding = s > 3 && middle < largest * 2;
        const mpfr slow = std::max({middle, largest, far}) * (rounding ? 2 : 8);
        return {slow, slow};
    }
    const mpfr second = std::max(std::min(steps[0], steps[1]), std::min(std::max(steps[0], steps[1]), steps[2]));
    const mpfr safe = std::max(second, mpfr(middle * middle * 2 / far));
    const mpfr seen = steps[2] == 0 ? mpfr(0) : mpfr(sqrt(mpfr(steps[0] / steps[2])));
    const mpfr rate = std::max(mpfr(exp(log(mpfr(middle / far)) / s)), seen);
    if (rate >= 1) {
        return {safe, safe};
    }
    const mpfr likely =
        std::max({mpfr(steps[0]), mpfr(steps[1] * rate), mpfr(steps[2] * rate * rate)}) * rate / (1 - rate);
    return {safe, std::min(likely, safe)};
}

}  // namespace libration::convergence::fitting
