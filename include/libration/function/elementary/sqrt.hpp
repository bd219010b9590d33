// The square root.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// r = sqrt x: 2 r r' = x'. In series and in polynomial forms it is represented as the power 1/2.
struct sqrt_function {
    static constexpr auto kind = function_kind::sqrt;
    static constexpr std::string_view name = "sqrt";
    static constexpr std::string_view domain = "x >= 0";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular{1, {0}, "takes the root of 0"};
    static constexpr const char* refusal = "takes the root of a negative number";
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        if (q && *q < 0) {
            refuse_number(refusal);
        }
        return q ? ones(exact_root(*q, 2)) : std::nullopt;
    }
    static range bounds(const number_bounds& x) {
        const range inside = above({0, true}, x, refusal);
        return inside ? range(rising(mpfr_sqrt, *inside)) : std::nullopt;
    }

    template <class R>
    static auto value(const R& x) -> decltype(R(sqrt(x))) {
        return R(sqrt(x));
    }
    template <class R>
    requires(
        !requires(const R& x) { R(sqrt(x)); } && requires(const R& x) { R(exp(R(log(x) / 2))); }) static R
        value(const R& x) {
        return R(exp(R(log(x) / 2)));
    }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return 1 / (2 * w);
    }
    template <class E>
    static E in_others(const E& x) {
        return pow(x, E(rational(1, 2)));
    }
};

}  // namespace libration::function
