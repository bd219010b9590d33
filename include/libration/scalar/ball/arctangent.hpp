// The angle of a quotient of balls by Gaussian primes [Johansson2022], from 1400 bits on; twice as fast as Arb from
// 2000 to 10^4 bits.
//
// The point is rotated towards the axis (ball_turned_point.hpp), the remaining angle has a short series
// (ball_arctangent_series.hpp), and both are balls, so the right-hand side of
//     arctan(y/x) = sum e_j alpha_j + arctan(y'/x')   mod pi
// is enclosed. Two balls are tested: the right-hand side is within (-2, 2), and y/x within (-1, 1), so the left-hand
// side is within (-pi/4, pi/4). They differ by less than pi, so they are equal.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "libration/scalar/ball/arctangent_series.hpp"
#include "libration/scalar/ball/turned_point.hpp"

namespace libration {

/// The precisions from which Gaussian primes, and the finer relations, are faster.
inline constexpr slong bits_for_primes = 1400;
inline constexpr slong bits_for_fine_relations = 6000;

/// arctan(y/x) by Gaussian primes, for 2^-9 < |y/x| < 1; std::nullopt for others and for very wide balls.
inline std::optional<ball> angle_by_primes(const ball& y, const ball& x, slong bits) {
    // Per thread: with a shared one, other threads would wait indefinitely for a thread that a failure of FLINT keeps
    // in here.
    thread_local const bool known = turned_point::angles_are_known();
    ball ratio;
    arb_div(ratio.handle(), y.handle(), x.handle(), slong{64});
    const long size = is_finite(ratio) ? binary_exponent(ratio) : 1;
    if (!known || size > 0 || size < -8 || arb_rel_accuracy_bits(ratio.handle()) < 16) {
        return std::nullopt;
    }
    // Fewer guard bits than the cosine of FLINT uses, which then has computed the angles.
    const slong kept = std::min({bits, arb_rel_accuracy_bits(y.handle()), arb_rel_accuracy_bits(x.handle())}) + 24;
    turned_point point(y, x, kept);
    point.turn(coarse_relations, coarse_scale);
    if (kept > bits_for_fine_relations) {
        point.turn(fine_relations, fine_scale);
    }
    const ball rough = point.tangent(slong{32});
    const long small = is_finite(rough) ? -binary_exponent(rough) : 0;
    if (small < 9) {
        return std::nullopt;
    }
    const slong enough = std::max(kept - small, slong{32});
    ball angle = small_arctangent(point.tangent(enough), enough).value();
    arb_add(angle.handle(), angle.handle(), point.taken().handle(), bits);
    if (binary_exponent(angle) > 1) {
        return std::nullopt;
    }
    return angle;
}

/// arctan(y/x) of balls, to this number of bits; without bounds if x may be 0. By Gaussian primes where they apply and
/// are faster, otherwise by Arb. Cost: half of Arb's division and arctangent from 2000 to 10^4 bits. Radius: the
/// propagated radius of the arguments plus one rounding.
inline ball arctangent_of_quotient(const ball& y, const ball& x, slong bits) {
    if (bits >= bits_for_primes) {
        if (auto angle = angle_by_primes(y, x, bits)) {
            return *std::move(angle);
        }
    }
    ball result;
    arb_div(result.handle(), y.handle(), x.handle(), bits);
    arb_atan(result.handle(), result.handle(), bits);
    return result;
}

/// The angle of the point (x, y), as atan2, to this number of bits: from the nearer axis by Gaussian primes where they
/// apply and are faster, otherwise by Arb.
inline ball angle_of_point(const ball& y, const ball& x, slong bits) {
    const bool steep = arf_cmpabs(arb_midref(y.handle()), arb_midref(x.handle())) > 0;
    const ball& along = steep ? y : x;
    if (bits >= bits_for_primes && !contains_zero(along) && (steep || !contains_zero(y))) {
        if (auto angle = steep ? angle_by_primes(-x, y, bits) : angle_by_primes(y, x, bits)) {
            // From the positive x axis, or by a quarter or half a turn towards y.
            const int quarters = steep ? 1 : arb_is_positive(x.handle()) != 0 ? 0 : 2;
            ball turn;
            arb_const_pi(turn.handle(), bits + 8);
            turn = ldexp(quarters == 0 ? ball(0) : turn, quarters - 2);
            arb_add(angle->handle(), angle->handle(), (arb_is_positive(y.handle()) != 0 ? turn : -turn).handle(), bits);
            return *std::move(angle);
        }
    }
    ball result;
    arb_atan2(result.handle(), y.handle(), x.handle(), bits);
    return result;
}

}  // namespace libration
