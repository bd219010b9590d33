// Correct digits of elliptic functions and integrals, as many as are asked for: start here. No precision has to be
// chosen.
#pragma once

#include <string>

#include "libration/elliptic/given_modulus.hpp"
#include "libration/scalar/text/printed_number.hpp"

/// Each digit is right to one unit in the last, by arithmetic that rounds: K by one run whose error is bounded before,
/// the others by runs that agree.
/// Arguments are exact as written: "1.5", "3/2", "pi/4", of F "60deg" too. No FLINT is needed.
/// Each throws error: of the kind argument, with the quantity and its value, for what is no argument; of the kind
/// undecided where no precision within the limits gives the digits.
namespace libration::rounded {

/// Jacobi's amplitude and functions at u [DLMF 22.16(i), 22.2].
rounded_decimal am(const std::string& u, const elliptic::given_modulus& modulus, long digits);
rounded_decimal sn(const std::string& u, const elliptic::given_modulus& modulus, long digits);
rounded_decimal cn(const std::string& u, const elliptic::given_modulus& modulus, long digits);
rounded_decimal dn(const std::string& u, const elliptic::given_modulus& modulus, long digits);

/// The complete and the incomplete integral of the first kind [DLMF 19.2(ii)]; inf or -inf where they are infinite.
rounded_decimal K(const elliptic::given_modulus& modulus, long digits);
rounded_decimal F(const std::string& phi, const elliptic::given_modulus& modulus, long digits);

}  // namespace libration::rounded
