// Elliptic functions and integrals to any number of proved digits: start here. No precision has to be chosen.
#pragma once

#include <string>

#include "libration/elliptic/given_modulus.hpp"
#include "libration/scalar/printed_number.hpp"

/// Each digit is proved: the exact number is less than one unit of the last digit away.
/// Arguments are exact as written: "1.5", "3/2", "pi/4", for F also "60deg". Each
/// throws error: of the kind argument, with the quantity and its value, for an invalid argument; of the kind undecided
/// if no precision within the limits yields the digits.
namespace libration::proved {

/// Jacobi's amplitude and functions at u [DLMF 22.16(i), 22.2].
proved_decimal am(const std::string& u, const elliptic::given_modulus& modulus, long digits);
proved_decimal sn(const std::string& u, const elliptic::given_modulus& modulus, long digits);
proved_decimal cn(const std::string& u, const elliptic::given_modulus& modulus, long digits);
proved_decimal dn(const std::string& u, const elliptic::given_modulus& modulus, long digits);

/// The complete and the incomplete integral of the first kind [DLMF 19.2(ii)]; inf or -inf if infinite.
proved_decimal K(const elliptic::given_modulus& modulus, long digits);
proved_decimal F(const std::string& phi, const elliptic::given_modulus& modulus, long digits);

}  // namespace libration::proved
