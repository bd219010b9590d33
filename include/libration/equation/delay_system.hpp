// Delay differential equations, as systems of ordinary ones while the delayed unknowns are known functions.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"

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
///
/// Neutral equations have delayed highest derivatives, such as x'(t - 1) in an equation x' = ... . Where that is no
/// longer the derivative of the history, it is the right-hand side of its equation at the earlier time, so that it is
/// replaced by values with further delays, and so on: x' = x'(t - 1) + x has the delays 1, 2, ... .
class delay_system {
public:
    /// Of neutral equations, the stages are those up to the time `last`, of others all of them.
    ///
    /// Throws error like explicit_system, for delays that are not positive, delayed derivatives that are higher than the
    /// highest one or of an unknown without an equation x' = ..., a delayed unknown without history, an unknown with a
    /// history and an initial value, and a singular initial point.
    explicit delay_system(const equation_system& given, const std::optional<number>& last = {});

    /// Whether a highest derivative is delayed.
    bool is_neutral() const { return !slopes_.empty(); }

    /// The unknowns and their lower derivatives, as in names_of_state.
    const std::vector<expression>& leaves() const { return leaves_; }
    /// Their values at the initial point.
    const std::vector<number>& starts() const { return starts_; }
    const number& point() const { return point_; }
    /// Ascending, each once.
    const std::vector<number>& delays() const { return delays_; }
    const std::vector<delayed_leaf>& delayed() const { return delayed_; }

    /// The equations where the first `passed` delays refer to the solution and the others to the history, from a state
    /// of the leaves and of the inputs, value and slope of each in order. Throws error like explicit_system, and of the
    /// kind undecided beyond the last time of neutral equations.
    delay_stage stage(std::size_t passed, const number& point, const std::vector<number>& leaves,
                      const std::vector<number>& inputs) const;
    /// The equations directly after the initial point.
    delay_stage first_stage() const { return stage(0, point_, starts_, {}); }
    /// The same as equations in the given unknowns, with their initial values.
    explicit_system first_equations() const { return explicit_system(equations(0)); }

private:
    /// A delayed highest derivative, and the right-hand side of its equation at the earlier time; std::nullopt if that is
    /// not needed up to the last time.
    struct delayed_slope {
        delayed_value value;
        std::size_t delay = 0;
        std::optional<expression> right = {};
    };

    void read_histories(parameter_values& parameters);
    void read_delays(parameter_values& parameters);
    void expand_slopes(const std::optional<number>& last);
    void order_delays();
    void read_starts();
    expression right_side_of(const delayed_value& slope) const;
    expression earlier(const expression& e, const number& delay);
    expression delayed(const expression& of, const number& delay, const place& at);
    const history* history_of(const std::string& unknown) const;
    expression of_history(const expression& of, std::size_t delay) const;
    std::map<std::string, expression> delayed_values(std::size_t passed) const;
    equation_system equations(std::size_t passed) const;

    equation_system given_;  // without parameters, except those of the delayed values, and with the starts of histories
    std::vector<expression> leaves_;
    std::vector<number> starts_;
    number point_;
    std::vector<number> delays_;
    std::vector<delayed_leaf> delayed_;  // in the order of given_.delays, from which slopes are removed
    std::vector<delayed_slope> slopes_;
};

/// The names of the unknowns and their lower derivatives, in order: x, x', ...
std::vector<std::string> names_of_state(const delay_system& system);

}  // namespace libration::ode
