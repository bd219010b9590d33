// The inverse hyperbolic cosine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// a = acosh x: sqrt(x^2 - 1) a' = x'.
struct acosh_function {
    static constexpr auto kind = function_kind::acosh;
    static constexpr std::string_view name = "acosh";
    static constexpr std::string_view domain = "x >= 1, in series x > 1";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular{1, {1}, "takes acosh of 1, where it has no series"};
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        return q && *q == 1 ? ones(rational(0)) : std::nullopt;
    }
    static constexpr const char* refusal = "takes acosh of a number below 1";
    static range bounds(const number_bounds& x) {
        const range inside = above({1, true}, x, refusal);
        return inside ? range(rising(rounded, *inside)) : std::nullopt;
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return pow(x * x - 1, E(rational(-1, 2)));
    }

    static constexpr rounded_function rounded = mpfr_acosh;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_acosh(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_acosh(y, x, bits);
    }
};

}  // namespace libration::function
