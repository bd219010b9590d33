// The Airy function Ai [DLMF 9].
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// w = Ai(x): w' = Ai'(x) x'.
struct airy_ai_function {
    static constexpr auto kind = function_kind::airy_ai;
    static constexpr std::string_view name = "airy_ai";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::entire;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& /*x*/) { return std::nullopt; }
    static range bounds(const number_bounds& x) { return by_balls(kind, x); }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return airy_ai_prime(x);
    }

    template <class Real>
    static void real_ball(Real* y, const Real* x, long bits) {
        arb_hypgeom_airy(y, nullptr, nullptr, nullptr, x, bits);
    }
    template <class Complex>
    static void complex_ball(Complex* y, const Complex* x, long bits) {
        acb_hypgeom_airy(y, nullptr, nullptr, nullptr, x, bits);
    }
};

}  // namespace libration::function
