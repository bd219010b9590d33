// All functions of formulas and equations, with their descriptions (facts.hpp).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "libration/function/elementary/acos.hpp"
#include "libration/function/elementary/acosh.hpp"
#include "libration/function/elementary/asin.hpp"
#include "libration/function/elementary/asinh.hpp"
#include "libration/function/elementary/atan.hpp"
#include "libration/function/elementary/atanh.hpp"
#include "libration/function/elementary/cbrt.hpp"
#include "libration/function/elementary/cos.hpp"
#include "libration/function/elementary/cosh.hpp"
#include "libration/function/elementary/cosrel.hpp"
#include "libration/function/elementary/exp.hpp"
#include "libration/function/elementary/exp2.hpp"
#include "libration/function/elementary/expm1.hpp"
#include "libration/function/elementary/exprel.hpp"
#include "libration/function/elementary/log.hpp"
#include "libration/function/elementary/log10.hpp"
#include "libration/function/elementary/log1p.hpp"
#include "libration/function/elementary/log2.hpp"
#include "libration/function/elementary/sin.hpp"
#include "libration/function/elementary/sinc.hpp"
#include "libration/function/elementary/sinh.hpp"
#include "libration/function/elementary/sqrt.hpp"
#include "libration/function/elementary/tan.hpp"
#include "libration/function/elementary/tanh.hpp"
#include "libration/function/special/airy_ai.hpp"
#include "libration/function/special/airy_ai_prime.hpp"
#include "libration/function/special/airy_bi.hpp"
#include "libration/function/special/airy_bi_prime.hpp"
#include "libration/function/special/bessel_i.hpp"
#include "libration/function/special/bessel_j.hpp"
#include "libration/function/special/bessel_k.hpp"
#include "libration/function/special/bessel_y.hpp"
#include "libration/function/special/erf.hpp"
#include "libration/function/special/erfc.hpp"
#include "libration/function/special/lambertw.hpp"

namespace libration::function {

template <class F>
concept ordered = requires {
    requires F::has_order;
};

/// A function whose series come from those of all its derivatives (expansion/step_arrays.hpp).
template <class F>
concept in_table = requires {
    requires F::has_table;
};

template <class F>
concept complete_facts = requires(const rational& order, const plain_number& x, const number_bounds& interval) {
    { F::kind } -> std::convertible_to<function_kind>;
    { F::name } -> std::convertible_to<std::string_view>;
    { F::domain } -> std::convertible_to<std::string_view>;
    { F::form } -> std::convertible_to<analytic_form>;
    { F::singular } -> std::convertible_to<singular_points>;
    requires(ordered<F> &&
             requires {
                 { F::exact(order, x) } -> std::same_as<exact_value>;
                 { F::bounds(order, interval) } -> std::same_as<range>;
             }) ||
        (!ordered<F> && requires {
            { F::exact(x) } -> std::same_as<exact_value>;
            { F::bounds(interval) } -> std::same_as<range>;
        });
};

template <class... F>
struct type_list {
    static_assert((complete_facts<F> && ...), "the file of a function lacks a member listed in facts.hpp");
    static constexpr std::size_t size = sizeof...(F);
    /// Whether they are in the order of function_kind.
    static consteval bool in_order() {
        std::size_t next = 0;
        return ((static_cast<std::size_t>(F::kind) == next++) && ...) && size == function_kinds;
    }
};

using all_functions =
    type_list<exp_function, log_function, sqrt_function, sin_function, cos_function, tan_function, asin_function,
              acos_function, atan_function, sinh_function, cosh_function, tanh_function, asinh_function, acosh_function,
              atanh_function, log10_function, log2_function, exp2_function, cbrt_function, sinc_function,
              expm1_function, log1p_function, erf_function, erfc_function, bessel_j_function, bessel_y_function,
              bessel_i_function, bessel_k_function, airy_ai_function, airy_ai_prime_function, airy_bi_function,
              airy_bi_prime_function, lambertw_function, exprel_function, cosrel_function>;

static_assert(all_functions::in_order(), "the functions are listed in the order of function_kind");

/// visit(F()) for the function of a kind; the same return type for all of them.
template <class Visit, class First, class... F>
decltype(auto) with_function_of(type_list<First, F...> /*all*/, function_kind kind, const Visit& visit) {
    using result = std::invoke_result_t<const Visit&, First>;
    constexpr std::array<result (*)(const Visit&), 1 + sizeof...(F)> calls{
        [](const Visit& each) -> result { return each(First()); },
        [](const Visit& each) -> result { return each(F()); }...};
    return calls[static_cast<std::size_t>(kind)](visit);
}

template <class Visit>
decltype(auto) with_function(function_kind kind, const Visit& visit) {
    return with_function_of(all_functions(), kind, visit);
}

}  // namespace libration::function
