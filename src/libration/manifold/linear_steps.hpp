// A polynomial field at an equilibrium, step by step: its value, its linear part and the degree of the rest.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "complex_jet.hpp"
#include "libration/expansion/tape.hpp"

namespace libration::ode {

/// The complex number of a real one.
inline complex_jet real_jet(ball x) { return complex_ball(std::move(x), ball(0)); }

/// An autonomous polynomial system y' = f(y) near an equilibrium y*, whose constant unknowns are parameters: the other
/// ones are y = y* + Q w.
struct field_at_rest {
    const tape* of = nullptr;
    std::vector<complex_jet> centre;  ///< of all unknowns: y*, or the values of the parameters
    std::vector<std::size_t> moving;  ///< the indices of the other unknowns
    int direction = 1;                ///< -1: of reversed time
};

/// How a step of a polynomial field follows from those before.
enum class polynomial_operation {
    leaf,      ///< a constant, a parameter or a moving unknown
    sum,       ///< left + factor right
    multiple,  ///< factor left, and a constant
    product    ///< left right
};

/// Each step of the tape as centre + linear . w + terms of degree 2 to `degree` in w.
struct linear_step {
    complex_jet centre;
    std::vector<complex_jet> linear;  ///< empty if it does not depend on w
    int degree = 0;
    polynomial_operation kind = polynomial_operation::leaf;
    std::size_t left = 0;
    std::size_t right = 0;
    complex_jet factor = {};
};
/// For Q by rows of the moving unknowns. Throws error for an operation that is none of polynomials, and for t.
std::vector<linear_step> linear_steps(const field_at_rest& field, const jet_matrix& q);
/// The linear part of the field, Q = 1.
jet_matrix linear_part(const field_at_rest& field);

}  // namespace libration::ode
