// The uniform resummation: the nearest P pairs of columns of singularities exactly, the rest as a series about the top.
//
// theta(t) is a sum over columns of separatrix solutions [separatrix_sum.hpp]. With the columns +-(2p+1) T*, p < P, in
// closed form, the singularities of the rest nearest to the top are +-(2P+1) T* +- i K~', so that the partial sum to
// x^N converges on [0, T*] exactly at the rate
//     (T*/|(2P+1) T* + i K~'|)^N <= (2P+1)^-N,   3^-N for P = 1, at every energy except 0 and 2,
// while that of the series and of the paper's resummation, (T*/|T* + i K~'|)^N, tends to 1 at the separatrix. Theorem U
// [uniform_remainder.hpp] bounds the error by 4.5e-17 (rotation: 1.4e-16) with 16 powers, n <= 32 (31), whatever E.
//
// This error is absolute. At tiny energies a column is 2 gd(y), up to pi, while theta is sqrt(2E): its relative digits
// cancel, as they do in the truncation error. There the plain series is better, whose rate T*/R is itself below
// 1/3 where E < 0.0044 or E > 904 and which preserves the relative digits; between, theta is above 0.09 and at most one
// digit is lost.
#pragma once

#include <utility>
#include <vector>

#include "libration/pendulum/uniform_remainder.hpp"
#include "libration/scalar/compiled.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/arithmetic.hpp"

namespace libration::pendulum {

/// theta as a function of x = t/T* on the fundamental arc from the top to the bottom, with its slope in x: the
/// canonical motions of arc_of(). Constructed by uniform_from_top(). An ulp or two of absolute error; on balls, proved
/// for |x| <= 1. O(N + P).
template <scalar T>
class uniform_resummation {
public:
    /// rest: b_0 .. b_N by uniform_remainder(); constants: b_0 + k pi with the term of theorem U's identity, k = -2P ..
    /// 2P.
    uniform_resummation(regime r, T half_distance, int columns, const series::power_series<T>& rest,
                        std::vector<T> constants)
        : bounds_{parity_from_top(r), columns},
          order_(rest.order()),
          half_distance_(std::move(half_distance)),
          constants_(std::move(constants)) {
        std::vector<T> in_square;
        in_square.reserve(static_cast<std::size_t>(order_) / 2 + 1);
        in_square.push_back(bounds_.parity <= order_ && bounds_.parity == 1 ? rest[1] : T(0));
        for (int n = bounds_.parity + 2; n <= order_; n += 2) {
            in_square.push_back(rest[n]);
        }
        in_square_ = series::power_series<T>(std::move(in_square));
    }

    /// N, the last power kept.
    int order() const { return order_; }
    const uniform_bounds<T>& bounds() const { return bounds_; }

    /// The partial sum itself: on balls its own value, not that of theta, whose remainder is not enclosed.
    uniform_resummation partial_sum() const {
        uniform_resummation alone = *this;
        alone.encloses_theta_ = false;
        return alone;
    }

    /// At the fraction x of T* after the top.
    series::jet<T> operator()(const T& x) const { return at(x, T(1 - x)); }

    /// At the fraction `away` of T* before the bottom: preserves the digits of a small `away`, which near E = 2 are
    /// many, because T* is long.
    series::jet<T> before_bottom(const T& away) const { return at(T(1 - away), away); }

    /// The value alone.
    T value(const T& x) const { return (*this)(x).value; }

private:
    // 2 gd(s) = pi pis + 4 atan(tangent), |tangent| < 1/2 for s > -1, and its derivative.
    struct column {
        int pis;
        T tangent;
        T slope;
    };
    static column column_at(const T& s) {
        using std::exp;
        using std::tanh;
        const T e = exp(-s);
        const T slope = e * 4 / (1 + e * e);
        if (certainly_less(T(1), s)) {
            return {1, -e, slope};
        }
        return {0, tanh(s / 2), slope};
    }

