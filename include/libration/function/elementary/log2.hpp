// The logarithm to the base 2.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// l = log(x)/log(2), which is its series too: x l' = x'/log(2).
struct log2_function {
    static constexpr auto kind = function_kind::log2;
    static constexpr std::string_view name = "log2";
    static constexpr std::string_view domain = "x > 0";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        return q && *q > 0 ? ones(exact_logarithm(*q, 2)) : std::nullopt;
    }
    static constexpr const char* refusal = "takes the logarithm of a number that is not positive";
    static range bounds(const number_bounds& x) {
        const range inside = above({0, false}, x, refusal);
        return inside ? range(rising(rounded, *inside)) : std::nullopt;
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return 1 / (x * log(E(2)));
    }
    template <class E>
    static E in_others(const E& x) {
        return log(x) / log(E(2));
    }

    static constexpr rounded_function rounded = mpfr_log2;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_log_base_ui(y, x, 2, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_log(y, x, bits);
        Complex base[1];
        acb_init(base);
        acb_set_ui(base, 2);
        acb_log(base, base, bits);
        acb_div(y, y, base, bits);
        acb_clear(base);
    }
};

}  // namespace libration::function
