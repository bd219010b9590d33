// Systems with events and step functions, as smooth systems between events.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"

namespace libration::ode {

/// The values of the step functions of a system, in order: -1, 0 or 1 for a sign, which is 0 where its argument is 0 on
/// the whole branch, and an integer for a floor; sliding_value() for the sign along the surface of which the solution
/// slides, whose argument is 0, too.
using step_values = std::vector<number>;

/// 1/2, which is not a value of a step function.
number sliding_value();

/// What happens where a function g crosses 0: the event or the step function of this index. `orientation` is
/// 1 if its own function, left - right, the argument or its distance from a level of floor, has the sign of g, -1 if it
/// has the opposite sign.
struct crossing_effect {
    std::size_t index = 0;
    int orientation = 1;
};

/// The zeros of a function on a branch, and what happens at them.
struct surface {
    /// In unknowns, lower derivatives and the variable; of a known time, the distance to it.
    expression g;
    /// The only time at which g is 0, if g is linear in the variable and does not depend on anything else; for floor(u)
    /// the next one.
    std::optional<number> time;
    std::vector<crossing_effect> events, steps;
    std::string text;  ///< of the first of them, as written
};

/// The largest integer n with n divisor <= x, by exact comparisons; the divisor is positive.
number floor_of(const number& x, const number& divisor);

/// The sign of the quotient of two expressions if it is a constant that is found: for equal or opposite forms, and for
/// linear expressions, or sums of the same other expressions, with fractions as coefficients; 0 for others.
int relative_sign(const expression& a, const expression& b);

/// The derivative of the state with respect to a number, if its values are unknowns of the same system: for each value
/// of the state the index of its derivative; std::nullopt for one that is 0, and for these derivatives themselves.
using state_variation = std::vector<std::optional<std::size_t>>;

/// Equations with events and step functions. With numbers for the step functions they are a smooth system, a branch,
/// which is valid until an event, the crossing of one of its surfaces.
class hybrid_system {
public:
    /// Throws error for values that are reset and are not part of the state, and for events at all times or never.
    explicit hybrid_system(const equation_system& given);

    /// The values of the state before any branch is known, in the order of names_of_state.
    const std::vector<expression>& leaves() const { return leaves_; }
    const std::vector<number>& starts() const { return starts_; }
    const number& point() const { return point_; }
    const std::string& variable() const { return given_.variable; }
    const std::vector<state_event>& events() const { return given_.events; }
    const std::vector<step_function>& steps() const { return given_.steps; }
    /// The expressions in further columns, in leaves of the state, the variable and step functions.
    const std::vector<definition>& shown() const { return given_.shown; }
    /// The derivatives of the state that are part of it: theorem H gives their values after an event.
    const std::vector<state_variation>& variations() const { return variations_; }
    void add_variation(state_variation variation) { variations_.push_back(std::move(variation)); }

    /// Whether an expression depends on the state, but only on values that nothing except resets changes: of an unknown n
    /// with n' = 0, or a derivative x' with x'' = 0, that is not itself a derivative with respect to a number.
    bool is_kept(const expression& e) const;
    /// Whether so does the condition of an event on step functions, which then begins to hold by a reset alone.
    bool is_kept(const state_event& event) const;
    /// Whether the condition of an event on step functions holds where they have these values; false for other events.
    bool holds(const state_event& event, const step_values& values) const;

    /// An expression in leaves and step functions, where these have such values.
    expression on_branch(const expression& e, const step_values& values) const;

    /// The smooth system with these values of the step functions and this initial state. Throws error like
    /// explicit_system.
    explicit_system branch(const step_values& values, const number& point, const std::vector<number>& state) const;
    /// The equations of the branch from the initial values of the problem, and the branch.
    equation_system first_equations(const step_values& values) const { return equations(values, point_, starts_); }
    explicit_system first_branch(const step_values& values) const { return branch(values, point_, starts_); }
    /// The index of the step function that a parameter in the equations represents.
    std::size_t step_of(const std::string& parameter) const { return step_places_.at(parameter); }
    /// The step functions that influence an expression along the solution: those in it, in the equations of the unknowns
    /// in it, and so on. All of them if the equations are not given for the highest derivatives.
    std::vector<bool> influences_on(const expression& e) const;
    /// The argument of a step function, where earlier ones have these values.
    expression argument(std::size_t step, const step_values& values) const;
    /// Its value for a number as its argument.
    number step_value(std::size_t step, const number& argument) const;
    /// Its value if the argument is constant on the branch.
    std::optional<number> constant_step(std::size_t step, const step_values& values) const;
    /// Whether it is a sign that is 0 on the branch although its argument is not constant, nor kept between events.
    bool is_at_rest(std::size_t step, const step_values& values) const;
    /// Whether it is such a sign along the surface of which the solution slides: the right-hand side of the branch is the
    /// convex combination of those on both sides along which the argument remains 0 (theorem H, "Sliding").
    bool is_sliding(std::size_t step, const step_values& values) const;
    /// The surfaces of a branch whose crossing matters, each once: those of floor(u/d) = n are u = n d and
    /// u = (n + 1) d.
    std::vector<surface> surfaces(const step_values& values) const;
    /// Adds a surface for the zeros of a function, or returns the one that has them.
    static surface& add_surface(std::vector<surface>& to, const expression& g, const std::string& text);

private:
    equation_system equations(const step_values& values, const number& point, const std::vector<number>& state) const;
    void keep_both_sides(std::size_t step, const step_values& values, equation_system& of) const;
    void require_explicit(std::size_t step) const;
    expression right_side_of(const expression& leaf, const step_values& values) const;
    expression slope_beside(std::size_t step, int side, step_values values) const;
    expression share_above(std::size_t step, const step_values& values) const;
    std::vector<std::size_t> sliding_steps(const step_values& values) const;
    expression with_means(const expression& e, const step_values& values) const;
    void slide(const step_values& values, equation_system& of) const;
    void add_ends_of_sliding(std::size_t step, const step_values& values, std::vector<surface>& to) const;
    std::vector<definition> parameters_on(std::size_t step, const step_values& values) const;
    void read_starts(parameter_values& parameters);
    void read_dependence();
    void read_still_leaves();
    void add_influences(const expression& e, std::set<std::string>& unknowns, std::vector<bool>& steps) const;
    void require_state_in_events() const;
    std::vector<expression> levels(std::size_t step, const expression& u, const number& value) const;

    equation_system given_;  // without parameters, except those of the step functions
    std::vector<expression> leaves_;
    std::vector<number> starts_;
    number point_;
    std::vector<state_variation> variations_;
    std::vector<bool> still_;  // the leaves with the slope 0 on each branch
    std::map<std::string, std::size_t> step_places_;
    std::map<std::string, std::size_t> equation_places_;  // of unknowns; empty if one is not given explicitly
};

/// Replaces parameters in the equations, step functions and events of a system.
void put_values(equation_system& in, parameter_values& parameters);

/// The expression with leaves replaced by the expression of the same index.
expression with_leaves(const expression& e, const std::vector<expression>& leaves, const std::vector<expression>& by);

/// The names of the unknowns and their lower derivatives, in order: x, x', ...
std::vector<std::string> names_of_state(const hybrid_system& system);

/// a t + b in the variable t with constants a != 0, b; std::nullopt for other expressions.
struct linear_in_variable {
    number slope, at_zero;
    static std::optional<linear_in_variable> of(const expression& e);
    /// Where it has this value.
    number time_of(const number& value) const { return (value - at_zero) / slope; }
};

}  // namespace libration::ode
