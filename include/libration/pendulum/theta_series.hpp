// The Taylor series of theta about any point of a motion as one quotient of series: omega is a quotient of two theta
// functions, whose Taylor coefficients are cheap.
//
// With the nome q of one of the two axes and s the time since the bottom [DLMF 22.2.5-6, 22.6(iv)]:
//   T* <= K~',  q = e^(-pi K~'/T*),  z = pi s/(2 T*):    cn = c theta_2(z)/theta_4(z),    dn = c theta_3(z)/theta_4(z),
//   K~' < T*,   q = e^(-pi T*/K~'),  z = i pi s/(2 K~'): cn = c theta_4(z)/theta_2(z),    dn = c theta_3(z)/theta_2(z),
// where c makes them 1 at the bottom, so that q <= e^-pi at every energy; the second one is Jacobi's imaginary
// transformation of the first. On the separatrix q = 0 and theta_3/theta_2 is 1/cosh s. omega is 2k cn or 2 rate dn
// (exact_solution.hpp). A time offset from the top instead, z + pi/2 or z + i pi T*/(2 K~') [DLMF 20.2.11-14]:
//   T* <= K~':  cn = -c theta_1/theta_3,             dn = c theta_4/theta_3,
//   K~' < T*:   cn = -c sqrt q (theta_1/i)/theta_3,  dn = c sqrt q theta_2/theta_3,
// with the same c, where all theta_1 and theta_2 are those without their q^(1/4) (theta_taylor.hpp). The poles of omega
// are the zeros of the theta below, and on the circle of convergence neither theta is large.
#pragma once

#include "libration/elliptic/theta_taylor.hpp"
#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/expansion_point.hpp"
#include "libration/pendulum/singularities.hpp"
#include "libration/series/scaled_quotient.hpp"

namespace libration::pendulum {

/// omega of a motion about a phase. Not for equilibria.
template <scalar T>
class theta_series {
public:
    theta_series(const motion& m, const phase<T>& at)
        : librates_(m.regime() == regime::libration), lattice_(singularities<T>(m).value()), side_(at.side) {
        using std::exp;
        const bool critical = lattice_.single_column;
        const int quarter = critical ? 0 : elliptic::quarter_of_four(at.quarter);
        from_top_ = quarter % 2 != 0;
        real_ = critical || certainly_less(lattice_.height, lattice_.effective_period);
        frequency_ = pi<T>() / ((real_ ? lattice_.height : lattice_.effective_period) * 2);
        const T& other = real_ ? lattice_.effective_period : lattice_.height;
        root_ = critical ? T(0) : T(exp(T(-frequency_ * other)));
        offset_ = frequency_ * at.offset * side_;
        amplitude_ = speed_at_bottom(m) * at_zero(below(false)) / at_zero(above(false));
        if (real_ && from_top_) {
            amplitude_ *= root_;
        }
        if (librates_ ? quarter == 1 || quarter == 2 : m.direction() < 0) {
            amplitude_ = -amplitude_;
        }
    }

    /// omega_n scale^n, n = 0 .. N, N >= 0, in the working precision. A product by integers for each coefficient and
    /// term of the thetas, and one quotient of series, of half the length about symmetric points. The error grows by a
    /// power of n: on balls it was below 2^40 epsilon of 8/R up to n = 800, scale = R, at every energy tried.
    series::power_series<T> omega(const T& scale, int order) const {
        auto result = series::power_series<T>::zero(order);
        const elliptic::theta_kind numerator = above(from_top_);
        const elliptic::theta_kind denominator = below(from_top_);
        const int stride = side_ == 0 ? 2 : 1;
        const int first = side_ == 0 && numerator.is_first() ? 1 : 0;
        if (order < first) {
            return result;
        }
        const int count = (order - first) / stride + 1;
        // About the bottom e^x would make one side of the circle of convergence large.
        const int shift = real_ && denominator.odd && side_ != 0 ? 1 : 0;
        const elliptic::theta_argument<T> argument{root_ * root_, offset_, frequency_ * scale, real_, shift};
        const auto part = [&](const elliptic::theta_kind& kind, int from) {
            return series::power_series<T>(elliptic::theta_taylor<T>(kind, argument).coefficients(from, stride, count));
        };
        const series::power_series<T> w = scaled_quotient(part(numerator, first), part(denominator, 0));
        for (int i = 0, n = first; i < count; ++i, n += stride) {
            result[n] = w[i] * (is_negated(n) ? T(-amplitude_) : amplitude_);
        }
        return result;
    }

private:
    elliptic::theta_kind above(bool from_top) const {
        if (!librates_) {
            return !from_top ? elliptic::third_theta : real_ ? elliptic::second_theta : elliptic::fourth_theta;
        }
        return from_top ? elliptic::first_theta : real_ ? elliptic::fourth_theta : elliptic::second_theta;
    }
    elliptic::theta_kind below(bool from_top) const {
        return from_top ? elliptic::third_theta : real_ ? elliptic::second_theta : elliptic::fourth_theta;
    }

    T at_zero(const elliptic::theta_kind& kind) const {
        return elliptic::theta_taylor<T>(kind, {root_ * root_, T(0), T(0), real_}).coefficients(0, 1, 1).front();
    }

    // Without its sign.
    T speed_at_bottom(const motion& m) const {
        if (lattice_.single_column) {
            return T(2);
        }
        const energy_level<T> o = energy_level_of<T>(m);
        return (librates_ ? o.modulus.k : o.time_scale) * 2;
    }

    // The computation is about |offset|: before the quarter odd powers change their sign, and even ones of theta_1.
    bool is_negated(int n) const { return side_ < 0 && (n % 2 != 0) != above(from_top_).is_first(); }

    bool librates_;
    singularity_lattice<T> lattice_;
    int side_;
    bool from_top_;
    bool real_;    // the argument of theta in e^(mx)
    T frequency_;  // x or z over time
    T root_;       // sqrt q
    T offset_;     // |x| or |z|
    T amplitude_;
};

/// a_n scale^n, n = 0 .. N, of theta about a point: omega_{n-1}/n, computed from the exact motion with 64 bits more
/// than T has, which cover the loss of the quotient: within a few epsilon of 8/n if the scale is at most the radius. A
/// quotient of whole series on balls, and in mpfr if the program has enabled it (scaled_quotient), O(N^2) products
/// elsewhere. Not for equilibria. Throws error when N < 0.
template <scalar T>
series::power_series<T> taylor_by_thetas(const exact_solution<T>& solution, const expansion_point& point, int order,
                                         const T& scale) {
    using W = wide_t<T>;
    auto a = series::power_series<T>::zero(order);
    a[0] = solution.at(phase_of(point, solution)).theta;
    if (order == 0) {
        return a;
    }
    series::power_series<W> w;
    {
        const precision_scope wide(decimal_digits(digits<T>() + 64));
        const motion& m = solution.of();
        const W unit = widen(scale);
        w = theta_series<W>(m, phase_of<W>(point, m)).omega(unit, order - 1);
        for (int n = 1; n <= order; ++n) {
            w[n - 1] *= unit;
            w[n - 1] /= n;
        }
    }
    for (int n = 1; n <= order; ++n) {
        a[n] = narrow<T>(w[n - 1]);
    }
    return a;
}

}  // namespace libration::pendulum
