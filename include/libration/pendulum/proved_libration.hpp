// theta and omega of the libration from the top in fixed point: the route of landen_motion if none of k, k' and cos z
// is small and the digits are few, at a third of its cost.
//
// Chain, nome, theta series and return are those of landen_nome.hpp and landen_motion.hpp, with one term of the series
// throughout, and V = 1/X in the return:
//   V_r = scale theta_3(z)/theta_2(z),   V_n = V_{n+1} + (c_n^2/4)/V_{n+1},   tan(theta/4) = c_0/(2 V_1) = s,
//   w_r = b_r scale theta_1(z) theta_4(z)/(scale theta_3(z))^2,
//   w_n = w_{n+1} V_{n+1} (V_{n+1} - (c_n^2/4)/V_{n+1})/V_n^2,
//   omega = -2 c_0 w_1/(1 + s^2),
// w = V'/V^2, theta_1 and theta_2 without the factor 2 P^(1/4). The radius of every operation is tracked
// (fixed_point.hpp); the truncation errors of the series, with u = 2^(-64 n) and e = k_{r+1}/4 <= 2^-l, l >= 5:
//   P = e (1 + 4 e^2) has an error below e 4 k^4/(1 - k^2), k = 4e (landen_nome (1), two terms): below 2^(11 - 5l);
//   P < 1.01 e, so theta_3 and theta_4 have errors of at most 4 P^4 < 2^(3 - 4l), the other two 10 P^6 < 2^(4 - 6l)
//   (landen_nome (2)).
// The chain continues until 4 l >= 64 n + 4: then each is below u, and is counted as u. A chain that is ended earlier
// counts its truncation errors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "libration/pendulum/proved_state.hpp"
#include "libration/scalar/ball/fixed_arithmetic.hpp"

namespace libration::pendulum {

/// One energy, any number of times. Cost: a square root, two products per level, 3 or 4 divisions, and one division per
/// level for a time. Absolute errors: some 2^8 units of 2^-bits(), times max(1, t) in theta. Returns std::nullopt if
/// cos z is small: theta is near 0 there and requires relative digits, which fixed point does not have.
class proved_libration {
public:
    /// Whether it is applicable to an energy and a precision: k^2 and k'^2 in [2^-8, 1), up to 1200 bits.
    static bool serves(const rational& energy, const rational& gap, long bits) {
        return bits <= most_bits && mpq_cmp_ui(energy.backend().data(), 1, 128) >= 0 &&
               mpq_cmp_ui(gap.backend().data(), 1, 128) >= 0;
    }

    /// E and 2-E, exactly, to which it is applicable; a chain of at most this many levels, but enough for l >= 5.
    /// Throws precision_exhausted if a radius grows too wide.
    proved_libration(const rational& energy, const rational& gap, long bits, std::size_t levels = most_levels)
        : n_(static_cast<int>((bits + 63) / 64)),
          cut_(fixed_ball::root_of_half(n_, energy)),
          a_(n_, mp_limb_t{1}),
          b_(fixed_ball::root_of_half(n_, gap)) {
        descend(levels);
        measure(nome());
    }

    long bits() const { return long{64} * n_; }
    /// M: T = 2 pi/M.
    ball mean() const { return mean_.to_ball(); }

    /// theta at z = M t.
    std::optional<ball> theta_at(const ball& z) const {
        ball cosine;
        arb_cos(cosine.handle(), z.handle(), bits());
        if (is_small(cosine)) {
            return std::nullopt;
        }
        const fixed_ball c(n_, cosine);
        const fixed_ball square = c * c;
        fixed_ball v = third_at(square) / (c * second_at(square));
        for (std::size_t n = levels_; n-- > 0;) {
            v = v + steps_[n] / v;
        }
        return angle_of(cut_ / v, cosine);
    }

    /// theta and omega at z = M t.
    std::optional<enclosed_state> state_at(const ball& z) const {
        ball sine;
        ball cosine;
        arb_sin_cos(sine.handle(), cosine.handle(), z.handle(), bits());
        if (is_small(cosine)) {
            return std::nullopt;
        }
        const fixed_ball c(n_, cosine);
        const fixed_ball square = c * c;
        const fixed_ball second = c * second_at(square);
        const fixed_ball first =
            fixed_ball(n_, sine) * ((one() + nome_square_).widen_by(left_out_of_second_) - four_squares_ * square);
        const fixed_ball fourth = (one() + ldexp(nome_, 1)).widen_by(left_out_of_third_) - ldexp(nome_, 2) * square;
        const fixed_ball third = third_at(square);
        fixed_ball slope = b_ * scale_ * first * fourth / (third * third);
        fixed_ball v = third / second;
        for (std::size_t n = levels_; n-- > 0;) {
            const fixed_ball add = steps_[n] / v;
            const fixed_ball next = v + add;
            slope = slope * (v * (v - add)) / (next * next);
            v = next;
        }
        const fixed_ball tangent = cut_ / v;  // 2 tan(theta/4)
        const fixed_ball speed = cut_ * slope / (one() + ldexp(tangent * tangent, -2));
        ball omega = ldexp(speed.to_ball(), 1);
        return enclosed_state{angle_of(tangent, cosine), arf_sgn(arb_midref(sine.handle())) > 0 ? -omega : omega};
    }

private:
    static constexpr long most_bits = 1200;
    static constexpr std::size_t most_levels = 10;

