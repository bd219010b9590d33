#include "series_step.hpp"

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

std::vector<ball> taylor_series::flow_of_centre(const ball& distance) const {
    const magnitude away(distance);
    std::vector<ball> values;
    for (std::size_t i = 0; i < centre.size(); ++i) {
        values.push_back(widened(series::evaluate_value(centre[i], distance), tail.at(i, away)));
    }
    return values;
}

ball_matrix taylor_series::derivative_of_flow(const ball& distance) const {
    const precision_scope few(decimal_digits(set_bits));
    const magnitude away(distance);
    ball_matrix map(centre.size());
    for (std::size_t i = 0; i < map.size(); ++i) {
        for (std::size_t j = 0; j < map.size(); ++j) {
            map[i].push_back(
                widened(series::evaluate_value(variations[i][j], distance), set_tail.at(places.of(i, j), away)));
        }
    }
    return map;
}

const std::vector<magnitude>& taylor_series::reaches() const {
    std::call_once(has_reaches_, [this] {
        const auto map = derivative_of_flow(widened(ball(0), length));
        for (std::size_t i = 0; i < map.size(); ++i) {
            reaches_.push_back(errors.reach(map, i));
        }
    });
    return reaches_;
}

// Where the values at the distances of a ball differ by far more than the errors, one bound for the whole step suffices.
std::vector<ball> taylor_series::values(const ball& distance) const {
    constexpr long bits_above_errors = 16;
    auto values = flow_of_centre(distance);
    bool wide = !is_exact(distance) && magnitude(distance) <= length;
    for (std::size_t i = 0; wide && i < values.size(); ++i) {
        wide = reaches()[i].shifted(bits_above_errors) <= magnitude::radius_of(values[i]);
    }
    if (wide) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = widened(values[i], reaches()[i]);
        }
        return values;
    }
    const auto map = derivative_of_flow(distance);
    const precision_scope few(decimal_digits(set_bits));
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = widened(values[i], errors.reach(map, i));
    }
    return values;
}

ball_matrix series_step::derivative(const ball& distance) const {
    const precision_scope few(decimal_digits(series_->set_bits));
    return product(series_->derivative_of_flow(distance), *from().derivative);
}

flow_state series_step::end() const {
    flow_state result{end_time(), {}, {}, {}};
    const precision_scope scope(decimal_digits(series_->bits));
    const auto image = series_->flow_of_centre(end_);
    std::vector<magnitude> added;
    for (const ball& each : image) {
        result.set.centre.push_back(exact_midpoint(each));
        added.emplace_back(each - result.set.centre.back());
    }
    const precision_scope few(decimal_digits(series_->set_bits));
    const ball_matrix map = series_->derivative_of_flow(end_);
    if (from().derivative) {
        result.derivative = product(map, *from().derivative);
    }
    result.set.errors = series_->errors.image(map, added);
    return result;
}

ball series_step::end_time() const { return exact_sum(from().time, end_); }

}  // namespace libration::ode
