// The periods in which the integrator of theorem K replaces that of theorem V.
#pragma once

#include <optional>
#include <string>

#include "libration/ode/integrator.hpp"
#include "libration/ode/proved/proof_route.hpp"
#include "libration/ode/rigorous/collocation_integrator.hpp"

namespace libration::ode {

/// Decides when collocation begins and ends; no proof depends on it. It begins where the solution is smooth over many
/// steps of Taylor series (collocation_integrator::is_smooth_over), which is checked after so many of them that a trial
/// in vain at most doubles the time, and ends when no mode has been fast for some steps, or when its steps are not much
/// longer than those of Taylor series.
class collocation_phase {
public:
    collocation_phase(const lifted_system& of, long bits, const proof_route& route);

    bool is_active() const { return active_; }
    /// A step counts as so many of Taylor series, which take about as long.
    long cost_of_step() const;
    /// The reason why the route, by collocation, is not possible; empty if it is.
    std::string obstacle() const;
    /// True if it should be tried after `steps` steps at this time, where the next one by Taylor series has this
    /// length; the rest of the way is `rest`, with the sign of the direction.
    bool may_begin(long steps, const magnitude& length, const ball& rest) const;
    /// Begins from a set of the given unknowns, if the solution is smooth enough and a step is proved; true if that
    /// step is prepared.
    bool begin(long steps, const ball& time, const state_set& set, const magnitude& length, const ball& rest);
    /// Prepares the next step; false if none is proved.
    bool prepare() { return integrator_->prepare(); }
    /// Notes that the prepared step is used, once for each.
    void use();
    /// Notes the time up to which it is used.
    void reach(double time) { use_.last = time; }
    /// Takes the prepared step, the last of `steps`. False if Taylor series are to continue.
    bool step(long steps);
    void end() { active_ = false; }

    const collocation_integrator& integrator() const { return *integrator_; }
    const collocation_use& all() const { return use_; }

private:
    // The number of steps up to the first check, and up to the next one after a period that was worth its cost.
    long first_interval() const;

    const lifted_system& system_;
    long bits_;
    proof_route route_;
    std::optional<collocation_integrator> integrator_;
    bool active_ = false;
    collocation_use use_;
    long steps_of_phase_ = 0;
    magnitude length_to_pay_;               // of a step that is worth its cost
    long between_checks_, next_check_ = 0;  // in steps
};

}  // namespace libration::ode
