// How much an elliptic function moves when the numbers that were typed move: what no program can be blamed for.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/elliptic/proved/proved_functions.hpp"
#include "libration/scalar/text/written_number.hpp"

namespace libration::elliptic {

/// sum |x df/dx|/|f| over the inputs x as typed, argument, characteristic and modulus or parameter: when each of them
/// is off by a relative epsilon, f is off by up to this many relative epsilon, to first order; a number that is 0 is
/// taken as exact. value(inputs) is f, a ball. Nothing where f is 0 and moves: the condition is infinite there. The
/// derivatives are difference quotients towards 0, which stays inside every domain, over a relative step 2^-s, s half
/// the bits of the working precision. Their relative error is of the size 2^-s f''/f', so this is a heuristic: it fails
/// where the complementary parameter, or at m = 1 the distance of F's amplitude from pi/2, is not far above that step;
/// then its leading digits change with the precision. Cost a value and one for each input. Throws precision_exhausted
/// where the working precision does not tell f from 0.
template <class Value>
std::optional<mpfr> function_condition(const Value& value, const std::vector<exact>& inputs) {
    const long step_bits = digits<ball>() / 2;
    const exact factor = exactly(rational(1 - power_of(2, -step_bits)));
    const ball f = value(inputs);
    ball sum(0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!inputs[i].is_zero()) {
            std::vector<exact> moved = inputs;
            moved[i] = inputs[i] * factor;
            sum += abs(ball(value(moved) - f));
        }
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
