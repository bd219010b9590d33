// theta and omega of the canonical motion, proved, at the least cost known to us: the mean and a few Landen steps on
// balls, the theta series at the small remaining nome, and back through the levels by products.
//
// Below 2: a_0 = 1, b_0 = k' = sqrt((2-E)/2), c_0 = k = sqrt(E/2), from theta(0) = arccos(1-E).
// Above 2: a_0 = sqrt(E/2), b_0 = sqrt((E-2)/2), c_0 = 1, from theta(0) = pi, counterclockwise.
// In both z = M t, M = agm(a_0, b_0).
//
// The quotient X_n = cd(a_n t, k_n)/a_n has X_r = theta_2(z)/(theta_3(z) scale) at nome P [DLMF 22.2.6, 22.2.8], and
//     X_n = X_{n+1}/(1 + c_n^2/4 X_{n+1}^2)
// from sn(u, k_n) = (1 + k_{n+1}) sn/(1 + k_{n+1} sn^2) [DLMF 22.7.2] at u + K, with (a_n/a_{n+1}) = 1 + k_{n+1} and
// a_{n+1} c_{n+1} = c_n^2/4. As a fraction x/d, and w/d^2 for the derivative of X by t, a level is
//     x <- x d,   d <- d^2 + c_n^2/4 x^2,   w <- w (d^2 - c_n^2/4 x^2);
// at the start w = -b_r scale theta_1(z) theta_4(z): cd' = -k'^2 sn/dn^2 and [DLMF 22.2.4 - 22.2.6]. At level 1
//   libration: tan(theta/4) = c_0 X_1/2, that is sin(theta/2) = c_0 X_0 = k cd,    omega = 2 c_0 w/(d^2 + c_0^2/4 x^2);
//   rotation: theta = pi + 2 psi, (cos psi, sin psi) = (a_0 x d, -w)/(d^2 + c_0^2/4 x^2) = (sn, -cn) at the time from
//   the bottom,   omega = 2 a_0 (d^2 - c_0^2/4 x^2)/(d^2 + c_0^2/4 x^2) = 2 a_0 dn there.
// The libration involves no choice of a branch, |theta/4| < pi/4. In rotation z is reduced by n pi, with any n for
// which it is certainly in (-pi, pi), where psi = atan2 is continuous; theta gains 2 pi n.
#pragma once

#include "libration/elliptic/theta_values.hpp"
#include "libration/pendulum/proved_state.hpp"
#include "libration/scalar/ball/arctangent.hpp"
#include "libration/scalar/ball/fraction.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// One energy, any number of times. The constructor computes everything that depends on the energy alone. A time costs
/// a cosine, an arctangent, one division per level and a few products. Absolute error of theta: about 2^8 units of the
/// working precision times max(1, t M) max(1, log 1/k'); omega near the top of a motion close to E = 2 loses up to
/// log2(1/k') bits, k'^2 = |2-E|/2 or |2-E|/E. A low precision only widens: the result is always proved. Use it in a
/// precision_scope of the size in which it was constructed.
class landen_motion {
public:
    /// E and 2-E, exactly; with fewer steps if `most` is given. Throws error at E <= 0 and at E = 2, error if they do
    /// not add up to 2, precision_exhausted if the working precision is too low even for a nome.
    landen_motion(const rational& energy, const rational& gap, const elliptic::nome_steps& most = {})
        : rotates_(gap < 0),
          half_energy_(half(checked(energy, gap))),
          half_gap_(half(abs(gap))),
          widest_(rotates_ ? sqrt(half_energy_) : ball(1)),
          cut_(rotates_ ? ball(1) : sqrt(half_energy_)),
          nome_(widest_, sqrt(half_gap_), rotates_ ? ball(1) / 4 : half_energy_ / 4, most) {}

    /// Throws error unless E and 2-E add up to 2, error at E <= 0 and at E = 2.
    static void require_energies(const rational& energy, const rational& gap) {
        const auto* e = energy.backend().data();
        const auto* g = gap.backend().data();
        integer sum = 0;  // in lowest terms the two have the same denominator
        mpz_add(sum.backend().data(), mpq_numref(e), mpq_numref(g));
        mpz_submul_ui(sum.backend().data(), mpq_denref(e), 2);
        const bool add_up = mpz_cmp(mpq_denref(e), mpq_denref(g)) == 0 && sum.is_zero();
        if (!add_up) {
            throw error(error_kind::argument, error_subject::energy, energy.str(),
                        "and the gap " + gap.str() + " do not add up to 2");
        }
        if (energy.sign() <= 0 || gap.is_zero()) {
            throw error(error_kind::argument, error_subject::energy, energy.str(), "has no period");
        }
    }

