// A polynomial system as a list of monomials.
#pragma once

#include <optional>
#include <vector>

#include "libration/equation/polynomial_form.hpp"

namespace libration::ode {

// The sum over s of by_time[s] t^s, times the product of y_j^powers[j].
struct field_term {
    std::vector<int> powers;
    std::vector<number> by_time;
};

// The right-hand sides in the unknowns `leaves`; std::nullopt if one is not shown to be a polynomial with constant coefficients.
std::optional<std::vector<std::vector<field_term>>> field_terms_of(const explicit_system& of,
                                                                   const std::vector<expression>& leaves);

}  // namespace libration::ode
