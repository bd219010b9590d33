// What is known where a branch begins: the time t* and the state a there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/hybrid_system.hpp"
#include "libration/hybrid/hybrid_path.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// The order of the first derivative of a function along a solution that is nonzero at (t*, a), and its sign, which is
/// that of the function directly after t*; the sign is 0 if the function is 0 along the solution.
struct leading_derivative {
    int order = 0;
    int sign = 0;
};

/// The beginning of a branch: the initial point with the exact initial values, or the time of an event in a ball or as
/// an exact number, with an enclosure of the state after its resets. Functions are expressions in the leaves of the
/// system and the variable.
class branch_beginning {
public:
    /// The initial point.
    explicit branch_beginning(const hybrid_system& system);
    /// After an event: `reset` are the leaves in terms of their values before it, in which the functions `zero` are 0 at
    /// that time. `kept` are those of these values that are known exactly; empty if none is.
    branch_beginning(const hybrid_system& system, ball time, std::optional<number> exactly,
                     std::vector<expression> reset, std::vector<expression> zero, std::vector<ball> state,
                     kept_values kept = {});

    const hybrid_system& system() const { return system_; }
    /// The slopes of the leaves on the branch with these values of the step functions; std::nullopt if it has no
    /// explicit equations there, or is not continuous near (t*, a).
    std::optional<std::vector<expression>> slopes_on(const step_values& values) const;
    /// Whether the resets of the event change the function.
    bool is_reset(const expression& e) const { return !same_form(with_leaves(e, system_.leaves(), reset_), e); }
    /// Whether the function is finite at all points near (t*, a), so that it is continuous there.
    bool is_finite_near(const expression& e) const;

    ball value(const expression& e) const;
    /// The value at (t*, a) by exact arithmetic; std::nullopt if it is not known exactly.
    std::optional<number> exact_value(const expression& e) const;
    /// The values of the leaves that nothing changes on the branch, as far as they are known exactly: initial values, and
    /// fractions of at most 4096 bits after resets.
    kept_values kept() const;
    /// The sign at (t*, a). 0 only if that is proved: by exact arithmetic; because the function, after the resets, is
    /// identically 0, or 0 wherever one of the functions that are 0 there is. std::nullopt if it is not decided.
    std::optional<int> sign(const expression& e) const;
    /// The sign directly after t*, also of a function of the variable alone that is 0 at t*.
    std::optional<int> sign_after(const expression& e) const;
    /// Of a function along the solutions with these slopes. std::nullopt if it is not decided.
    std::optional<leading_derivative> leading(const expression& g, const std::vector<expression>& slopes) const;
    /// The derivative of a function along the solutions with these slopes.
    expression derivative(const expression& g, const std::vector<expression>& slopes) const;
    /// The integers near u/d at (t*, a).
    struct integers {
        number below;     ///< the largest integer <= u/d, if `at` is false
        bool at = false;  ///< whether u/d may be the integer `below`
    };
    /// Why an expression has no value at the exact values there, as "divides by zero"; std::nullopt if it may have one.
    std::optional<std::string> reason_without_value(const expression& e) const;
    /// std::nullopt if u/d may be two integers.
    std::optional<integers> integers_of(const expression& u, const number& divisor) const;

    static constexpr int most_orders = 8;

private:
    expression with_known_values(const expression& e) const;
    expression before(const expression& e) const;
    bool is_zero(const expression& in_values_before) const;
    ball value_at(const expression& e, const std::vector<ball>& state, const ball& time) const;

    const hybrid_system& system_;
    ball time_;
    std::optional<number> exactly_;
    std::vector<expression> reset_;  // exact initial values at the initial point
    std::vector<expression> zero_;
    kept_values kept_;                      // before the event
    std::vector<expression> plain_leaves_;  // for the leaves of the system, without derivatives
    std::vector<ball> state_;
    ball near_time_;
    std::vector<ball> near_state_;
    number point_;  // of the branches, with the midpoints of the state
    std::vector<number> midpoints_;
};

/// Replaces the values that are known exactly.
void put_kept(const kept_values& kept, std::vector<ball>& state);
/// The slopes of the unknowns and lower derivatives of a system, in these.
std::vector<expression> slopes_in_given(const explicit_system& system);
/// The midpoints of balls as numbers.
std::vector<number> midpoints_of(const std::vector<ball>& state);
/// An exact ball as a number.
number number_of(const ball& exact);
/// A number as a ball.
ball enclosed_number(const number& x);

}  // namespace libration::ode
