// The hyperbolic cosine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// c = cosh x: c' = sinh x x'. Its series is the companion of that of sinh x.
struct cosh_function {
    static constexpr auto kind = function_kind::cosh;
    static constexpr std::string_view name = "cosh";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 1); }
    static range bounds(const number_bounds& x) { return rising_with_size(mpfr_cosh, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(cosh(x))) {
        return R(cosh(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return sinh(x);
    }
    static constexpr auto companion_of = function_kind::sinh;
};

}  // namespace libration::function
