// The steps of a proof across a time with roots, in a root of the distance from it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "libration/integration/proved_march.hpp"
#include "libration/integration/root/root_time.hpp"

namespace libration::ode {

/// Near a time tau with roots the solution y(tau + side w^degree) is analytic in w, and is continued in w by theorem V:
/// from a time before tau up to one after it where the roots are real on both sides, otherwise up to tau itself, where it
/// ends; and from tau on if that is the initial point. A step from w to w + h is a step in t of the length |(w + h)^degree
/// - w^degree|, which is exact, as w and h are.
class root_rule : public enclosed_step {
public:
    /// A step in t up to where the phase is to begin.
    class entry_step : public enclosed_step {
    public:
        entry_step(const proved_step& within, ball distance) : within_(&within), distance_(std::move(distance)) {}

        const ball& distance() const { return distance_; }
        ball length_of_step() const override;
        std::vector<ball> values_at(const ball& distance) const override { return within_->values_at(distance); }

    private:
        const proved_step* within_;
        ball distance_;
    };

    root_rule(const explicit_system& of, std::vector<root_time> times, long bits, long error_bits, proof_route route);

    bool is_active() const { return inner_ != nullptr; }
    /// The part of a step from this time that leads to where the phase is to begin, because it is short as roots are
    /// ahead; nullptr if they are not.
    const entry_step* entry(const ball& time, const proved_step& step, int direction);
    /// The same, until the phase begins or it is dropped.
    const std::optional<entry_step>& prepared_entry() const { return entry_; }
    void drop_entry() { entry_.reset(); }
    /// Begins there, from the set at its end; the derivative of the flow from there on is kept if asked.
    void begin(state_set set, bool with_derivative);
    /// Begins at an initial point with a series in powers of (t - t0)^(1/degree), at t0 or, if the equation in w is
    /// singular, after its first step. Throws like proved_singular_step.
    void begin_at_start(const explicit_system& system);
    /// To be called before the first step from there: as of proved_march from a set of any width, and with the derivative.
    void accept_any_width() { inner_->scales_.accept_any_width(); }
    void keep_derivative() { inner_->keep_derivative(); }
    /// Enclosures of all values before the time where it begins.
    const std::vector<ball>& before() const { return inner_->before(); }
    /// Prepares the next step; false if none is proved, for the reason end().
    bool prepare();
    /// Takes the prepared step.
    void step();
    /// Whether steps lead in this direction of t, and not yet beyond the roots.
    bool leads_towards(int direction) const;
    void leave() { inner_.reset(); }

    march_end end() const { return at_last_time_ ? march_end::steps : inner_->end(); }
    /// The time reached.
    ball time() const;
    /// The set and the derivative of the flow there, except at the last time.
    const state_set& set() const { return inner_->set(); }
    const ball_matrix& derivative() const { return *inner_->derivative(); }
    /// Of the prepared step.
    ball_matrix derivative_at(const ball& distance) const { return inner_->derivative_at(root_at(distance)); }
    const proved_step& prepared() const { return *prepared_; }
    ball length_of_step() const override;
    std::vector<ball> values_at(const ball& distance) const override;
    std::vector<ball> slopes_at(const ball& distance) const override;

private:
    void begin_with(std::unique_ptr<proved_march> inner);
    std::vector<ball> values_in_root(const ball& w) const;
    std::vector<ball> slopes_in_root(const ball& w, const std::vector<ball>& state) const;
    ball distance_of(const ball& w) const;
    ball root_at(const ball& distance) const;
    ball root_after_step() const;

    first_order_form form_;
    std::vector<root_time> times_;
    long bits_, error_bits_;
    proof_route route_;
    std::optional<entry_step> entry_;
    root_time start_;  // if the phase begins at the initial point
    const root_time* about_ = nullptr;
    std::vector<expression> slopes_;  // dy/dt in w
    ball begins_, ends_;              // w where the phase begins and ends, exact
    int direction_ = 1;               // of w
    std::unique_ptr<proved_march> inner_;
    const proved_step* prepared_ = nullptr;
    bool leads_beyond_ = false;  // the solution continues in t after the phase
    bool has_moved_ = false;
    bool at_last_time_ = false;  // at tau, beyond which the roots are not real
};

}  // namespace libration::ode
