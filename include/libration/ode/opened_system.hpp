// Numbers of a problem as unknowns of it: what its solutions depend on besides time.
#pragma once

#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"

namespace libration::ode {

/// A system some of whose parameters and starts are open: each is an unknown function that does not change and stands
/// among the unknowns where the equations name it first.
struct opened_system {
    explicit_system system;
    /// The open numbers as they are given.
    std::vector<number> values;
    /// starts[k] is the start of unknown or lower derivative k, in order, by the leaves.
    std::vector<expression> starts;
    /// leaves[i] stands for open number i.
    std::vector<expression> leaves;
};

/// Names are of parameters, or of starts, as f''(0). Throws error for others, and where the equation needs a number as
/// a constant, such as an exponent.
opened_system opened(const equation_system& given, const std::vector<std::string>& names);

/// The equations of these unknowns and of what they depend on; all open numbers keep their leaves.
opened_system closed_part(const opened_system& of, const std::vector<std::string>& unknowns);

}  // namespace libration::ode
