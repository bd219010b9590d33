// Elliptic functions and integrals of exact arguments at an exact parameter, enclosed: exact_functions.hpp in balls.
#pragma once

#include "libration/elliptic/exact_functions.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::elliptic {

/// am, sn, cn or dn at u, as jacobi_value<T>.
inline ball jacobi_value(jacobi_function f, const exact& u, const exact_parameter& p) {
    return jacobi_value<ball>(f, u, p);
}

/// F(phi, m), as incomplete_value<T>.
inline ball incomplete_value(const exact& phi, const exact_parameter& p) { return incomplete_value<ball>(phi, p); }

}  // namespace libration::elliptic
