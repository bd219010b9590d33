// A place in the complex plane as errors name it.
#pragma once

#include <cmath>
#include <complex>
#include <string>

namespace libration::ode {

/// 1.000000 - 0.500000i
inline std::string words_of_place(const std::complex<double>& z) {
    return std::to_string(z.real()) + (z.imag() < 0 ? " - " : " + ") + std::to_string(std::abs(z.imag())) + "i";
}

}  // namespace libration::ode
