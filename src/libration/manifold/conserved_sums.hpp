// Linear combinations of the unknowns of a system, and of their logarithms, that no solution changes.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// The relations c.y + d.log y = const. with c.f + d.(f/y) = 0 identically, c and d rational, solved for as many unknowns:
/// y_eliminated[i] - its initial value = sum_k coefficients[i][k] u_k + logarithms[i][k] log(1 + u_k/y_k(t0)), u the
/// changes of the kept unknowns.
struct conserved_sums {
    std::vector<std::size_t> eliminated, kept;
    std::vector<std::vector<rational>> coefficients, logarithms;
};

/// All that follow from expanding f into products of unknowns, t, and of subexpressions that are not polynomials, taken
/// as further variables; none if that has more than 10,000 terms. Logarithms of the unknowns with a nonzero initial value
/// that divide their slope, and keep their sign, therefore.
conserved_sums conserved_sums_of(const first_order_form& of);

}  // namespace libration::ode
