// Coefficients of powers of 1 - t/t* and of logarithms.
#pragma once

#include <vector>

#include "libration/plane/series_disc.hpp"

namespace libration::ode {

// Gamma(n - a - s)/(Gamma(-a - s) n!) in powers of s, `count` of them: one for each power of a logarithm. By polygamma functions and classical
// products: those of FLINT for long polynomials are not always right (product_guard.hpp).
std::vector<complex_ball> gamma_series(const complex_ball& a, long n, std::size_t count);
// The series for a + 1 from that for a: times (-(a + 1) - s)/(n - a - 1 - s).
void take_next_exponent(std::vector<complex_ball>& series, const complex_ball& a, long n);

// Gamma(n - b)/n! and Gamma(x).
ball quotient_of_gammas(long n, const ball& b);
ball gamma_at(const ball& x);
// At least the floor.
long floor_in_double(const ball& x);
// place^-n.
complex_ball inverse_power(const complex_ball& place, long n);
// A number, or twice its real part.
ball with_image(const complex_ball& z, bool real);
bool is_zero_exactly(const complex_ball& z);

}  // namespace libration::ode
