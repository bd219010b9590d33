// The hyperbolic tangent.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// h = tanh x: h' = (1 - h^2) x'.
struct tanh_function {
    static constexpr auto kind = function_kind::tanh;
    static constexpr std::string_view name = "tanh";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::one_value;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) { return at_zero(x, 0); }
    static range bounds(const number_bounds& x) { return rising(mpfr_tanh, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(tanh(x))) {
        return R(tanh(x));
    }

    template <class E>
    static E derivative(const E& /*x*/, const E& w) {
        return 1 - w * w;
    }

    static constexpr bool odd = true;
    static constexpr int kept = 1;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::hyperbolic_tangent_kernel(of.slope, of.kept[0], of.result, n, of.of_x, sums);
    }
};

}  // namespace libration::function
