// The derivatives of a solution with respect to one of its initial values as further unknowns of a polynomial form.
#pragma once

#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

/// The form with as many unknowns d_i after the given ones, in their order, d_i' = sum over k of df_i/dy_k D_k over all
/// unknowns y_k: D_k = d_k for the given ones, and for a function w of u the polynomial dw/du sum of du/dy_k D_k, as
/// docs/certificates.md states it. The functions are those that a certificate contains.
polynomial_form with_derivatives(const polynomial_form& of);

}  // namespace libration::ode
