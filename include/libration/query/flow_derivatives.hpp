// Derivatives of a solution with respect to initial values and parameters, with every digit proved.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/query/states.hpp"

namespace libration::ode {

/// Derivatives of the state of a system with free parameters at a time: rows are its unknowns with their lower
/// derivatives, in order.
struct state_derivatives {
    std::vector<ball> starts;  ///< the given initial values of the state
    std::vector<ball> values;  ///< the given values of the open numbers
    ball_matrix by_starts;     ///< with respect to the initial value of each of them
    ball_matrix by_values;     ///< with respect to each open number, also through initial values that contain it
};

/// A problem of which some parameters p are constant unknowns, p' = 0 (opened), so that the derivative of its flow,
/// which theorem V encloses, is that with respect to its initial values and these parameters.
class opened_flow {
public:
    /// For these unknowns and those that they depend on; for all if none is named. Throws error like explicit_system
    /// and opened.
    opened_flow(const equation_system& given, const std::vector<std::string>& parameters,
                const std::vector<std::string>& unknowns = {});

    /// The unknowns of the problem and the parameters, in the order of equation_system::unknowns().
    const explicit_system& system() const { return open_.system; }
    const first_order_form& form() const { return form_; }
    /// The indices of the unknowns of the problem and their lower derivatives, in order, in the state of system().
    const std::vector<std::size_t>& own() const { return own_; }
    /// Their names: x, x', ...
    const std::vector<std::string>& names() const { return names_; }

    /// At a time for which at() of an integration of system() has just been called, which keeps its derivative (chain
    /// rule). The derivative by a number on which an unknown does not depend is an exact 0. Throws error of the kind
    /// undecided at a singular initial point.
    state_derivatives at(proved_march& march, const number& time) const;

private:
    parametric_system open_;
    first_order_form form_;
    std::vector<std::size_t> own_;
    std::vector<std::string> names_;
    /// Whether the unknown of one index in the state depends on that of another.
    std::vector<std::vector<bool>> depends_;
};

/// The proved part of a solution and of its derivatives at a list of times.
struct partial_derivatives {
    partial_trajectory trajectory;  ///< `missing` also for derivatives
    /// At each time, for each value of the state in order, dy(t)/dx for each number x in order; empty at a time that is
    /// not reached.
    std::vector<std::vector<std::vector<known_value>>> by;
};

/// proved_part_of_trajectory with the derivatives of every value with respect to `numbers`, each a parameter, r, or the
/// initial value of an unknown or a lower derivative, x'(0), from the same integrations (theorem V): `digits` digits
/// each, proved to one unit in the last. That with respect to a parameter includes the motion of initial values that
/// contain it. All unknowns are integrated together. The error maps have the precision of the digits, so that the cost
/// exceeds that of the trajectory by the factor of the number of unknowns. A derivative that is 0, but not by the
/// dependencies between the unknowns, is missing with a bound. Throws like proved_trajectory, and error of the
/// subject "derivatives" for a number that the problem does not have, is given twice, or must be constant, such as an
/// exponent.
partial_derivatives proved_derivatives(const equation_system& given, const std::vector<number>& times,
                                       const std::vector<std::string>& numbers, long digits,
                                       const march_watch& watch = {}, const proof_route& route = {},
                                       const step_observer& observer = {});

}  // namespace libration::ode
