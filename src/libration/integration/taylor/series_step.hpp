// A step of theorem V: the flow from one set, by Taylor series with proved tails.
#pragma once

#include <memory>
#include <utility>

#include "libration/integration/step.hpp"
#include "taylor_series.hpp"

namespace libration::ode {

/// Both directions are within the bounds of the series.
class series_step : public step {
public:
    series_step(flow_state from, std::shared_ptr<const taylor_series> series, const ball& length)
        : series_step(std::move(from), std::move(series), length, length) {}
    /// With the end at a distance that is not exact, and a length that is not shorter.
    series_step(flow_state from, std::shared_ptr<const taylor_series> series, ball length, ball end)
        : step(std::move(from), std::move(length), {series->bits, series->centre.front().order()}),
          series_(std::move(series)),
          end_(std::move(end)) {}

    const std::shared_ptr<const taylor_series>& series() const { return series_; }

    /// On both sides of the beginning.
    bool covers(const ball& distance) const override { return reaches(distance); }
    std::vector<ball> values(const ball& distance) const override { return series_->values(distance); }
    ball_matrix derivative(const ball& distance) const override;
    flow_state end() const override;
    ball end_time() const override;

private:
    std::shared_ptr<const taylor_series> series_;
    ball end_;
};

}  // namespace libration::ode
