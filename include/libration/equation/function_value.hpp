// Values of functions of one argument in the ring of the coefficients.
#pragma once

#include <concepts>
#include <string>

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
