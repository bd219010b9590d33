#include "collocation_step.hpp"

namespace libration::ode {

std::vector<ball> given_unknowns(std::vector<ball> all, std::size_t given, const decay_coordinates* in,
                                 const ball& time) {
    all.resize(given);
    return in != nullptr ? in->from_coordinates().at(time, all) : all;
}

std::vector<ball> collocation_step::values(const ball& distance) const {
    return given_unknowns(of_.tube->values_at(distance), of_.given, of_.coordinates.get(), from().time + distance);
}

// In coordinates c, y = g(c) has y' = g_c c'.
std::vector<ball> collocation_step::slopes(const ball& distance) const {
    std::vector<ball> slopes = of_.tube->slopes_at(distance);
    slopes.resize(of_.given);
    if (!of_.coordinates) {
        return slopes;
    }
    std::vector<ball> state = of_.tube->values_at(distance);
    state.resize(of_.given);
    const ball_matrix by = of_.coordinates->from_coordinates().derivative(from().time + distance, state);
    std::vector<ball> result;
    for (const auto& row : by) {
        ball& sum = result.emplace_back(0);
        for (std::size_t k = 0; k < row.size(); ++k) {
            sum += row[k] * slopes[k];
        }
    }
    return result;
}

ball_matrix collocation_step::derivative_in(const std::vector<ball>& state) const {
    ball_matrix result(of_.given);
    for (std::size_t i = 0; i < of_.given; ++i) {
        for (std::size_t j = 0; j < of_.given; ++j) {
            result[i].push_back(state[of_.count * (j + 1) + i]);
        }
    }
    return product(result, *of_.derivative);
}

ball_matrix collocation_step::derivative(const ball& distance) const {
    return derivative_in(of_.tube->values_at(distance));
}

flow_state collocation_step::end() const {
    flow_state result{end_time(), {}, {}, of_.period};
    const std::vector<ball> all = of_.all_at_end.hull();
    result.set = of_.set_at_end ? *of_.set_at_end
                                : box_around(given_unknowns(all, of_.given, of_.coordinates.get(), result.time),
                                             static_cast<long>(ball::working_bits()));
    if (of_.derivative) {
        result.derivative = derivative_in(all);
    }
    return result;
}

}  // namespace libration::ode
