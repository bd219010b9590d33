// The sensitivity of an elliptic function to its input numbers: the error that no program can avoid.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/elliptic/proved_functions.hpp"
#include "libration/number/written_number.hpp"

namespace libration::elliptic {

/// sum |x df/dx|/|f| over the inputs x as given, argument, characteristic and modulus or parameter: if each of them has
/// a relative error epsilon, f has a relative error of up to this many epsilon, to first order; an input 0 is taken as
/// exact. value(inputs) is f, a ball. Returns std::nullopt if f is 0 and not constant: the condition is infinite there.
/// The derivatives are difference quotients towards 0, which stays inside every domain, over a relative step 2^-s, s
/// half the bits of the working precision. Their relative error is of the size 2^-s f''/f', so this is a heuristic: it
/// fails if the complementary parameter, or at m = 1 the distance of F's amplitude from pi/2, is not far above that
/// step; then its leading digits change with the precision. Cost: one evaluation plus one per input. Throws
/// precision_exhausted if the working precision does not distinguish f from 0.
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
        throw precision_exhausted("the condition of a function near a zero");
    }
    return midpoint_of(ball(ldexp(sum, step_bits) / abs(f)));
}

/// function_condition() of a complex f, |f| its modulus: sum |x df/dx|/|f| over the inputs, with the real and the
/// imaginary part of the argument as two inputs. value(inputs) is f as complex_parts.
template <class Value>
std::optional<mpfr> complex_function_condition(const Value& value, const std::vector<exact>& inputs) {
    const long step_bits = digits<ball>() / 2;
    const exact factor = exactly(rational(1 - power_of(2, -step_bits)));
    const auto modulus = [](const ball& real, const ball& imaginary) {
        const mpfr x = midpoint_of(real);
        const mpfr y = midpoint_of(imaginary);
        return mpfr(sqrt(mpfr(x * x + y * y)));
    };
    const auto f = value(inputs);
    mpfr sum(0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!inputs[i].is_zero()) {
            std::vector<exact> moved = inputs;
            moved[i] = inputs[i] * factor;
            const auto there = value(moved);
            sum += modulus(ball(there.real - f.real), ball(there.imaginary - f.imaginary));
        }
    }
    if (contains_zero(f.real) && contains_zero(f.imaginary)) {
        if (is_exact(f.real) && is_exact(f.imaginary)) {
            return sum == 0 ? std::optional(mpfr(0)) : std::nullopt;
        }
        throw precision_exhausted("the condition of a function near a zero");
    }
    return mpfr(ldexp(sum, static_cast<int>(step_bits)) / modulus(f.real, f.imaginary));
}

}  // namespace libration::elliptic
