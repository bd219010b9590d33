// Enclosures of the solution of any system at times one after the other.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/kept_integrations.hpp"

namespace libration::ode {

/// The steps of an integration by rule_for(), read at times.
class proved_march {
public:
    static constexpr long most_steps = 10'000'000;
    static constexpr long usual_error_bits = run_bits::usual_error_bits;

    /// From the initial point, with so many bits; the error maps have error_bits, the precision of derivative_at().
    /// Throws error like rule_for().
    proved_march(const explicit_system& system, long bits, march_watch watch = {}, long error_bits = usual_error_bits,
                 const proof_route& route = {});
    /// The same from all initial values in a box of balls, the given unknowns at the point of the system.
    proved_march(const explicit_system& system, const std::vector<ball>& start, long bits,
                 long error_bits = usual_error_bits, march_watch watch = {}, const proof_route& route = {});

    /// The same along kept steps, of which at least so many bits are needed, in the direction of time (< 0: backwards). The
    /// system is that of the part.
    proved_march(const kept_part& kept, const explicit_system& system, long bits, int direction, march_watch watch = {},
                 const proof_route& route = {});
    ~proved_march();
    proved_march(const proved_march&) = delete;
    proved_march& operator=(const proved_march&) = delete;

    /// The methods and steps are chosen towards this time, in the direction of those that are read; without it, towards
    /// each of them.
    void aim(const number& farthest);
    /// The given unknowns at a time, enclosing each solution through the initial set; times in one direction, away from
    /// the initial point. Returns std::nullopt if the proof ends before, for the reason end().
    std::optional<std::vector<ball>> at(const number& time);
    /// The same at every time of a ball.
    std::optional<std::vector<ball>> at(const ball& target);

    /// To be called before the first step: the observer is called for each step.
    void observe(step_observer observer);
    /// To be called before the first step: the derivative of the flow is kept, dy(t)/dy(t0) for all initial values of
    /// the set; from a singular initial point with respect to its values themselves (singular_step.hpp,
    /// derivative_beyond_start, whose errors at() throws then).
    void keep_derivative();
    /// The derivative at a time for which at() has just been called.
    ball_matrix derivative_at(const ball& time);

    stop end() const { return end_; }
    /// The given unknowns at reached() after at() returned std::nullopt; std::nullopt where no step was made.
    std::optional<std::vector<ball>> at_end();
    /// The beginning of the last step that was read, or the time up to which the solution is proved to exist.
    const ball& reached() const { return reached_; }
    /// The steps up to there. A step of collocation counts as several.
    long steps() const { return steps_; }
    /// Whether the last step that was made is one of theorem G, whose errors grow steadily.
    bool ends_by_comparison() const {
        return along_ && along_->last_step() != nullptr &&
               along_->last_step()->made().method == step_method::comparison;
    }
    /// The initial number of bits.
    long bits() const { return bits_.bits; }
    /// Where collocation was used.
    collocation_use collocation() const { return along_ ? along_->collocation() : collocation_use(); }

private:
    proved_march(const explicit_system& system, flow_state start, const run_bits& bits, march_watch watch,
                 const proof_route& route);

    integration& along();
    std::optional<step_at> place_of(const ball& target);

    run_bits bits_;
    flow_state start_;
    std::shared_ptr<step_rule> rule_;
    march_watch watch_;
    step_observer observer_;
    std::optional<ball> farthest_;
    kept_integrations* kept_ = nullptr;
    std::shared_ptr<integration> along_;
    std::size_t now_ = 0;  // the step that is read
    ball reached_;
    long steps_ = 0;
    stop end_ = stop::none;
};

}  // namespace libration::ode
