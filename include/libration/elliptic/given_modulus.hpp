// The modulus of an elliptic function as given by the caller. No other header is needed to write it.
#pragma once

#include <string>

namespace libration::elliptic {

/// One of the modulus k, the parameter m = k^2 and the complementary parameter m1 = 1 - m, from 0 to 1; exact as
/// written, so that m1 = "1e-30" keeps its digits.
struct given_modulus {
    std::string k = {};
    std::string m = {};
    std::string m1 = {};
};

}  // namespace libration::elliptic
