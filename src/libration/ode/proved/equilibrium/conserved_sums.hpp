// Linear combinations of the unknowns of a system that no solution changes.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/ode/first_order_form.hpp"

namespace libration::ode {

/// The relations c.y = const. with c.f = 0 identically, c rational, solved for as many unknowns:
/// y_eliminated[i] = constants[i] + sum_k coefficients[i][k] y_kept[k].
struct conserved_sums {
    std::vector<std::size_t> eliminated, kept;
    std::vector<std::vector<rational>> coefficients;
    std::vector<number> constants;
};

/// All that follow from expanding f into products of unknowns, t, and of subexpressions that are no polynomials, taken
/// as further variables; none if that has more than 10,000 terms.
conserved_sums conserved_sums_of(const first_order_form& of);

}  // namespace libration::ode