    // Below 2^-4, or not known to 2^-8.
    static bool is_small(const ball& cosine) {
        return arf_cmpabs_2exp_si(arb_midref(cosine.handle()), -4) < 0 ||
               mag_cmp_2exp_si(arb_radref(cosine.handle()), -8) > 0;
    }
    static ball angle_of(const fixed_ball& tangent, const ball& cosine) {
        ball theta = tangent.to_ball();
        arb_mul_2exp_si(theta.handle(), theta.handle(), -1);
        arb_atan(theta.handle(), theta.handle(), tangent.bits());
        arb_mul_2exp_si(theta.handle(), theta.handle(), 2);
        if (arf_sgn(arb_midref(cosine.handle())) < 0) {
            arb_neg(theta.handle(), theta.handle());
        }
        return theta;
    }
    // theta_2/cos z = 1 + P^2 (4 cos^2 - 3) and scale theta_3 = scale (1 + 2 P (2 cos^2 - 1)).
    fixed_ball second_at(const fixed_ball& square) const { return second_ + four_squares_ * square; }
    fixed_ball third_at(const fixed_ball& square) const { return third_ + third_slope_ * square; }
    fixed_ball one() const { return {n_, mp_limb_t{1}}; }

    // 2^exponent in units, at least 1; a value beyond the range of double is too wide.
    double units(long exponent) const {
        if (exponent + bits() > 900) {
            throw precision_exhausted("a nome");
        }
        return std::ldexp(double{1}, static_cast<int>(std::max(0L, exponent + bits())));
    }

    void descend(std::size_t levels);
    fixed_ball nome() const;
    void measure(const fixed_ball& p);

    int n_;
    fixed_ball cut_;  ///< c_0
    fixed_ball a_;
    fixed_ball b_;
    std::size_t levels_ = 0;                     ///< r - 1
    double left_out_of_nome_ = 1;                ///< in units
    double left_out_of_third_ = 1;               ///< and of theta_4
    double left_out_of_second_ = 1;              ///< and of theta_1
    std::array<fixed_ball, most_levels> steps_;  ///< c_n^2/4 of n = 1 .. r-1
    fixed_ball nome_;
    fixed_ball nome_square_;
    fixed_ball four_squares_;
    fixed_ball mean_;
    fixed_ball scale_;
    fixed_ball second_;
    fixed_ball third_;
    fixed_ball third_slope_;
};

// Until one term suffices. e = (a-b)/(4 (a+b)): all a and b are at least b_1 = sqrt(k') >= 1/4, and a > M > 0.35, so
// 4 (a+b) > 2; and it is above 4 if b is found to be at least 5/8.
inline void proved_libration::descend(std::size_t levels) {
    fixed_ball difference = a_ - b_;
    while (levels_ < most_levels) {
        const fixed_ball mean = ldexp(a_ + b_, -1);
        b_ = geometric_mean(a_, b_);
        a_ = mean;
        const fixed_ball next = a_ - b_;
        const long small = next.smallness() + (b_.below() * 8 >= 5 ? 2 : 1);
        if (4 * small >= bits() + 4 || (levels_ >= levels && small >= 5)) {
            left_out_of_nome_ = units(11 - 5 * small);
            left_out_of_third_ = units(3 - 4 * small);
            left_out_of_second_ = units(4 - 6 * small);
            return;
        }
        steps_[levels_++] = ldexp(difference * difference, -4);  // difference is 2 c_n
        difference = next;
    }
    throw precision_exhausted("a nome");
}

inline fixed_ball proved_libration::nome() const {
    const fixed_ball e = ldexp((a_ - b_) / (a_ + b_), -2);
    fixed_ball p = e + ldexp(e * e * e, 2);
    return p.widen_by(left_out_of_nome_);
}

inline void proved_libration::measure(const fixed_ball& p) {
    nome_ = p;
    nome_square_ = p * p;
    four_squares_ = ldexp(nome_square_, 2);
    const fixed_ball at_zero = (one() + ldexp(p, 1)).widen_by(left_out_of_third_);
    const fixed_ball over_third = a_ / at_zero;
    mean_ = over_third / at_zero;
    scale_ = over_third * (one() + nome_square_).widen_by(left_out_of_second_);
    second_ = (one() - (ldexp(nome_square_, 1) + nome_square_)).widen_by(left_out_of_second_);
    third_ = (one() - ldexp(p, 1)).widen_by(left_out_of_third_) * scale_;
    third_slope_ = ldexp(p, 2) * scale_;
}

}  // namespace libration::pendulum
