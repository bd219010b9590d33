// Delay differential equations, as systems of ordinary ones while the delayed unknowns are known functions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"

namespace libration::ode {

/// A delayed value in the equations: the unknown or lower derivative of this index in the state, and the delay.
struct delayed_leaf {
    std::size_t leaf = 0;
    std::size_t delay = 0;
};

/// A delayed value of the solution in a stage: in its system, `value` is the index of v(t) = x(t - delay), with the
/// equation v' = w, and `slope` that of w, with w' = 0 instead of its true equation.
struct delayed_input {
    delayed_leaf of;
    std::size_t value = 0;
    std::size_t slope = 0;
};

/// The equations while some of the delayed values are those of the history, and the others, the inputs, those of the
/// solution. The system is of first order, without initial values; its unknowns are the leaves of the given system and
/// then value and slope of each input.
struct delay_stage {
    explicit_system system;
    std::vector<delayed_input> inputs;
};

/// Equations with constant delays, with numbers for their parameters.
class delay_system {
public:
    /// Throws error like explicit_system, for delays that are not positive, delayed highest derivatives, a delayed
    /// unknown without history, an unknown with a history and an initial value, and a singular initial point.
    explicit delay_system(const equation_system& given);

    /// The unknowns and their lower derivatives, as in names_of_state.
    const std::vector<expression>& leaves() const { return leaves_; }
    /// Their values at the initial point.
    const std::vector<number>& starts() const { return starts_; }
    const number& point() const { return point_; }
    /// Ascending, each once.
    const std::vector<number>& delays() const { return delays_; }
    const std::vector<delayed_leaf>& delayed() const { return delayed_; }

    /// The equations where the first `passed` delays refer to the solution and the others to the history, from a state
    /// of the leaves and of the inputs, value and slope of each in order. Throws error like explicit_system.
    delay_stage stage(std::size_t passed, const number& point, const std::vector<number>& leaves,
                      const std::vector<number>& inputs) const;
    /// The equations directly after the initial point.
    delay_stage first_stage() const { return stage(0, point_, starts_, {}); }
    /// The same as equations in the given unknowns, with their initial values.
    explicit_system first_equations() const { return explicit_system(equations(0)); }

private:
    void read_histories(parameter_values& parameters);
    void read_delays(parameter_values& parameters);
    void read_starts();
    const history* history_of(const std::string& unknown) const;
    expression of_history(std::size_t delayed) const;
    equation_system equations(std::size_t passed) const;

    equation_system given_;  // without parameters, except those of the delayed values, and with the starts of histories
    std::vector<expression> leaves_;
    std::vector<number> starts_;
    number point_;
    std::vector<number> delays_;
    std::vector<delayed_leaf> delayed_;  // in the order of given_.delays
};

/// The names of the unknowns and their lower derivatives, in order: x, x', ...
std::vector<std::string> names_of_state(const delay_system& system);

}  // namespace libration::ode
