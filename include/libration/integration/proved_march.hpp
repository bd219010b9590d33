// Enclosures of the solution of any system at any time: high precision for the centre, low for the error.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/integration/collocation/tube.hpp"
#include "libration/integration/enclosed_step.hpp"
#include "libration/integration/proof_route.hpp"
#include "libration/integration/singular/singular_step.hpp"
#include "libration/integration/taylor/proved_step.hpp"
#include "libration/integration/taylor/step_length.hpp"

namespace libration::ode {

class method_choice;
class root_rule;

/// Progress callback, called occasionally between two steps with the time reached by a run and the bits it began with.
/// An exception that it throws ends the run, which can be continued afterwards.
using march_watch = std::function<void(const ball& reached, long bits)>;

/// Theorem V. The solution remains in c + Q [-r, r], c exact, from step to step: Phi, the flow over a step h, maps c
/// into c' + [-tau, tau] by theorem T from the exact point (tau contains the tail, the radii of its balls, the rounding
/// of c'), and A, from theorem T for the system with its variations over the whole set, contains the derivative of Phi
/// at every point of the set, which is convex; so Phi of the set lies in c' + A Q [-r, r] + [-tau, tau]
/// (lohner_set). Proof: Phi(z) - Phi(c) = (int_0^1 DPhi(c + x (z - c)) dx)(z - c).
///
/// If the equations are stiff along the way of prepare_towards(), that is if the solution is smooth over many of these steps, the
/// integrator of theorem K (rigorous/collocation_integrator.hpp) continues from the same set, until no mode is fast. It
/// integrates the polynomial form, from the image of the set under the added unknowns (rigorous/lifted_set.hpp), and
/// the set of the given unknowns continues. This requires no derivative of the flow.
///
/// Along the way of prepare_towards(), times with roots (root_time.hpp) are crossed by steps in a root of the distance
/// from them, in which the solution is analytic.
///
/// The unknowns are those of the given system with their lower derivatives; the other unknowns of theorem T
/// (polynomial_form) are computed from them in each step. The precision decreases as the set grows: digits below its
/// width are noise.
///
/// Each unknown has its own relative precision: the set is kept in scales 2^k near the sizes of the unknowns on the
/// step (lohner_set::settled), and tails are bounded relative to the size of their unknown or to the set's own width
/// (step_length.hpp). An unknown that is 0 at all times remains an exact 0: its centre, tail and row of A are exact
/// zeros. One that is not distinguished from 0 for another reason has no effect on the steps; one that was
/// distinguished before, and is no longer, ends the proof for lack of precision.
class proved_march : public enclosed_steps {
public:
    static constexpr long most_steps = 10'000'000;
    static constexpr long usual_error_bits = 64;

    /// From the initial point, with so many bits; the error maps have error_bits, the precision of derivative_at().
    /// From a singular initial point after a step of theorem S (singular_step.hpp), whose errors it throws. Throws
    /// error of the subject "integrator" if the route is by collocation, which does not support this system or
    /// precision.
    proved_march(const explicit_system& system, long bits, march_watch watch = {}, long error_bits = usual_error_bits,
                 const proof_route& route = {});
    /// The same from all initial values in a box of balls, the given unknowns at the point of the system.
    proved_march(const explicit_system& system, const std::vector<ball>& start, long bits,
                 long error_bits = usual_error_bits, march_watch watch = {}, const proof_route& route = {});
    /// The same from all states of a set, of any number of columns (lohner_set). It is of any width: the proof ends when
    /// no step is found, instead of when an unknown is not distinguished from 0.
    proved_march(const explicit_system& system, state_set start, long bits, march_watch watch = {},
                 const proof_route& route = {});
    ~proved_march() override;

    /// The given unknowns at a time, enclosing each solution through the initial set; times in one direction, away from
    /// the initial point. Returns std::nullopt if the proof ends before, for the reason end().
    std::optional<std::vector<ball>> at(const number& time);
    /// The same at every time of a ball.
    std::optional<std::vector<ball>> at(const ball& target);

