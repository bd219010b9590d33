// Steps of theorem K, and where they pay off.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "decay_coordinates.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/collocation/collocation_integrator.hpp"
#include "libration/integration/integrator.hpp"
#include "libration/integration/rule.hpp"

namespace libration::ode {

/// The steps of theorem K instead of those of theorem V, and the choice when they begin and end, on which no proof
/// depends. Collocation begins where the solution is smooth over many steps of Taylor series
/// (collocation_integrator::is_smooth_over), which is checked after so many steps that a trial in vain at most doubles
/// the time, and ends when no mode has been fast for some steps, or when its steps are not much longer than those of
/// Taylor series.
///
/// It integrates the polynomial form, from the image of the set under the added unknowns (rigorous/lifted_set.hpp), and
/// the set of the given unknowns continues. This requires no derivative of the flow. If that is kept, it is from the
/// beginning of a period on part of the solution of the form with its variations (with_variations), which is then followed
/// instead.
///
/// Unknowns that have decayed within the period by as many bits as the precision has are followed in decay_coordinates,
/// if the equations permit it: steps need no longer resolve their decay.
class collocation_rule {
public:
    collocation_rule(const polynomial_form& of, long bits, const proof_route& route);

    /// Begins anew.
    void begin();
    /// The reason why the route, by collocation, is not possible; empty if it is.
    std::string obstacle(bool with_derivative) const;
    /// The first step of a period, after steps of this cost, where the next one by Taylor series has this length; the
    /// rest of the way is `rest`, with the sign of the direction. Null if it should not be tried, the solution is not
    /// smooth enough, or no step is proved. With the derivative of the flow if it is kept, whose fast columns begin with
    /// a separate layer.
    std::shared_ptr<const step> first(long cost, const flow_state& from, const magnitude& length, const ball& rest);
    /// Whether the state is the end of the last step of a period.
    bool made(const flow_state& from) const { return from.more != nullptr && from.more == period_; }
    /// Whether the period is to continue, after steps of this cost, as far as the length of steps is concerned.
    bool continues(long cost);
    /// A box that contains the given unknowns there.
    std::vector<ball> hull() const;
    /// The next step from such a state; null if none is proved.
    std::shared_ptr<const step> next(const flow_state& from);
    /// Such a state, from which another rule continues. Throws precision_exhausted if its set is a box only for lack of a
    /// better one.
    flow_state end_of(const flow_state& from);

private:
    bool is_worth_a_try(long cost, const magnitude& length, const ball& rest, bool with_derivative) const;
    std::shared_ptr<const step> made_from(const flow_state& from);
    long cost_of_step() const;
    long bits_of_steps() const;
    collocation_integrator& current() { return other_ ? *other_ : *integrator_; }
    const collocation_integrator& current() const { return other_ ? *other_ : *integrator_; }
    std::optional<tube_set> with_identity(const ball& time, const state_set& set, tube_set all) const;
    void follow_decay(const flow_state& from);
    void change_coordinates(const flow_state& from);
    // The number of steps up to the first check, and up to the next one after a period that was worth its cost.
    long first_interval() const;
    // Whether the frames of a step are computed in double (rounded_matrix), which makes it much cheaper.
    bool is_in_double() const;

    polynomial_form system_;
    long bits_;
    proof_route route_;
    std::optional<collocation_integrator> integrator_;
    std::optional<collocation_integrator> other_;  // of the form with variations or in coordinates, if that is followed
    std::optional<polynomial_form> varied_;        // the form with variations, if they are
    std::shared_ptr<const decay_coordinates> coordinates_;
    std::vector<double> largest_;            // log2 of the given unknowns, of their largest values in this period
    std::vector<std::size_t> decaying_;      // the unknowns for which coordinates were last searched
    std::shared_ptr<const carried> period_;  // of the present period; null between two
    std::optional<ball_matrix> derivative_;  // at the beginning of the period
    bool has_set_ = true;                    // whether the set of the given unknowns at its last end is not a box
    bool pays_ = true;                       // whether the last step was worth its cost
    long steps_of_period_ = 0;
    magnitude length_to_pay_;               // of a step that pays off
    long between_checks_, next_check_ = 0;  // in steps
};

}  // namespace libration::ode
