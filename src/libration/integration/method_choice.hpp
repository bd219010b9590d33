// The periods in which the integrator of theorem K replaces that of theorem V.
#pragma once

#include <optional>
#include <string>

#include "collocation/decay_coordinates.hpp"
#include "libration/integration/collocation/collocation_integrator.hpp"
#include "libration/integration/enclosed_step.hpp"
#include "libration/integration/integrator.hpp"
#include "libration/integration/proof_route.hpp"

namespace libration::ode {

/// The steps of theorem K instead of those of theorem V, and the choice when they begin and end, on which no proof
/// depends. Collocation begins where the solution is smooth over many steps of Taylor series
/// (collocation_integrator::is_smooth_over), which is checked after so many steps that a trial in vain at most doubles
/// the time, and ends when no mode has been fast for some steps, or when its steps are not much longer than those of
/// Taylor series.
///
/// The derivative of the flow from the beginning of a period on is part of the solution of the form with its variations
/// (with_variations), which is then followed instead.
///
/// Unknowns that have decayed within the phase by as many bits as the precision has are followed in decay_coordinates,
/// if the equations permit it: steps need no longer resolve their decay.
class method_choice : public enclosed_step {
public:
    method_choice(const polynomial_form& of, long bits, const proof_route& route);

    bool is_active() const { return active_; }
    /// A step counts as so many of Taylor series, which take about as long.
    long cost_of_step() const;
    /// The reason why the route, by collocation, is not possible; empty if it is.
    std::string obstacle(bool with_derivative) const;
    /// True if it should be tried after `steps` steps at this time, where the next one by Taylor series has this
    /// length; the rest of the way is `rest`, with the sign of the direction.
    bool may_begin(long steps, const magnitude& length, const ball& rest, bool with_derivative) const;
    /// Begins from a set of the given unknowns, if the solution is smooth enough and a step is proved; true if that
    /// step is prepared. With the derivative of the flow if asked, whose fast columns begin with a separate layer.
    bool begin(long steps, const ball& time, const state_set& set, const magnitude& length, const ball& rest,
               bool with_derivative);
    /// Prepares the next step; false if none is proved.
    bool prepare() { return current().prepare(); }
    /// Notes that the prepared step is used, once for each.
    void use();
    /// Notes the time up to which it is used, while it is.
    void reach(const ball& time);
    /// Takes the prepared step, the last of `steps`. False if Taylor series are to continue.
    bool step(long steps);
    void end() { active_ = false; }

    const collocation_integrator& integrator() const { return other_ ? *other_ : *integrator_; }
    const collocation_use& all() const { return use_; }
    /// Of the prepared step.
    ball length_of_step() const override;
    std::vector<ball> values_at(const ball& distance) const override;
    std::vector<ball> slopes_at(const ball& distance) const override;
    /// A box that contains the given unknowns in the present set.
    std::vector<ball> hull() const;
    /// The present set of the given unknowns; std::nullopt if none is found.
    std::optional<state_set> set() const;
    /// The derivative of the given unknowns with respect to those at the beginning of the period, for all solutions: in
    /// the present set, and at a distance from the beginning of the prepared step.
    ball_matrix derivative() const { return derivative_in(integrator().set().hull()); }
    ball_matrix derivative_at(const ball& distance) const { return derivative_in(integrator().values_at(distance)); }

private:
    long bits_of_steps() const;
    collocation_integrator& current() { return other_ ? *other_ : *integrator_; }
    std::optional<tube_set> with_identity(const ball& time, const state_set& set, tube_set all) const;
    ball_matrix derivative_in(const std::vector<ball>& state) const;
    std::vector<ball> given_of(const ball& time, std::vector<ball> state) const;
    void follow_decay();
    void change_coordinates();
    // The number of steps up to the first check, and up to the next one after a period that was worth its cost.
    long first_interval() const;
    // Whether the frames of a step are computed in double (rounded_matrix), which makes it much cheaper.
    bool is_in_double() const;

    const polynomial_form& system_;
    long bits_;
    proof_route route_;
    std::optional<collocation_integrator> integrator_;
    std::optional<collocation_integrator> other_;  // of the form with variations or in coordinates, if that is followed
    std::optional<polynomial_form> varied_;        // the form with variations, if they are
    std::optional<decay_coordinates> coordinates_;
    std::vector<double> largest_;        // log2 of the given unknowns, of their largest values in this phase
    std::vector<std::size_t> decaying_;  // the unknowns for which coordinates were last searched
    bool active_ = false;
    collocation_use use_;
    long steps_of_phase_ = 0;
    magnitude length_to_pay_;               // of a step that pays off
    long between_checks_, next_check_ = 0;  // in steps
};

}  // namespace libration::ode