    series::jet<T> at(const T& x, const T& away) const {
        using std::atan;
        series::jet<T> sum = rest_at(x);
        const bool rotates = bounds_.parity == 1;
        int pis = 0;
        T part(0);
        T slope(0);
        for (int p = 0; p < bounds_.columns; ++p) {
            const int sign = rotates || p % 2 == 0 ? 1 : -1;
            const int mirrored = rotates ? -sign : sign;
            const column left = column_at(T(half_distance_ * (x + (2 * p + 1))));
            const column right = column_at(T(half_distance_ * (away + 2 * p)));
            pis += left.pis * sign + right.pis * mirrored;
            // Two arctangents as one, with the tangent of their sum: the angles are below pi/4.
            const T first = left.tangent * sign;
            const T second = right.tangent * mirrored;
            part += atan((first + second) / (1 - first * second)) * 4;
            slope += left.slope * sign - right.slope * mirrored;
        }
        const int place = pis + 2 * bounds_.columns;
        sum.value += part + constants_[static_cast<std::size_t>(place)];
        sum.slope += slope * half_distance_;
        if (proved_scalar<T> && encloses_theta_) {
            const series::jet<T> left_out = proved_remainder(x);
            return {enclose(sum.value, left_out.value), enclose(sum.slope, left_out.slope)};
        }
        return sum;
    }

    series::jet<T> proved_remainder(const T& x) const {
        using std::abs;
        if (certainly_less(T(1), T(abs(x)))) {
            throw error(error_kind::argument, "fraction of T*", "", "is above 1, the limit of theorem U");
        }
        return bounds_.remainder(order_, x);
    }

    // sum_n b_n x^n without the constant.
    series::jet<T> rest_at(const T& x) const {
        const T square = x * x;
        const series::jet<T> sum = evaluate(in_square_, square);
        if (bounds_.parity == 0) {
            return {sum.value, sum.slope * x * 2};
        }
        return {sum.value * x, sum.value + sum.slope * square * 2};
    }

    uniform_bounds<T> bounds_;
    bool encloses_theta_ = true;
    int order_;
    T half_distance_;
    std::vector<T> constants_;
    series::power_series<T> in_square_;  ///< b_n over x^2, without b_0
};

/// The uniform resummation of a motion to the power N. y and all b_n are computed in more digits and rounded once.
/// O(N digits/(P y)) for the coefficients. Throws error at E = 0, where the columns are infinitely many,
/// and at E = 2, where there is no top, and error when P < 1 or N < 0.
template <scalar T>
uniform_resummation<T> uniform_from_top(const motion& m, int order, int columns = 1) {
    using W = wide_t<T>;
    if (m.regime() == regime::stable_equilibrium) {
        throw error(error_kind::argument, error_subject::energy, "0", "has infinitely many columns of singularities");
    }
    W half_distance;
    series::power_series<W> wide;
    std::vector<W> wide_constants;
    {
        constexpr long guard_bits = 32;
        const precision_scope scope(decimal_digits(digits<T>() + guard_bits));
        half_distance = half_column_distance(energy_level_of<W>(m));
        wide = uniform_remainder(m.regime(), half_distance, columns, order);
        const int own = m.regime() == regime::rotation || columns % 2 == 0 ? 1 : -1;
        wide_constants.reserve(4 * static_cast<std::size_t>(columns) + 1);
        for (int k = -2 * columns; k <= 2 * columns; ++k) {
            wide_constants.push_back(wide[0] + pi<W>() * (own + k));
        }
    }
    std::vector<T> rest;
    rest.reserve(wide.coefficients().size());
    for (const W& b : wide.coefficients()) {
        rest.push_back(narrow<T>(b));
    }
    std::vector<T> constants;
    constants.reserve(wide_constants.size());
    for (const W& c : wide_constants) {
        constants.push_back(narrow<T>(c));
    }
    return {m.regime(), narrow<T>(half_distance), columns, series::power_series<T>(std::move(rest)),
            std::move(constants)};
}

// Compiled once, in libration::libration.
#ifdef LIBRATION_COMPILED
#define LIBRATION_DECLARE(T) extern template uniform_resummation<T> uniform_from_top(const motion&, int, int);
LIBRATION_FOR_ROUNDING_SCALARS(LIBRATION_DECLARE)
#undef LIBRATION_DECLARE
#endif

}  // namespace libration::pendulum
