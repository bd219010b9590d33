// Exact constants and elementary functions of one number in the ring of the coefficients.
#pragma once

#include <cmath>
#include <string>

#include "libration/ode/expression.hpp"
#include "libration/scalar/complex_functions.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

/// The number in R: as a fraction where R holds fractions alone (throws error for what is none); in a scalar within
/// half a unit in the last place and 2^-64 of it, on proved scalars an enclosure; complex numbers with imaginary part
/// 0.
template <field R>
struct constant_value {
    static R of(const number& x) {
        if (const auto q = x.fraction()) {
            return from_rational<R>(*q);
        }
        const number_bounds within = x.narrowed(static_cast<long>(digits<R>()) + 64);
        rational lower;
        rational upper;
        mpfr_get_q(lower.backend().data(), handle(within.lower));
        mpfr_get_q(upper.backend().data(), handle(within.upper));
        return enclose(from_rational<R>(lower), from_rational<R>(rational(upper - lower)));
    }
};

template <>
struct constant_value<rational> {
    static rational of(const number& x) {
        const auto q = x.fraction();
        if (!q) {
            throw error(error_kind::argument, "problem", "",
                        "has a number that is no fraction, or a start where a function is none: choose another scalar");
        }
        return *q;
    }
};

template <scalar T>
struct constant_value<complex_number<T>> {
    static complex_number<T> of(const number& x) { return {constant_value<T>::of(x), T(0)}; }
    static complex_number<T> of(const complex_constant& z) {
        return {constant_value<T>::of(z.re), constant_value<T>::of(z.im)};
    }
};

/// f(x) for the value x of an argument at an expansion point. Throws error where R has no such function.
template <field R>
R function_value(elementary f, const R& x) {
    using std::acos, std::asin, std::atan, std::sinh, std::cosh, std::tanh;
    using std::exp, std::log, std::sqrt, std::sin, std::cos, std::tan;
    const auto missing = [](const char* name) -> R {
        throw error(
            error_kind::argument, "problem", "",
            std::string("needs ") + name + " of a coefficient, which this scalar does not have: choose another");
    };
    switch (f) {
        case elementary::exp:
            if constexpr (requires { R(exp(x)); }) return R(exp(x));
            return missing("exp");
        case elementary::log:
            if constexpr (requires { R(log(x)); }) return R(log(x));
            return missing("log");
        case elementary::sqrt:
            if constexpr (requires { R(sqrt(x)); }) {
                return R(sqrt(x));
            } else if constexpr (requires { R(exp(R(log(x) / 2))); }) {
                return R(exp(R(log(x) / 2)));
            }
            return missing("sqrt");
        case elementary::sin:
            if constexpr (requires { R(sin(x)); }) return R(sin(x));
            return missing("sin");
        case elementary::cos:
            if constexpr (requires { R(cos(x)); }) return R(cos(x));
            return missing("cos");
        case elementary::tan:
            if constexpr (requires { R(tan(x)); }) {
                return R(tan(x));
            } else if constexpr (requires { R(sin(x) / cos(x)); }) {
                return R(sin(x) / cos(x));
            }
            return missing("tan");
        case elementary::asin:
            if constexpr (requires { R(asin(x)); }) return R(asin(x));
            return missing("asin");
        case elementary::acos:
            if constexpr (requires { R(acos(x)); }) return R(acos(x));
            return missing("acos");
        case elementary::atan:
            if constexpr (requires { R(atan(x)); }) return R(atan(x));
            return missing("atan");
        case elementary::sinh:
            if constexpr (requires { R(sinh(x)); }) return R(sinh(x));
            return missing("sinh");
        case elementary::cosh:
            if constexpr (requires { R(cosh(x)); }) return R(cosh(x));
            return missing("cosh");
        case elementary::tanh:
            if constexpr (requires { R(tanh(x)); }) return R(tanh(x));
            return missing("tanh");
    }
    return missing("a function");
}

/// x^r for a value x at an expansion point.
template <field R>
R power_value(const R& x, const R& r) {
    using std::pow;
    if constexpr (requires { R(pow(x, r)); }) {
        return R(pow(x, r));
    } else {
        return function_value<R>(elementary::exp, R(function_value<R>(elementary::log, x) * r));
    }
}

}  // namespace libration::ode
