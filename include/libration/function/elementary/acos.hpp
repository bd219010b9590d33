// The arccosine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// a = acos x: -sqrt(1 - x^2) a' = x'. Its series is that of pi/2 - asin x.
struct acos_function {
    static constexpr auto kind = function_kind::acos;
    static constexpr std::string_view name = "acos";
    static constexpr std::string_view domain = "-1 <= x <= 1, in series -1 < x < 1";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular{2, {1, -1}, "takes acos or asin of 1 or -1, where they have no series"};
    static constexpr const char* refusal = "takes acos or asin of a number beyond 1";
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        return q ? of_pi(exact_arccosine(*q)) : std::nullopt;
    }
    static range bounds(const number_bounds& x) {
        const range inside = above({-1, true}, x, refusal) ? below({1, true}, x, refusal) : std::nullopt;
        return inside ? range(falling(mpfr_acos, *inside)) : std::nullopt;
    }

    template <class R>
    static auto value(const R& x) -> decltype(R(acos(x))) {
        return R(acos(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return -pow(1 - x * x, E(rational(-1, 2)));
    }
    template <class E>
    static E in_others(const E& x) {
        return E(plain_number{rational(1, 2), unit::pi}) - asin(x);
    }
};

}  // namespace libration::function
