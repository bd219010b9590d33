// Condition numbers: the change of a solution when the numbers in its problem change, an error amplification that no
// algorithm can avoid.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/query/flow_derivatives.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// The first-order change of a value y under relative perturbations of the input, |y| times the condition numbers.
/// Three digits are proved, or that it is below 10^-9 |y|, which is returned as 0; if y is exactly 0 they are
/// heuristic. An input that is 0 is not perturbed.
struct moved_value {
    mpfr by_start;       ///< sum over the initial values s of |dy/ds| |s|
    mpfr by_parameters;  ///< the same over the parameters, without exponents and those used only in other parameters
    mpfr by_time;        ///< |dy/dt| |t|
    mpfr by_rounding;    ///< |sum over initial values and parameters x of dy/dx (double(x) - x)|
};

/// A problem whose parameters are constant unknowns (opened), so that the derivative of its flow is that with respect
/// to the initial values and the parameters.
class dependence {
public:
    /// For these unknowns and those that they depend on; for all if none is named. Throws error like explicit_system.
    explicit dependence(const equation_system& given, const std::vector<std::string>& unknowns = {});

    /// The unknowns of the problem and its parameters, in the order of equation_system::unknowns().
    const explicit_system& system() const { return flow_.system(); }
    /// The indices of the unknowns of the problem and their lower derivatives, in order, in the state of system().
    const std::vector<std::size_t>& own() const { return flow_.own(); }
    /// Their names: x, x', ...
    const std::vector<std::string>& names() const { return flow_.names(); }
    /// The changes of these values, for an integration of system() that keeps its derivative, at a time where it has
    /// this state. by_rounding is 0 below 10^-negligible |y|. Returns std::nullopt if more bits are needed, also in the
    /// error maps.
    std::optional<std::vector<moved_value>> moved(proved_march& march, const number& time,
                                                  const std::vector<ball>& state, long negligible) const;

private:
    opened_flow flow_;
};

/// The unknowns and their lower derivatives at a time, in order.
struct conditioned_state {
    std::vector<proved_decimal> values;
    std::vector<moved_value> moved;
};

/// proved_trajectory() with the derivatives with respect to initial values and parameters, from one run: theorem V
/// encloses the derivative of the flow over each step for every point of the set, and their product in order is that of
/// the whole flow (chain rule). The bits of these maps are doubled until the digits are proved; the cost of that grows
/// with the square of their number. Throws like proved_trajectory.
std::vector<conditioned_state> proved_conditions(const equation_system& given, const std::vector<number>& times,
                                                 long digits, const march_watch& watch = {});

}  // namespace libration::ode
