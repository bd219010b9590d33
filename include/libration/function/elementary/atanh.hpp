// The inverse hyperbolic tangent.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// a = atanh x: (1 - x^2) a' = x'.
struct atanh_function {
    static constexpr auto kind = function_kind::atanh;
    static constexpr std::string_view name = "atanh";
    static constexpr std::string_view domain = "-1 < x < 1";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static constexpr const char* refusal = "takes atanh of a number that is not between -1 and 1";
    static range bounds(const number_bounds& x) {
        const range inside = above({-1, false}, x, refusal) ? below({1, false}, x, refusal) : std::nullopt;
        return inside ? range(rising(rounded, *inside)) : std::nullopt;
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return 1 / (1 - x * x);
    }

    static constexpr rounded_function rounded = mpfr_atanh;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_atanh(y, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_atanh(y, x, bits);
    }
};

}  // namespace libration::function
