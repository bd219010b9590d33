#include "states_around.hpp"

#include <algorithm>

#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int most_picard_boxes = 20;

std::vector<ball> shifted(const std::vector<ball>& states, const ball& by, const std::vector<ball>& slopes) {
    std::vector<ball> all;
    for (std::size_t i = 0; i < states.size(); ++i) {
        all.push_back(states[i] + by * slopes[i]);
    }
    return all;
}

}  // namespace

std::optional<std::vector<ball>> states_around(const first_order_form& form, const std::vector<ball>& states,
                                               const ball& times) {
    const ball steps = widened(ball(0), magnitude::radius_of(times) * magnitude(2U));
    std::vector<ball> box = states;
    for (int k = 0; k < most_picard_boxes; ++k) {
        const auto slopes = form.slopes_at(box, times);
        if (!std::ranges::all_of(slopes, [](const ball& x) { return is_finite(x); })) {
            return std::nullopt;
        }
        const auto image = shifted(states, steps, slopes);
        bool inside = true;
        for (std::size_t i = 0; i < box.size(); ++i) {
            inside = inside && contains(box[i], image[i]);
        }
        if (inside) {
            return box;
        }
        box = shifted(states, steps * 2, slopes);
    }
    return std::nullopt;
}

std::vector<ball> states_moved(const first_order_form& form, const std::vector<ball>& states, const ball& times,
                               const std::vector<ball>& around, const ball& to) {
    return shifted(states, to - times, form.slopes_at(around, times));
}

}  // namespace libration::ode
