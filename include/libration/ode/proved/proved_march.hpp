// The solution of any system at any time, enclosed: many digits for the centre, few for the error.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "libration/ode/lifted_system.hpp"
#include "libration/ode/proved/frame.hpp"
#include "libration/ode/proved/proof_route.hpp"
#include "libration/ode/proved/singular_step.hpp"
#include "libration/ode/proved/step_length.hpp"
#include "libration/ode/proved/tail_bound.hpp"
#include "libration/ode/rigorous/collocation_integrator.hpp"

namespace libration::ode {

/// Told now and then, between two steps, up to which time a run has come, and with how many bits it began. What it
/// throws ends the run, which may go on afterwards.
using march_watch = std::function<void(const ball& reached, long bits)>;

/// Why a proof goes no further.
enum class march_end {
    none,
    precision,  ///< the enclosure is too wide: with more bits it goes on
    steps       ///< the steps become too small: a singularity of the solution is near, in real time or beside it
};

/// Theorem V. The solution stays in c + Q [-r, r], c exact, from step to step: Phi, the flow over a step h, takes c
/// into c' + [-tau, tau] by theorem T from the exact point (tau holds the tail, the radii of its balls, the rounding of
/// c'), and A, from theorem T for the system with its variations over the whole set, holds the derivative of Phi at
/// every point of the set, which is convex; so Phi of the set lies in c' + A Q [-r, r] + [-tau, tau]
/// (error_frame::moved). Proof: Phi(z) - Phi(c) = (int_0^1 DPhi(c + x (z - c)) dx)(z - c).
///
/// Where at() is stiff, that is where the solution is smooth over many of the steps, the integrator of theorem K
/// (rigorous/collocation_integrator.hpp) takes over from the same set, and gives it back when no mode is fast any more.
/// That is done for equations that are polynomial as they are, without a derivative of the flow.
///
/// The unknowns are those of the given system with their lower derivatives; what theorem T needs besides
/// (lifted_system) is computed from them in each step. The precision falls as the set grows: what is below it is noise.
///
/// Each unknown has its digits relative to itself: the set is kept in scales 2^k near the sizes of the unknowns on the
/// step (error_frame::settled), and tails are bounded relative to the size of their unknown or to the set's own width
/// (step_length.hpp). An unknown that is 0 at all times remains an exact 0: centre, tail and row of A are exact zeros
/// then. One that is not distinguished from 0 for another reason has no effect on the steps; one that once was, and is
/// no more, ends the proof for want of precision.
class proved_march {
public:
    static constexpr long most_steps = 10'000'000;
    static constexpr long usual_error_bits = 64;

    /// From the start, in so many bits; the maps of errors in error_bits, which is what derivative_at() is worth. From
    /// a singular start after a step of theorem S (singular_step.hpp), whose errors it throws.
    proved_march(const explicit_system& system, long bits, march_watch watch = {}, long error_bits = usual_error_bits,
                 const proof_route& route = {});
    /// The same from every start of a box of balls, the given unknowns at the point of the system.
    proved_march(const explicit_system& system, const std::vector<ball>& start, long bits,
                 long error_bits = usual_error_bits, march_watch watch = {}, const proof_route& route = {});
    ~proved_march();

    /// The given unknowns at a time, each solution through the start enclosed; times in one direction, away from the
    /// start. Nothing where the proof ends before, for the reason end().
    std::optional<std::vector<ball>> at(const number& time);
    /// The same at every time of a ball.
    std::optional<std::vector<ball>> at(const ball& target);

    /// Before the first step: errors weigh absolutely, as for a solution that tends to a constant while its derivative
    /// vanishes much faster (unknown_scales::weigh_by_errors).
    void weigh_by_errors() { scales_.weigh_by_errors(); }
    /// From here on the derivative of the flow is kept: dy(t)/dy(start) for every start of the set; from a singular
    /// start for that itself (singular_step.hpp, derivative_beyond_start, whose errors it throws), before the first
    /// step alone.
    void keep_derivative();
    /// What the unknowns are before the first step: nothing, or after a singular start enclosures of all their values
    /// up to where the march begins.
    const std::vector<ball>& before() const { return before_; }
    /// That at a time where at() has just been.
    ball_matrix derivative_at(const ball& time) const;

    /// Makes the step from reached() ready: series and bounds, once. False where the proof ends here.
    bool prepare();
    /// The longest distance that the step holds for; after prepare().
    const magnitude& length() const;
    /// The given unknowns at every distance of a ball, |distance| <= length(), of either sign; after prepare().
    std::vector<ball> values_at(const ball& distance) const;
    /// The derivative of the flow over that distance by the state at reached(), of every point of the set.
    ball_matrix derivative_of_flow(const ball& distance) const;
    /// Takes the whole step, forwards for direction >= 0; after prepare().
    void step(int direction);

    march_end end() const { return end_; }
    /// Up to here the solution is proved to exist.
    const ball& reached() const { return time_; }
    /// A step of collocation counts as 32.
    long steps() const { return steps_; }
    /// Those that it began with.
    long bits() const { return bits_; }
    /// A bound of the set, |x_i - c_i|.
    magnitude width() const;
    /// How many of the steps were of collocation.
    long collocation_steps() const { return collocation_steps_; }

private:
    struct expansions;
    proved_march(singular_step begin, long bits, march_watch watch, long error_bits, const proof_route& route);

    void make_expansions();
    bool expand_centre();
    bool expand_set();
    bool expand_variations();
    double radius_of_variations() const;
    bool choose_length();
    bool stopped(march_end why);
    bool stopped_by_bounds();
    std::vector<ball> flow_of_centre(const ball& distance) const;
    std::vector<ball> whole_set() const;
    bool may_use_collocation(const ball& rest) const;
    bool begins_collocation(const ball& rest);
    void end_collocation();
    void step_of_collocation();
    void count_steps(long count);

    lifted_system lifted_;
    tape tape_;
    tape varied_tape_;
    long bits_;
    long error_bits_;
    proof_route route_;
    int set_order_;
    ball time_, origin_;
    std::vector<ball> centre_;
    error_frame errors_;
    unknown_scales scales_;
    long set_bits_;  ///< of the map of errors: error_bits_, and what its largest terms lose
    std::unique_ptr<expansions> now_;
    std::optional<ball_matrix> derivative_;
    long steps_ = 0;
    march_watch watch_;
    march_end end_ = march_end::none;
    std::vector<ball> before_;
    std::optional<explicit_system> singular_;  ///< where it begins behind a singular start
    std::unique_ptr<collocation_integrator> collocation_;
    bool in_collocation_ = false;
    long collocation_steps_ = 0;
    long steps_of_phase_ = 0;  ///< of collocation, since it took over
    magnitude length_to_pay_;
    long next_question_, questions_apart_;  ///< after how many steps it is asked whether the equations are stiff
};

}  // namespace libration::ode
