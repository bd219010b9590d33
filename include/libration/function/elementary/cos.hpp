// The cosine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// c = cos x: c' = -sin x x'. Its series is the companion of that of sin x.
struct cos_function {
    static constexpr auto kind = function_kind::cos;
    static constexpr std::string_view name = "cos";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = times_pi(x);
        return q ? ones(exact_cosine(*q)) : at_zero(x, 1);
    }
    static range bounds(const number_bounds& x) { return of_circle(mpfr_cos, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(cos(x))) {
        return R(cos(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return -sin(x);
    }
    static constexpr auto companion_of = function_kind::sin;
};

}  // namespace libration::function
