// The steps of a solution with delays, along which events are searched.
#pragma once

#include <utility>
#include <vector>

#include "delay_march.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/integration.hpp"

namespace libration::ode {

/// The values and slopes on a step by theorem M. A step ends at a time that is a ball; at distances beyond its lower end
/// they are enclosed at all times from there on, so that the true end is among them.
class enclosed_delay_step : public step {
public:
    /// From and to these times.
    enclosed_delay_step(const delay_step<ball>& of, ball begins, ball ends, long bits)
        : step({std::move(begins), {}, {}, {}}, upper_bound(of.length),
               {bits, static_cast<int>(of.series.front().size()) - 1}),
          of_(of),
          least_length_(lower_bound(of.length)),
          ends_(std::move(ends)) {
        for (const auto& each : of.series) {
            auto& slope = slopes_.emplace_back();
            for (std::size_t n = 1; n < each.size(); ++n) {
                slope.push_back(each[n] * static_cast<long>(n));
            }
        }
    }

    std::vector<ball> values(const ball& distance) const override { return enclosed(of_.series, of_.error, distance); }
    std::vector<ball> slopes(const ball& distance) const override {
        return enclosed(slopes_, of_.slope_error, distance);
    }
    ball_matrix derivative(const ball& /*distance*/) const override { return {}; }
    flow_state end() const override { return {ends_, {}, {}, {}}; }
    ball end_time() const override { return ends_; }

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

    delay_step<ball> of_;
    std::vector<std::vector<ball>> slopes_;
    ball least_length_, ends_;
};

/// Forwards from the initial point. It keeps the steps that it made, which the delayed values read.
class delay_rule : public step_rule {
public:
    delay_rule(const delay_system& system, long bits) : march_(system, bits) {}

    void begin(const flow_state& /*start*/) override {}
    next_step next(const flow_state& /*from*/, const ball& /*rest*/) override {
        const auto* const made = march_.next_step();
        if (made == nullptr) {
            return {{}, march_.end()};
        }
        return {
            std::make_shared<enclosed_delay_step>(*made, march_.beginning_of(*made), march_.reached(), march_.bits()),
            stop::none};
    }

private:
    delay_march<ball> march_;
};

}  // namespace libration::ode
