#include "libration/integration/collocation/tube.hpp"

#include <utility>

#include "ball_polynomial.hpp"
#include "libration/expansion/step_pieces.hpp"

namespace libration::ode {

// x of distances.
ball solution_tube::place_of(const ball& distance) const { return distance / on.length * 2L - 1L; }

std::vector<ball> solution_tube::slopes_at(const ball& distance, const std::vector<magnitude>& errors) const {
    const ball x = place_of(distance);
    std::vector<ball> slopes;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const ball by_x = value_over(derivative_of(curve[i]), x);
        slopes.push_back(widened(shifted(by_x, scales[i] + 1) / on.length, errors[i]));
    }
    return slopes;
}

std::vector<ball> solution_tube::values_at(const ball& distance) const {
    const ball part = distance / on.length;
    const ball x = place_of(distance);
    const magnitude to_first(ball(1) - part);
    const magnitude to_last(part);
    std::vector<magnitude> radii;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        radii.push_back(first[b] * to_first + last[b] * to_last);
    }
    const std::size_t n = curve.size();
    std::vector<ball> values;
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<ball> row;
        for (std::size_t j = 0; j < n; ++j) {
            row.push_back(value_over(frame[i * n + j], x));
        }
        const ball scaled = widened(value_over(curve[i], x), reach_of_row(row, blocks, radii));
        values.push_back(shifted(scaled, scales[i]));
    }
    return values;
}

std::vector<ball> end_of(const std::vector<ball_polynomial>& curve, const std::vector<long>& scales) {
    std::vector<ball> result;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        ball value = midpoint_alone(shifted(value_of(curve[i], ball(1)), scales[i]));
        arf_set_round(arb_midref(value.handle()), arb_midref(value.handle()), ball::working_bits(), ARF_RND_NEAR);
        result.push_back(std::move(value));
    }
    return result;
}

tube_set solution_tube::end(long bits, long frame_bits) const {
    const precision_scope scope(decimal_digits(bits));
    const std::size_t n = curve.size();
    std::vector<ball> centre = end_of(curve, scales);
    ball_matrix columns(n);
    std::vector<magnitude> rounding;
    for (std::size_t i = 0; i < n; ++i) {
        rounding.emplace_back(shifted(value_of(curve[i], ball(1)), scales[i]) - centre[i]);
        for (std::size_t j = 0; j < n; ++j) {
            ball entry = shifted(value_of(frame[i * n + j], ball(1)), scales[i]);
            arb_set_round(entry.handle(), entry.handle(), frame_bits);
            columns[j].push_back(std::move(entry));
        }
    }
    return {{std::move(centre), lohner_set(std::move(columns), blocks, last, std::move(rounding))}, slow};
}

}  // namespace libration::ode
