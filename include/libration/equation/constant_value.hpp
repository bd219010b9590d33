// Exact constants in the ring of the coefficients.
#pragma once

#include <cmath>
#include <string>

#include "libration/equation/expression.hpp"
#include "libration/scalar/complex_functions.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

/// The number in R: exact if R contains only fractions (throws error for a number that is not a fraction); in a scalar
/// within half a unit in the last place and 2^-64 of it, on proved scalars an enclosure; complex numbers have imaginary
/// part 0.
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
            throw error(error_kind::argument, error_subject::problem, "",
                        "has a number that is not a fraction, or a function whose value at the initial point is not "
                        "one: choose another scalar");
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

}  // namespace libration::ode
