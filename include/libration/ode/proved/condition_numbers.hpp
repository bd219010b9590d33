// How much a solution moves when the numbers that its problem was written with move: what no program can be blamed for.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/equation_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

/// By how much a value y moves where what goes in moves by a part of itself, to first order; |y| times the condition
/// numbers. Three digits are proved, or that it is below 10^-9 |y|, which is 0 here; where y is exactly 0 they are
/// heuristic. A number that is 0 does not move.
struct moved_value {
    mpfr by_start;       ///< sum over the starts s of |dy/ds| |s|
    mpfr by_parameters;  ///< the same over the parameters; exponents, and what other parameters are made of alone: none
    mpfr by_time;        ///< |dy/dt| |t|
    mpfr by_rounding;    ///< |sum over starts and parameters x of dy/dx (double(x) - x)|
};

/// A problem whose parameters are unknowns that do not change (opened), so that the derivative of its flow is that by
/// starts and parameters.
class dependence {
public:
    /// Of these unknowns and those that they depend on; of all where none is named. Throws error as explicit_system does.
    explicit dependence(const equation_system& given, const std::vector<std::string>& unknowns = {});
    ~dependence();

    /// The unknowns of the problem and its parameters, in the order in which the equations name them.
    const explicit_system& system() const;
    /// The places of the unknowns of the problem and their lower derivatives, in order, in the state of that.
    const std::vector<std::size_t>& own() const;
    /// Their names: x, x', ...
    const std::vector<std::string>& names() const;
    /// By how much these move, for a march along system() that keeps its derivative, at a time where it is in this
    /// state. by_rounding is 0 below 10^-negligible |y|. Nothing where it needs more bits, of the maps of errors too.
    std::optional<std::vector<moved_value>> moved(const proved_march& march, const number& time,
                                                  const std::vector<ball>& state, long negligible) const;

private:
    struct open_problem;
    std::unique_ptr<const open_problem> open_;
};

/// The unknowns and their lower derivatives at a time, in order.
struct conditioned_state {
    std::vector<proved_decimal> values;
    std::vector<moved_value> moved;
};

/// proved_trajectory() with the derivatives by starts and parameters, from one run: theorem V encloses the derivative
/// of the flow over each step for every point of the set, and their product in order is that of the whole flow (chain
/// rule). The bits of these maps are doubled until the digits are there; what that costs grows with their square.
/// Throws as proved_trajectory.
std::vector<conditioned_state> proved_conditions(const equation_system& given, const std::vector<number>& times,
                                                 long digits, const march_watch& watch = {});

}  // namespace libration::ode
