// Chebyshev-Radau nodes cos(2 pi j/(2N+1)), j = 0 .. N: the right end of [-1, 1] is one of them.
#pragma once

#include <vector>

#include "../../algebra/dense_matrix.hpp"

namespace libration::ode {

/// Interpolation by polynomials of degree N at N+1 nodes, and integration of these from -1: linear maps of the values
/// at the nodes, exact up to rounding (the discrete orthogonality of cos(k theta) in theta_j = 2 pi j/(2N+1)).
class collocation_points {
public:
    collocation_points(int degree, long bits);

    int degree() const { return degree_; }
    std::size_t size() const { return places_.size(); }
    /// x_i, ascending.
    const std::vector<ball>& places() const { return places_; }
    /// Row i maps the values at the nodes to the integral from -1 to x_i.
    const dense_matrix& integrals() const { return integrals_; }
    const std::vector<double>& rounded_integrals() const { return rounded_; }
    /// Chebyshev coefficients of the interpolant, and of its integral from -1.
    const dense_matrix& coefficients() const { return coefficients_; }
    const dense_matrix& coefficients_of_integral() const { return integral_coefficients_; }
    /// The coefficients of sum_l c_l T_l(x) in powers of x.
    std::vector<ball> powers(const std::vector<ball>& chebyshev) const;

private:
    int degree_;
    std::vector<ball> places_;
    dense_matrix coefficients_, integral_coefficients_, integrals_, powers_;
    std::vector<double> rounded_;
};

}  // namespace libration::ode
