// Roots of polynomials that change slightly: initial guesses, Newton's iteration, and the uncertainty of a root that
// was followed from fewer coefficients to more.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "libration/algebra/polynomial_roots.hpp"

namespace libration::convergence::fitting {

/// The uncertainty of a value.
struct leftover {
    mpfr safe;    ///< an upper estimate of the last steps: for choosing between degrees
    mpfr likely;  ///< the remaining error, from the decrease of the steps
};

/// p and p' at many points, in the working precision, which is that of p: without the temporaries of evaluate() in
/// polynomial_roots.hpp. On the real axis by Horner's rule; elsewhere by division by the real quadratic that is 0 at z
/// and at its conjugate [Knuth, 4.6.4], half the products, which loses the digits of |z|/|im z|.
class polynomial_values {
public:
    /// p is stored by reference.
    explicit polynomial_values(const series::power_series<mpfr>& p) : a_(p.coefficients()) {}
    explicit polynomial_values(series::power_series<mpfr>&&) = delete;

    struct value_and_slope {
        complex_number<mpfr> value;
        complex_number<mpfr> slope;
    };

    value_and_slope at(const complex_number<mpfr>& z) const {
        return z.im == 0 ? on_real_axis(z.re) : beside_real_axis(z);
    }

    /// An estimate of the rounding error of a value at a point of this modulus: eps 4 n sum |a_i| |z|^i.
    mpfr rounding_at(const mpfr& size) const {
        mpfr sum(0);
        for (auto n = a_.size(); n-- > 0;) {
            horner_step(sum, size, mpfr(abs(a_[n])));
        }
        sum *= epsilon<mpfr>() * (4 * (static_cast<int>(a_.size()) - 1));
        return sum;
    }

private:
    value_and_slope on_real_axis(const mpfr& x) const {
        mpfr value(0);
        mpfr slope(0);
        for (auto n = a_.size(); n-- > 0;) {
            horner_step(slope, x, value);
            horner_step(value, x, a_[n]);
        }
        return {{value, mpfr(0)}, {slope, mpfr(0)}};
    }

    // p = (t^2 - 2 re t + |z|^2) quotient + before (t - 2 re) + last, and the same for the quotient.
    value_and_slope beside_real_axis(const complex_number<mpfr>& z) const {
        const mpfr square = z.re * z.re + z.im * z.im;
        division of_p(mpfr(z.re * 2), square);
        division of_quotient = of_p;
        for (auto n = a_.size(); n-- > 0;) {
            of_p.take(a_[n]);
            if (n >= 2) {
                of_quotient.take(of_p.last);
            }
        }
        const mpfr along = of_quotient.last - z.re * of_quotient.before;
        return {{mpfr(of_p.last - z.re * of_p.before), mpfr(z.im * of_p.before)},
                {mpfr(of_p.before - z.im * z.im * of_quotient.before * 2), mpfr(z.im * along * 2)}};
    }

    // The last two coefficients of a division by t^2 - twice t + square.
    struct division {
        division(mpfr of_twice, mpfr of_square) : twice(std::move(of_twice)), square(std::move(of_square)) {}
        mpfr twice;
        mpfr square;
        mpfr last = mpfr(0);
        mpfr before = mpfr(0);
        mpfr product = mpfr(0);
        // last, before = next + twice last - square before, last.
        void take(const mpfr& next) {
            before *= square;
            before -= next;
            swap(before, last);
            mpfr_mul(handle(product), handle(twice), handle(before), MPFR_RNDN);
            mpfr_sub(handle(last), handle(product), handle(last), MPFR_RNDN);
        }
    };

    const std::vector<mpfr>& a_;
};

/// |z|^2.
inline mpfr square_of_modulus(const complex_number<mpfr>& z) { return z.re * z.re + z.im * z.im; }

/// A simple root of p by Newton's iteration from a good initial guess, in the working precision, which is that of p. It
/// ends when a step is so small that the next one, which squares it, is below rounding, when the value is, or, for
/// `way_alone`, when the displacement from the initial guess is known to twelve digits: a step of 10^-4 of it leaves
/// (10^-4)^3. Returns std::nullopt if none of these occurs. A real initial guess stays real.
inline std::optional<complex_number<mpfr>> polished(const series::power_series<mpfr>& p,
                                                    const complex_number<mpfr>& start, bool way_alone = false) {
    constexpr int most_steps = 50;
    constexpr int part_of_way = 100'000'000;
    // The square of eps^(11/20): squaring a step of that size leaves a factor eps^(1/10) for the curvature of p.
    const mpfr fine = ldexp(mpfr(1), -digits<mpfr>() * 11 / 10);
    const polynomial_values values(p);
    complex_number<mpfr> z{narrow<mpfr>(start.re), narrow<mpfr>(start.im)};
    const mpfr size = square_of_modulus(z);
    const mpfr rounding = values.rounding_at(mpfr(sqrt(size)));
    for (int step = 0; step < most_steps; ++step) {
        const auto at = values.at(z);
        if (at.slope.re == 0 && at.slope.im == 0) {
            return std::nullopt;
        }
        const auto by = at.value / at.slope;
        z = z - by;
        const mpfr square = square_of_modulus(by);
        if (square <= size * fine || square_of_modulus(at.value) <= rounding * rounding ||
            (way_alone && square * part_of_way <= square_of_modulus(z - start))) {
            return z;
        }
    }
    return std::nullopt;
}

/// Roots with im >= 0 by increasing modulus, as initial guesses for Newton's iteration, computed in the arithmetic S.
/// Returns std::nullopt if S does not resolve every root to a thousandth of its size, or does not distinguish a
/// conjugate pair from two real roots.
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

/// These roots in long double, or in 40 digits if that is not sufficient; empty if neither suffices.
inline std::vector<complex_number<mpfr>> starting_roots(const series::power_series<mpfr>& p) {
    auto found = roots_in<long double>(p);
    if (!found) {
        const precision_scope scope(40);
        found = roots_in<mpfr>(p);
    }
    return found ? *std::move(found) : std::vector<complex_number<mpfr>>{};
}

/// The lists that a root is followed through, by the number of coefficients left out: 0, 1, 2, 3, then s and 2 s, s an
/// eighth of all or as many as the degree can spare.
inline std::vector<int> fewer_coefficients(int count, int needed) {
    const int eighth = std::max(2, std::min(count / 8, (count - needed) / 2));
    return {0, 1, 2, 3, eighth, 2 * eighth};
}

/// The error of a value x_0 from x_1, x_2, ... with the fewer coefficients of fewer_coefficients(); s = fewer[4].
///
/// An error that falls like rho^K makes |x_0 - x_s| and |x_0 - x_2s| differ by rho^s. Then each of the last steps
/// leaves |x_(j-1) - x_j| rho^j/(1 - rho), where rho is not taken smaller than the ratio of these steps: if they are
/// rounding errors they do not shrink. If the two hardly differ, the error falls like a power of 1/K and is 8 |x_0 -
/// x_s|, for s = K/8 the error of a decay like 1/K; or it is rounding alone, as large in one step as in s of them.
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