    /// To be called before the first step: the observer is called for each step that is used.
    void observe(step_observer observer) { observer_ = std::move(observer); }
    /// To be called before the first step: errors are weighted absolutely, as for a solution that tends to a constant
    /// while its derivative vanishes much faster (unknown_scales::weigh_by_errors).
    void weigh_by_errors() { scales_.weigh_by_errors(); }
    /// To be called before the first step: the derivative of the flow is kept, dy(t)/dy(t0) for all initial values of
    /// the set; from a singular initial point with respect to its values themselves (singular_step.hpp,
    /// derivative_beyond_start, whose errors it throws).
    void keep_derivative();
    /// The unknowns before the first step: empty, or after a singular initial point enclosures of all their values up
    /// to the point where the integration begins.
    const std::vector<ball>& before() const { return before_; }
    /// The derivative at a time for which at() has just been called.
    ball_matrix derivative_at(const ball& time) const;
    /// The derivative at reached(), if it is kept.
    const std::optional<ball_matrix>& derivative() const { return derivative_; }
    /// The set at reached().
    const state_set& set() const { return set_; }

    /// The step from reached() towards times at this distance, infinite if there is no last one, by either integrator,
    /// computed once and valid until the next one is taken. Returns nullptr if the proof ends here.
    const enclosed_step* prepare_towards(const ball& rest) override;
    /// Takes the whole step that prepare_towards() has returned, forwards for direction >= 0.
    void take_prepared(int direction) override;
    /// Notes, for collocation() and the observer, that the step that prepare_towards() has returned is used up to this
    /// time.
    void use_prepared(const ball& time, int direction);

    /// The same by Taylor series.
    const proved_step* prepare();
    /// Takes the whole step that prepare() has returned, forwards for direction >= 0.
    void take(const proved_step& prepared, int direction);

    march_end end() const override { return end_; }
    /// The time up to which the solution is proved to exist.
    const ball& reached() const override { return time_; }
    /// A step of collocation counts as 32.
    long steps() const override { return steps_; }
    /// The initial number of bits.
    long bits() const override { return bits_; }
    /// Where collocation was used.
    const collocation_use& collocation() const;

private:
    proved_march(const explicit_system& system, state_set start, const std::vector<ball>& hull, long bits,
                 long error_bits, march_watch watch, const proof_route& route);
    proved_march(singular_step begin, long bits, march_watch watch, long error_bits, const proof_route& route);
    friend class root_rule;

    ball distance_to(const ball& target) const;
    void move(const proved_step& prepared, const ball& distance);
    void enter_roots(int direction);
    void step_in_root(int direction);
    void leave_roots();
    void make_step();
    bool expand_centre();
    bool expand_set();
    bool expand_variations();
    double radius_of_variations() const;
    bool choose_length();
    void shorten_for_width();
    const proved_step* stopped(march_end why);
    const proved_step* stopped_by_bounds();
    void require_integrator() const;
    bool begins_collocation(const proved_step& step, const ball& rest);
    void step_of_collocation();
    bool loses_an_unknown(const std::vector<ball>& hull) const;
    void end_collocation();
    void use_step(int direction);
    step_report report_of_step(int direction) const;
    void count_steps(long count);

    polynomial_form lifted_;
    tape tape_;
    tape varied_tape_;
    long bits_;
    long error_bits_;
    proof_route route_;
    int set_order_;
    ball time_, origin_;
    state_set set_;
    unknown_scales scales_;
    long set_bits_;  ///< of the error map: error_bits_ plus the loss by its largest terms
    std::unique_ptr<proved_step> now_;
    std::optional<ball_matrix> derivative_;
    long steps_ = 0;
    march_watch watch_;
    march_end end_ = march_end::none;
    std::vector<ball> before_;
    std::optional<explicit_system> singular_;  ///< if it begins after a singular initial point
    std::unique_ptr<method_choice> collocation_;
    std::unique_ptr<root_rule> roots_;  ///< if there are times with roots
    step_observer observer_;
    bool used_ = false;  ///< whether the present step has been used
};

}  // namespace libration::ode
