#include "libration/integration/taylor/proved_step.hpp"

#include "../../expansion/set_values.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

proved_step::proved_step(const tape& centre, const tape& varied, long bits, int set_order, const proof_route& route)
    : bits_(bits),
      of_centre_(centre, taylor_order(static_cast<int>(bits)) + 2 + route.more_terms, route.product),
      of_set_(varied, set_order, route.product),
      log_of_radius_(no_radius) {}

std::vector<ball> proved_step::flow_of_centre(const ball& distance) const {
    const auto state = of_centre_.at(distance);
    std::vector<ball> values;
    for (std::size_t i = 0; i < errors_.size(); ++i) {
        values.push_back(widened(state[i][0], tail_->at(i, magnitude(distance))));
    }
    return values;
}

ball_matrix proved_step::derivative_of_flow(const ball& distance) const {
    const precision_scope few(decimal_digits(set_bits_));
    const auto state = of_set_.at(distance);
    const std::size_t given = errors_.size();
    const std::size_t count = state.size() / (given + 1);
    ball_matrix map(given);
    for (std::size_t i = 0; i < given; ++i) {
        for (std::size_t j = 0; j < given; ++j) {
            const std::size_t index = count * (j + 1) + i;
            map[i].push_back(widened(state[index][0], set_tail_->at(index, magnitude(distance))));
        }
    }
    return map;
}

std::vector<ball> proved_step::values_at(const ball& distance) const {
    auto values = flow_of_centre(distance);
    const auto map = derivative_of_flow(distance);
    const precision_scope few(decimal_digits(set_bits_));
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = widened(values[i], errors_.reach(map, i));
    }
    return values;
}

}  // namespace libration::ode
