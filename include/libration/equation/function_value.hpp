// Values of functions of one argument in the ring of the coefficients.
#pragma once

#include <concepts>
#include <string>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/function/ball_functions.hpp"
#include "libration/function/list.hpp"

namespace libration::ode {

/// A function that FLINT provides: it is then available for balls, and through them for every scalar.
template <class F>
concept function_of_flint = requires {
    &F::template complex_ball<int>;
};

/// f(x) rounded in T by MPFR or from a ball, within one unit in the last place; NaN outside the domain. Throws error
/// for a function that needs FLINT in a program built without it.
template <rounding_scalar T>
requires std::same_as<wide_t<T>, mpfr> T value_by_balls(function_kind f, const rational* order, const T& x) {
    return convert<T>(function::rounded_value(f, order, widen(x), static_cast<long>(digits<T>())));
}

/// The same for complex numbers, with the error relative to the modulus of the value.
template <rounding_scalar T>
requires std::same_as<wide_t<T>, mpfr> complex_number<T> value_by_balls(function_kind f, const rational* order,
                                                                        const complex_number<T>& z) {
    const auto value =
        function::functions_of_balls(f).value(f, order, {widen(z.re), widen(z.im)}, static_cast<long>(digits<T>()));
    return {convert<T>(value[0]), convert<T>(value[1])};
}

/// Scalars whose values of functions are rounded from balls.
template <class R>
concept rounded_from_balls = requires(function_kind f, const rational* order, const R& x) {
    value_by_balls(f, order, x);
};

/// f(x), of this order if f has one, for the value x of an argument at an expansion point. Throws error if f is not
/// available in R.
template <field R>
R function_value(function_kind f, const R& x, const rational* order = nullptr) {
    return function::with_function(f, [&](auto of) -> R {
        using each = decltype(of);
        if constexpr (requires { each::value(x); }) {
            return each::value(x);
        } else if constexpr (function_of_flint<each> && requires { function_at(of, x); }) {
            if constexpr (function::ordered<each>) {
                return function_at(of, constant_value<R>::of(number(*order)), x);
            } else {
                return function_at(of, x);
            }
        } else {
            if constexpr (rounded_from_balls<R>) {  // in a separate `if`, as it does not depend on `each`
                if constexpr (function_of_flint<each>) {
                    return value_by_balls(f, order, x);
                }
            }
            throw error(error_kind::argument, error_subject::problem, "",
                        "needs " + std::string(each::name) +
                            " of a coefficient, which is not available in this scalar: choose another");
        }
    });
}

/// The coefficients of series_values(), rounded in T from balls.
template <rounding_scalar T>
requires std::same_as<wide_t<T>, mpfr> std::vector<T> series_by_balls(function_kind f, relative_kind family, int order,
                                                                      const T& x, int count) {
    std::vector<T> result;
    const auto bits = static_cast<long>(digits<T>());
    for (const auto& each : function::functions_of_balls(f).series(family, order, {widen(x), mpfr(0)}, count, bits)) {
        result.push_back(convert<T>(each[0]));
    }
    return result;
}

template <rounding_scalar T>
requires std::same_as<wide_t<T>, mpfr> std::vector<complex_number<T>> series_by_balls(function_kind f,
                                                                                      relative_kind family, int order,
                                                                                      const complex_number<T>& z,
                                                                                      int count) {
    std::vector<complex_number<T>> result;
    const auto bits = static_cast<long>(digits<T>());
    for (const auto& each :
         function::functions_of_balls(f).series(family, order, {widen(z.re), widen(z.im)}, count, bits)) {
        result.push_back({convert<T>(each[0]), convert<T>(each[1])});
    }
    return result;
}

/// Coefficients 0 .. count - 1 of the series about x of a function of the list with has_table. Throws error for a scalar
/// in which they are not available.
template <class F, field R>
std::vector<R> series_values(int order, const R& x, int count) {
    if constexpr (requires { relative_series(F::family, order, x, count); }) {
        return relative_series(F::family, order, x, count);
    } else {
        std::vector<R> result;
        if (function::is_zero(x)) {
            for (int j = 0; j < count; ++j) {
                result.push_back(constant_value<R>::of(number(F::about_zero(order, j))));
            }
            return result;
        }
        if constexpr (requires { series_by_balls(F::kind, F::family, order, x, count); }) {
            return series_by_balls(F::kind, F::family, order, x, count);
        }
        throw error(error_kind::argument, error_subject::problem, "",
                    "needs " + std::string(F::name) +
                        " of a coefficient, which is not available in this scalar: choose another");
    }
}

/// x^r for a value x at an expansion point.
template <field R>
R power_value(const R& x, const R& r) {
    using std::pow;
    if constexpr (requires { R(pow(x, r)); }) {
        return R(pow(x, r));
    } else {
        return function_value<R>(function_kind::exp, R(function_value<R>(function_kind::log, x) * r));
    }
}

}  // namespace libration::ode
