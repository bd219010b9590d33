// How much an elliptic function moves when the numbers that were typed move: what no program can be blamed for.
#pragma once

#include <optional>

#include "libration/elliptic/proved/proved_functions.hpp"
#include "libration/scalar/text/written_number.hpp"

namespace libration::elliptic {

/// (|u df/du| + |x df/dx|)/|f|: when the argument u and the modulus or parameter x, as typed, are each off by a
/// relative epsilon, f is off by up to this many relative epsilon, to first order; a number that is 0 is taken as
/// exact. value(u, x) is f, a ball. Nothing where f is 0 and moves: the condition is infinite there. The derivatives
/// are difference quotients towards 0, which stays inside every domain, over a relative step 2^-s, s half the bits of
/// the working precision. Their relative error is of the size 2^-s f''/f', so this is a heuristic: it fails where the
/// complementary parameter, or at m = 1 the distance of F's amplitude from pi/2, is not far above that step; then its
/// leading digits change with the precision. Cost three values. Throws precision_exhausted where the working precision
/// does not tell f from 0.
template <class Value>
std::optional<mpfr> function_condition(const Value& value, const exact& u, const exact& x) {
    const long step_bits = digits<ball>() / 2;
    const exact factor = exactly(rational(1 - power_of(2, -step_bits)));
    const ball f = value(u, x);
    ball sum(0);
    if (!u.is_zero()) {
        sum += abs(ball(value(u * factor, x) - f));
    }
    if (!x.is_zero()) {
        sum += abs(ball(value(u, x * factor) - f));
    }
    if (is_exact(sum) && contains_zero(sum)) {
        return mpfr(0);
    }
    if (is_exact(f) && contains_zero(f)) {
        return std::nullopt;
    }
    if (contains_zero(f)) {
        throw precision_exhausted("the condition of a function next to a zero");
    }
    return midpoint_of(ball(ldexp(sum, step_bits) / abs(f)));
}

}  // namespace libration::elliptic
