// The elliptic functions and integrals available in common libraries, by name, at any real parameter, in balls.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "libration/elliptic/real_parameter.hpp"
#include "libration/scalar/ball/comparison.hpp"

namespace libration::elliptic {

/// The exact arguments at which a function is evaluated.
struct function_arguments {
    std::optional<exact> argument;  ///< u, phi, x or z; std::nullopt for complete integrals and the nome
    real_parameter parameter;       ///< m; for the theta functions q
    std::optional<exact> characteristic = std::nullopt;  ///< n of Pi
};

/// A function under its name:
///   am, and pq for p, q of s, c, d, n: am(u|m), pq(u|m), the twelve functions of Jacobi    [DLMF 22.16(i), 22.2]
///   arcpq(x|m): their inverses, from 0 to K where x >= 0                                       [DLMF 22.15]
///   K, E, D, Pi: the complete integrals, E, D and Pi with phi the incomplete ones, and F       [DLMF 19.2(ii)]
///   Zeta: E(phi|m) - E(m)/K(m) F(phi|m)                                                        [DLMF 22.16.32]
///   nome: exp(-pi K(1-m)/K(m))                                                                 [DLMF 22.2.1]
///   theta1 .. theta4: theta_j(z, q), -1 < q < 1, the first two for q >= 0                      [DLMF 20.2(i)]
/// m = k^2, D = (F - E)/m, Pi(n; phi|m) = int_0^phi dx/((1 - n sin^2 x) sqrt(1 - m sin^2 x)).
struct named_function {
    std::string_view name;
    std::string_view argument;     ///< "u", "phi", "x", "z", or empty
    bool may_be_complete = false;  ///< whether the argument may be left out
    bool has_characteristic = false;
    bool of_nome = false;  ///< whether the parameter is the nome q
    /// The value at the working precision; `exactly` if it is a fraction for exact reasons, `infinite` at poles and
    /// where an integral diverges (+1 at a pole of either sign). Any real m for which the value is real.
    /// Throws error of the kind argument if it is not real, precision_exhausted if the precision does not decide.
    true_value (*value)(std::string_view name, const function_arguments& at);

    true_value operator()(const function_arguments& at) const { return value(name, at); }
};

/// A complex number as real and imaginary part.
struct complex_parts {
    ball real;
    ball imaginary;
};

/// pq(x + iy|m) for the twelve functions, from those of x at m and of y at 1 - m [DLMF 22.6(iv), 22.8(i)]. A part that
/// is 0 for exact reasons is the ball 0; std::nullopt at a pole. Throws error of the kind argument for another
/// function, precision_exhausted if the precision does not decide.
std::optional<complex_parts> complex_quotient(std::string_view name, const exact& x, const exact& y,
                                              const real_parameter& parameter);

/// All of them.
std::span<const named_function> named_functions();

/// The function with this name; nullptr if there is none.
const named_function* find_function(std::string_view name);

}  // namespace libration::elliptic
