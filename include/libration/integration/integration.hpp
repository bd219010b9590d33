// Integration: one loop over a rule, whose steps are kept and read by number.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <utility>

#include "libration/integration/rule.hpp"

namespace libration::ode {

/// Progress callback, called occasionally between two steps with the time reached by a run and the bits it began with.
/// An exception that it throws ends the run, which can be continued afterwards.
using march_watch = std::function<void(const ball& reached, long bits)>;

/// Steps one after the other, each from the end of the one before.
class step_sequence {
public:
    step_sequence() = default;
    step_sequence(const step_sequence&) = delete;
    step_sequence& operator=(const step_sequence&) = delete;
    virtual ~step_sequence() = default;

    /// Step k, made on demand and kept; nullptr for the reason why(), or if it has been forgotten.
    virtual const step* operator[](std::size_t k) = 0;
    virtual stop why() const = 0;
    /// The time up to which the solution is proved to exist: the end of the last step that was made.
    virtual const ball& reached() const = 0;
    /// No earlier step will be read.
    virtual void forget_before(std::size_t k) = 0;
};

class integration : public step_sequence {
public:
    /// Towards times up to `farthest`, infinite without a last one, by a rule with so many bits. The progress
    /// callback is called between steps, the observer for each step.
    integration(flow_state start, std::shared_ptr<step_rule> rule, ball farthest, long bits, march_watch watch = {},
                step_observer observer = {});

    const step* operator[](std::size_t k) override;
    stop why() const override { return why_; }
    const ball& reached() const override { return reached_; }
    void forget_before(std::size_t k) override;

    /// The number of the first step that has not been forgotten.
    std::size_t first() const { return first_; }
    /// Another farthest time, in the same direction, for the steps that have not been made yet.
    void aim(ball farthest) { farthest_ = std::move(farthest); }
    long bits() const { return bits_; }
    /// The number of steps that have been made.
    std::size_t made() const { return first_ + steps_.size(); }
    /// The last of them; nullptr before the first one.
    const step* last_step() const { return steps_.empty() ? nullptr : steps_.back().get(); }
    const flow_state& start() const { return start_; }
    /// Other callbacks for the steps that have not been made yet.
    void call(march_watch watch, step_observer observer) {
        watch_ = std::move(watch);
        observer_ = std::move(observer);
    }
    /// The state at reached().
    flow_state last() const { return steps_.empty() ? start_ : steps_.back()->end(); }
    /// The cost of the steps that have been made.
    long cost() const { return cost_; }
    /// Where collocation was used, up to the farthest time.
    const collocation_use& collocation() const { return collocation_; }

private:
    void make_next();
    void note(const step& made);

    flow_state start_;
    std::shared_ptr<step_rule> rule_;
    ball farthest_;
    long bits_;
    march_watch watch_;
    step_observer observer_;
    std::deque<std::shared_ptr<const step>> steps_;
    std::size_t first_ = 0;  // the number of the first one
    stop why_ = stop::none;
    ball reached_;
    long cost_ = 0;
    long watched_ = 0;  // the cost at the last call of watch_
    collocation_use collocation_;
    bool in_collocation_ = false;
};

/// The place of a ball of times: in one step, or in two if it contains the time between them.
struct step_at {
    const step* here = nullptr;  ///< in which the target ends
    ball distance;
    const step* before = nullptr;  ///< in which it begins, if that is another one
    ball distance_before = {};
};

/// The steps that contain the times of a ball, searched from step k on, which becomes the one in which it ends;
/// std::nullopt if the proof ends before. Throws precision_exhausted for a ball that begins before both.
std::optional<step_at> steps_about(step_sequence& along, std::size_t& k, const ball& target);

/// The values at every time of the ball for which the steps were found.
std::vector<ball> values_at(const step_at& place);
/// The derivative by the initial state there.
ball_matrix derivative_at(const step_at& place);

/// An infinite distance.
ball infinite_distance(int direction);

}  // namespace libration::ode
