// The arcsine.
#pragma once

#include "libration/function/facts.hpp"

namespace libration::function {

/// a = asin x: sqrt(1 - x^2) a' = x'.
struct asin_function {
    static constexpr auto kind = function_kind::asin;
    static constexpr std::string_view name = "asin";
    static constexpr std::string_view domain = "-1 <= x <= 1, in series -1 < x < 1";
    static constexpr auto form = analytic_form::several_values;
    static constexpr singular_points singular{2, {1, -1}, "takes acos or asin of 1 or -1, where they have no series"};
    static constexpr const char* refusal = "takes acos or asin of a number beyond 1";
    static exact_value exact(const plain_number& x) {
        const auto q = fraction_of(x);
        const auto complement = q ? exact_arccosine(*q) : std::nullopt;
        return complement ? of_pi(rational(rational(1, 2) - *complement)) : std::nullopt;
    }
    static range bounds(const number_bounds& x) {
        const range inside = above({-1, true}, x, refusal) ? below({1, true}, x, refusal) : std::nullopt;
        return inside ? range(rising(mpfr_asin, *inside)) : std::nullopt;
    }

    template <class R>
    static auto value(const R& x) -> decltype(R(asin(x))) {
        return R(asin(x));
    }

    template <class E>
    static E derivative(const E& x, const E& /*w*/) {
        return pow(1 - x * x, E(rational(-1, 2)));
    }

    static constexpr bool odd = true;
    static constexpr int kept = 2;
    template <class R, class Sums>
    static void next_coefficient(const series_arrays<R>& of, int n, Sums& sums) {
        series::arcsine_kernel(of.x, of.slope, of.kept[0], of.kept[1], of.result, n, of.of_x, sums);
    }
    /// The stored series starts at sqrt(1 - x^2).
    static constexpr int values_kept = 1;
    template <class E, class Call>
    static E first_kept(int /*which*/, const E& x, const Call& call) {
        return call(function_kind::sqrt, E(E(1) - x * x));
    }
};

}  // namespace libration::function
