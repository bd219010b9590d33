// Which method makes the next step of a proof.
#pragma once

#include <memory>
#include <optional>

#include "collocation/collocation_rule.hpp"
#include "libration/integration/rule.hpp"
#include "libration/integration/singular/singular_step.hpp"
#include "root/root_rule.hpp"
#include "taylor/taylor_rule.hpp"

namespace libration::ode {

/// Taylor series (theorem V) from a regular state; they give the length with which the others are compared. If the
/// equations are stiff, that is if the solution is smooth over many of these steps, collocation (theorem K) continues from
/// the same set, until no mode is fast. Times with roots (root_time.hpp) are crossed by steps in a root of the
/// distance from them, in which the solution is analytic. A singular initial point is left by a step of theorem S.
class method_choice : public step_rule {
public:
    method_choice(const explicit_system& of, const run_bits& bits, const proof_route& route, error_weights weights);

    void begin(const flow_state& start) override;
    next_step next(const flow_state& from, const ball& rest) override;

private:
    next_step next_method(const flow_state& from, const ball& rest);
    next_step next_at_start(const flow_state& from, int direction);
    next_step next_after_collocation(const flow_state& from, const ball& rest);
    next_step next_by_series(const flow_state& from, const ball& rest);
    void require_integrator(bool with_derivative) const;
    void require_given_start(const flow_state& start) const;

    explicit_system of_;
    run_bits bits_;
    proof_route route_;
    std::optional<singular_step> singular_;  // the first step from a singular initial point without roots
    std::unique_ptr<taylor_rule> taylor_;
    std::unique_ptr<collocation_rule> collocation_;
    std::unique_ptr<root_rule> roots_;                   // if there are times with roots
    std::shared_ptr<const root_passage> first_passage_;  // if one of them is the initial point
    bool at_start_ = true;
    bool series_begun_ = false;
    long cost_ = 0;
};

}  // namespace libration::ode
