// Local analysis at a singularity: the growth of perturbations of the leading behaviour. Heuristic.
#pragma once

#include <complex>
#include <vector>

#include "libration/plane/local_series.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

/// The eigenvalues r of the Kovalevskaya matrix
///     K_ij = tau df_i/dy_j tau^(p_j - p_i) - p_i delta_ij
/// of y' = f(t, y) about y_i ~ c_i tau^p_i, tau = t - t*: a perturbation y_i + e k_i tau^(p_i + r) solves the equation
/// to first order [Yoshida1983]. K is evaluated at one point next to t*, where the non-dominant terms are negligible;
/// carried unknowns and tau are those there. Unknowns that remain finite count with p = 0. Empty if a nonzero matrix
/// element grows towards t*, or for more than 12 unknowns.
std::vector<std::complex<double>> resonances_at(const path_system& of, const complex_number<mpfr>& time,
                                                const std::vector<complex_number<mpfr>>& carried,
                                                const complex_number<mpfr>& tau,
                                                const std::vector<std::complex<double>>& exponents);

}  // namespace libration::ode
