// Taylor series or collocation: which of them makes the next step of a proof.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "box/box_choice.hpp"
#include "box/box_rule.hpp"
#include "collocation/collocation_rule.hpp"
#include "libration/integration/rule.hpp"
#include "taylor/taylor_rule.hpp"

namespace libration::ode {

/// Instead of a step of Taylor series in a direction: the part of it up to where another rule continues; null if none
/// does.
using step_before = std::function<std::shared_ptr<const step>(const series_step& whole, int direction)>;

/// Taylor series (theorem V, or G for many unknowns) from a regular state; they give the length with which collocation is compared. If the
/// equations are stiff, that is if the solution is smooth over many of these steps, collocation (theorem K) continues from
/// the same set, until no mode is fast.
class method_choice : public step_rule {
public:
    method_choice(const polynomial_form& of, const run_bits& bits, const proof_route& route, error_weights weights,
                  step_before other = {});
    /// From here on steps of theorem G may be chosen, for this system, of which `of` is the polynomial form: for many
    /// unknowns without the derivative of the flow, as long as they are predicted to cost less than those of theorem V.
    void allow_boxes(const explicit_system& system);

    void begin(const flow_state& start) override;
    next_step next(const flow_state& from, const ball& rest) override;

    /// Throws error of the subject "integrator" if the route is by collocation, which is not possible.
    void require_integrator(bool with_derivative) const;
    /// Steps of another rule count, too, in the comparison of costs.
    void count(long cost) { cost_ += cost; }

private:
    next_step next_after_collocation(const flow_state& from, const ball& rest);
    next_step next_by_series(const flow_state& from, const ball& rest);

    next_step next_by_box(const flow_state& from, const ball& rest);
    next_step next_with_columns(const flow_state& from, const ball& rest);
    next_step or_collocation(next_step by_series, const ball& rest);
    bool begins_by_box(const flow_state& start) const;
    bool loses_an_unknown(const std::vector<ball>& hull) const;

    polynomial_form form_;
    run_bits bits_;
    proof_route route_;
    error_weights weights_;
    step_before other_;
    std::unique_ptr<taylor_rule> taylor_;  // made when it is needed: n^2 series for n unknowns
    std::unique_ptr<box_rule> box_;
    std::optional<explicit_system> of_box_;  // if it may be chosen
    box_choice costs_;
    collocation_rule collocation_;
    bool by_box_ = false;
    bool series_begun_ = false;
    long cost_ = 0;
};

}  // namespace libration::ode