    /// M: T = 2 pi/M below 2, pi/M above (one turn).
    const ball& mean() const { return nome_.mean(); }
    /// z = M t of an exact time.
    ball phase_at(const rational& time) const { return times(mean(), time, nome_.bits()); }

    /// theta alone, cheaper than both below 2.
    ball theta_at(const ball& z) const {
        if (rotates_) {
            return state_at(z).theta;
        }
        const ball cosine = cos(z);
        auto values = thetas_at(nome_, cosine, nullptr);
        ball denominator = values.third * nome_.scale();
        if (binary_exponent(cosine) < -8 || contains_zero(cosine)) {
            const fraction at = risen({values.second, denominator, ball()}, false);
            return quarter_angle(at.x * cut_, at.d) * 4;
        }
        // V = 1/X: V_n = V_{n+1} + (c_n^2/4)/V_{n+1}.
        ball inverse = denominator / values.second;
        for (int n = nome_.levels() - 1; n >= 1; --n) {
            inverse += elliptic::landen_nome::quotient(nome_.step(n), inverse, nome_.bits());
        }
        return quarter_angle(cut_, inverse) * 4;
    }

    /// theta and omega.
    enclosed_state state_at(const ball& z) const {
        const integer turns = rotates_ ? nearest_integer(z / pi<ball>()) : integer(0);
        const ball rest = rotates_ ? reduced(z, turns) : z;
        ball sine;
        ball cosine;
        arb_sin_cos(sine.handle(), cosine.handle(), rest.handle(), nome_.bits());
        auto values = thetas_at(nome_, cosine, &sine);
        const ball slope = -(values.first * values.fourth * nome_.last_b() * nome_.scale());
        const fraction at = risen({values.second, values.third * nome_.scale(), slope}, true);
        const ball square = at.d * at.d;
        const ball add = nome_.step(0) * (at.x * at.x);
        const ball sum = square + add;
        if (!rotates_) {
            return {quarter_angle(at.x * cut_, at.d) * 4, at.w * cut_ * 2 / sum};
        }
        const ball psi = angle_of_point(-at.w, at.x * at.d * widest_, nome_.bits());
        return {psi * 2 + pi<ball>() * from_rational<ball>(rational(turns * 2 + 1)),
                (square - add) / sum * widest_ * 2};
    }

private:
    // X = x/d and its derivative w/d^2.
    struct fraction {
        ball x;
        ball d;
        ball w;
    };

    static ball half(const rational& q) { return ldexp(from_rational<ball>(q), -1); }
    static const rational& checked(const rational& energy, const rational& gap) {
        require_energies(energy, gap);
        return energy;
    }

    // theta/4 from twice its tangent.
    ball quarter_angle(const ball& y, const ball& x) const {
        return arctangent_of_quotient(y, ldexp(x, 1), nome_.bits());
    }

    // z - turns pi, proved inside (-pi, pi).
    static ball reduced(const ball& z, const integer& turns) {
        ball rest = z - pi<ball>() * from_rational<ball>(rational(turns));
        if (!certainly_less(abs(rest), pi<ball>())) {
            throw precision_exhausted("the number of turns at a time");
        }
        return rest;
    }

    // From the last level to level 1.
    fraction risen(fraction at, bool with_slope) const {
        for (int n = nome_.levels() - 1; n >= 1; --n) {
            const ball add = nome_.step(n) * (at.x * at.x);
            const ball square = at.d * at.d;
            at.x *= at.d;
            at.d = square + add;
            if (with_slope) {
                at.w *= square - add;
            }
        }
        return at;
    }

    bool rotates_;
    ball half_energy_;
    ball half_gap_;
    ball widest_;  ///< a_0
    ball cut_;     ///< c_0
    elliptic::landen_nome nome_;
};

}  // namespace libration::pendulum
