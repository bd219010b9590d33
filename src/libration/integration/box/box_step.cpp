#include "box_step.hpp"

#include <algorithm>
#include <stdexcept>

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

std::vector<ball> box_series::flow_of_centre(const ball& distance) const {
    const magnitude away(distance);
    std::vector<ball> values;
    values.reserve(centre.size());
    for (std::size_t i = 0; i < centre.size(); ++i) {
        values.push_back(widened(series::evaluate_value(centre[i], distance), tail.at(i, away)));
    }
    return values;
}

// With the radii of all pieces that may contain a distance; beyond the ends, to which distances are rounded, those of
// the first and of the last piece.
std::vector<ball> box_step::values(const ball& distance) const {
    auto values = series_->flow_of_centre(distance);
    const auto& pieces = series_->pieces;
    const ball size = abs(distance);
    const ball nearest = lower_bound(size);
    const ball farthest = upper_bound(size);
    std::size_t k = 0;
    while (k + 1 < pieces.size() && exactly_less(pieces[k].end, nearest)) {
        ++k;
    }
    for (bool reached = false; k < pieces.size() && !reached; ++k) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = widened(values[i], pieces[k].most[i]);
        }
        reached = !exactly_less(pieces[k].end, farthest);
    }
    return values;
}

ball_matrix box_step::derivative(const ball& /*distance*/) const {
    throw std::logic_error("the derivative of the flow in a step of theorem G");
}

flow_state box_step::end() const {
    flow_state result{end_time(), {}, {}, {}};
    const precision_scope scope(decimal_digits(series_->bits));
    std::vector<magnitude> radii = series_->last;
    const auto image = series_->flow_of_centre(length());
    for (std::size_t i = 0; i < image.size(); ++i) {
        result.set.centre.push_back(exact_midpoint(image[i]));
        radii[i] += magnitude(image[i] - result.set.centre.back());
    }
    result.set.errors = thin_box(std::move(radii));
    return result;
}

lohner_set thin_box(std::vector<magnitude> radii) { return {{}, {}, {}, std::move(radii)}; }

}  // namespace libration::ode
