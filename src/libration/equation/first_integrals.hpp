// Functions that no solution of an autonomous system changes.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/first_order_form.hpp"

namespace libration::ode {

/// The largest system for which they, and the symmetries of linear_invariance.hpp, are searched.
inline constexpr std::size_t most_unknowns_with_integrals = 30;

/// I in the leaves of the first-order form with grad I . f = 0 identically, by exact arithmetic. I is continuously
/// differentiable wherever f has a value: its terms are products of at most two leaves (three of at most four leaves);
/// powers u^(r+1), or log |u| for r = -1, of sums u of which f contains u^r; sin, cos, exp, sinh and cosh of arguments
/// that occur in f in such functions; log |y_i| of leaves that divide their slope and therefore keep their sign; and
/// declared invariants, if their powers are such powers.
struct first_integral {
    expression value;
    std::vector<expression> gradient;  ///< by the leaves
    std::string text;                  ///< in the names of the unknowns: "x1' + x2'"
    int degree = 0;                    ///< 1: linear, 2: quadratic, 3: with other terms
};

/// A basis of the integrals of this form with fractions as factors. Not all of them need have independent gradients.
/// None for a system with more than 30 unknowns, or too many terms.
std::vector<first_integral> first_integrals_of(const first_order_form& of, const std::vector<expression>& declared);

}  // namespace libration::ode
