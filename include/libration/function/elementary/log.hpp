// The natural logarithm.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// l = log x: x l' = x'.
struct log_function {
    static constexpr auto kind = function_kind::log;
    static constexpr std::string_view name = "log";
    static constexpr std::string_view domain = "x > 0";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular = no_points;
    static constexpr const char* refusal = "takes the logarithm of a number that is not positive";
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        if (q && *q <= 0) {
            refuse_number(refusal);
        }
        return q && *q == 1 ? ones(rational(0)) : std::nullopt;
    }
    static range bounds(const number_bounds& x) {
        const range inside = above({0, false}, x, refusal);
        return inside ? range(rising(mpfr_log, *inside)) : std::nullopt;
    }

    template <class R>
    static auto value(const R& x) -> decltype(R(log(x))) {
        return R(log(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return 1 / x;
    }

    static constexpr bool odd = false;
    static constexpr int kept = 1;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::logarithm_kernel(of.x, of.kept[0], of.result, n, of.of_slope, sums);
    }
};

}  // namespace libration::function
