// The arctangent.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// a = atan x: (1 + x^2) a' = x'.
struct atan_function {
    static constexpr auto kind = function_kind::atan;
    static constexpr std::string_view name = "atan";
    static constexpr std::string_view domain = "all x";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        return q && abs(*q) == 1 ? of_pi(rational(*q / 4)) : at_zero(x, 0);
    }
    static range bounds(const number_bounds& x) { return rising(mpfr_atan, x); }

    template <class R>
    static auto value(const R& x) -> decltype(R(atan(x))) {
        return R(atan(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return 1 / (1 + x * x);
    }

    static constexpr bool odd = true;
    static constexpr int kept = 2;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::arctangent_kernel(of.x, of.slope, of.kept[0], of.kept[1], of.result, n, of.of_x, sums);
    }
};

}  // namespace libration::function
