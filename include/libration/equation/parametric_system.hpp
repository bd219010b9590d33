// Systems with free parameters: numbers of a problem as additional unknowns, on which its solutions depend besides
// time.
#pragma once

#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// A system with free parameters and initial values: each is a constant unknown function, listed among the unknowns in
/// the order of equation_system::unknowns().
struct parametric_system {
    explicit_system system;
    /// The given values of the free numbers.
    std::vector<number> values;
    /// starts[k] is the initial value of unknown or lower derivative k, in order, in terms of the leaves.
    std::vector<expression> starts;
    /// leaves[i] represents free number i.
    std::vector<expression> leaves;
    /// The other expressions, such as conditions, in terms of the leaves.
    std::vector<expression> others;
};

/// Names are those of parameters, or of initial values such as f''(0). The parameters in `others` are replaced by the
/// leaves of the free ones and by the values of the rest. Throws error for other names, and if the equation requires
/// the number to be constant, such as an exponent.
parametric_system opened(const equation_system& given, const std::vector<std::string>& names,
                         const std::vector<expression>& others = {});

/// The parameter of this name. Throws error if there is none, if it has no number, and if the initial point depends on
/// it.
const definition& given_parameter(const equation_system& of, const std::string& name);

/// The equations of these unknowns and of those that they depend on; all free numbers keep their leaves.
parametric_system closed_part(const parametric_system& of, const std::vector<std::string>& unknowns);

}  // namespace libration::ode
