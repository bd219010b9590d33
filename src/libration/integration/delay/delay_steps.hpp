// The steps of a solution with delays, along which events are searched.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "delay_march.hpp"
#include "libration/integration/enclosed_step.hpp"

namespace libration::ode {

// The values and slopes on a step by theorem M. A step ends at a time that is a ball; at distances beyond its lower end they
// are enclosed at all times from there on, so that the true end is among them.
class enclosed_delay_step : public enclosed_step {
public:
    explicit enclosed_delay_step(const delay_step<ball>& of)
        : of_(&of), least_length_(lower_bound(of.length)), length_(upper_bound(of.length)) {
        for (const auto& each : of.series) {
            auto& slope = slopes_.emplace_back();
            for (std::size_t n = 1; n < each.size(); ++n) {
                slope.push_back(each[n] * static_cast<long>(n));
            }
        }
    }

    ball length_of_step() const override { return length_; }
    std::vector<ball> values_at(const ball& distance) const override {
        return enclosed(of_->series, of_->error, distance);
    }
    std::vector<ball> slopes_at(const ball& distance) const override {
        return enclosed(slopes_, of_->slope_error, distance);
    }

private:
    std::vector<ball> enclosed(const std::vector<std::vector<ball>>& series, const std::vector<magnitude>& error,
                               const ball& distance) const {
        const bool at_end = exactly_less(least_length_, upper_bound(distance));
        const ball at = at_end ? hull(distance, least_length_) : distance;
        std::vector<ball> result;
        for (std::size_t k = 0; k < series.size(); ++k) {
            result.push_back(widened(value_of(series[k], at), error[k]));
        }
        return result;
    }

    const delay_step<ball>* of_;
    std::vector<std::vector<ball>> slopes_;
    ball least_length_, length_;
};

// Forwards.
class delay_steps : public enclosed_steps {
public:
    delay_steps(const delay_system& system, long bits)
        : march_(system, bits), reached_(constant_value<ball>::of(system.point())) {}

    const enclosed_step* prepare_towards(const ball& /*rest*/) override {
        if (!step_) {
            if (const auto* const next = march_.next_step()) {
                step_.emplace(*next);
                reached_ = march_.beginning_of(*next);
            }
        }
        return step_ ? &*step_ : nullptr;
    }
    void take_prepared(int /*direction*/) override {
        step_.reset();
        reached_ = march_.reached();
    }

    march_end end() const override { return march_.end(); }
    const ball& reached() const override { return reached_; }
    // Those that have been taken.
    long steps() const override { return march_.steps() - (step_ ? 1 : 0); }
    long bits() const override { return march_.bits(); }

private:
    delay_march<ball> march_;
    std::optional<enclosed_delay_step> step_;
    ball reached_;
};

}  // namespace libration::ode
