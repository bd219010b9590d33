// A step of theorem K.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "decay_coordinates.hpp"
#include "libration/integration/collocation/collocation_integrator.hpp"
#include "libration/integration/step.hpp"

namespace libration::ode {

/// The given unknowns at a time, from all those that are followed: the first ones, or functions of them in coordinates.
std::vector<ball> given_unknowns(std::vector<ball> all, std::size_t given, const decay_coordinates* in,
                                 const ball& time);

class collocation_step : public step {
public:
    struct parts {
        std::shared_ptr<const step_tube> tube;
        std::shared_ptr<const decay_coordinates> coordinates;  ///< null in the unknowns themselves
        std::size_t given = 0, count = 0;                      ///< of the given unknowns, and of those of the form
        /// At the beginning of the period, if the form with its variations from there on is followed.
        std::optional<ball_matrix> derivative;
        tube_set all_at_end;                  ///< of the unknowns that are followed
        std::optional<state_set> set_at_end;  ///< of the given ones; std::nullopt if only a box of them is known
        std::shared_ptr<const carried> period;
    };

    collocation_step(const flow_state& from, parts of, const origin& made)
        : step({from.time, from.set, from.derivative, {}}, of.tube->length(), made), of_(std::move(of)) {}

    std::vector<ball> values(const ball& distance) const override;
    std::vector<ball> slopes(const ball& distance) const override;
    ball_matrix derivative(const ball& distance) const override;
    flow_state end() const override;

private:
    ball_matrix derivative_in(const std::vector<ball>& state) const;

    parts of_;
};

}  // namespace libration::ode
