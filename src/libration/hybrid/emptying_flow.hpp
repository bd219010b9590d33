// The flow to the time at which a store becomes empty, in variables in which it is analytic.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/proof_route.hpp"

namespace libration::ode {

/// An expression as leaf^exponent times the rest, for leaf > 0.
struct leaf_power {
    rational exponent;
    expression rest;
};

leaf_power power_of_leaf(const expression& e, const expression& leaf);

/// x^exponent, x > 0.
ball power_of_ball(const ball& x, const rational& exponent);

/// -h' = h^exponent outflow, 0 < exponent < 1, h > 0 the unknown of this number.
struct store_outflow {
    std::size_t leaf;
    rational exponent;
    expression outflow;
};

/// Let m times each exponent of h in the equations be whole, and K = m (1 - exponent) - 1, which is 0 or more. With
/// h = v^m and dt = v^K ds, for v > 0
///     dv/ds = -outflow/m,   dy/ds = v^K f(t, y),   dt/ds = v^K,
/// of which the right-hand sides are analytic about v = 0 if the outflow and f are analytic functions of the powers of
/// h. The first zero of v is the time at which h becomes 0, where t, h and y are those of this flow. At a time by at most w
/// earlier than t*, in a box Z of states between, y is y(t*) + [-w, w] f(Z).
class emptying_flow {
public:
    /// From all states of a box, h > 0 in it, at a time. Throws error if the equations have no such form.
    emptying_flow(const explicit_system& branch, const store_outflow& of, const std::vector<ball>& state,
                  const ball& time, long bits, const proof_route& route);

    /// False if v is not proved to cross 0 within so many steps.
    bool reach(long most_steps);
    /// Whether a function of the unknowns and the variable of the branch is nonzero from the beginning to t*.
    bool excludes_zero(const expression& g);
    /// t*.
    const ball& time() const { return time_; }
    /// At t*.
    const std::vector<ball>& state() const { return state_; }
    /// At all times of the ball that are at most t*; unbounded if that is not enclosed.
    std::vector<ball> states_before();

private:
    expression in_roots(const expression& e) const;
    ball value(const expression& e, const std::vector<ball>& at) const;

    first_order_form form_;
    std::size_t leaf_;
    int root_ = 1;    // m
    int time_power_;  // K
    std::vector<expression> unknowns_;
    std::vector<expression> slopes_;  // by t, of the unknowns of the branch
    std::optional<explicit_system> flow_;
    std::vector<ball> start_;
    long bits_;
    std::unique_ptr<integration> along_;
    ball end_;  // s*
    ball time_;
    std::vector<ball> state_;
};

}  // namespace libration::ode
