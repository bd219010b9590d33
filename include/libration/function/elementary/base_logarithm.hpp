// Logarithms to a whole base.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// l = log(x)/log(Base), also for the series: x l' = x'/log(Base). `Rounded` is MPFR's function.
template <int Base, rounded_function Rounded>
struct base_logarithm {
    static constexpr std::string_view domain = "x > 0";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        return q && *q > 0 ? ones(exact_logarithm(*q, Base)) : std::nullopt;
    }
    static constexpr const char* refusal = "takes the logarithm of a number that is not positive";
    static range bounds(const number_bounds& x) {
        const range inside = above({0, false}, x, refusal);
        return inside ? range(rising(rounded, *inside)) : std::nullopt;
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return 1 / (x * log(E(Base)));
    }
    template <class E>
    static E in_others(const E& x) {
        return log(x) / log(E(Base));
    }

    static constexpr rounded_function rounded = Rounded;
    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_log_base_ui(y, x, Base, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_log(y, x, bits);
        Complex base;
        acb_init(&base);
        acb_set_ui(&base, Base);
        acb_log(&base, &base, bits);
        acb_div(y, y, &base, bits);
        acb_clear(&base);
    }
};

}  // namespace libration::function
