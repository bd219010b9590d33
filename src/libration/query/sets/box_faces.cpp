#include "box_faces.hpp"

#include "part_run.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_faces = 256;

}  // namespace

void box_faces::narrow(set_image& known, std::size_t image) {
    for (std::size_t k = 0; k < known.values.size(); ++k) {
        closed_interval& value = known.values[k];
        if (const auto* const lowest = value_on(known.derivatives[k], -1, image, k);
            lowest != nullptr && exactly_less(value.lower, lowest->lower)) {
            value.lower = lowest->lower;
        }
        if (const auto* const highest = value_on(known.derivatives[k], 1, image, k);
            highest != nullptr && exactly_less(highest->upper, value.upper)) {
            value.upper = highest->upper;
        }
    }
}

// The enclosure of a value on the face that contains its lowest (side -1) or highest (1) value; null if it is monotone in
// no number, or that face is not enclosed.
const closed_interval* box_faces::value_on(const std::vector<ball>& derivatives, int side, std::size_t image,
                                           std::size_t value) {
    std::vector<int> ends;
    bool any = false;
    for (std::size_t j = 0; j < whole_.size(); ++j) {
        const int direction = direction_of(derivatives[j]);
        ends.push_back(!has_width(whole_[j]) || direction == 2 ? -1 : direction * side);
        any = any || (has_width(whole_[j]) && ends.back() != 0);
    }
    if (!any || (runs_.size() == most_faces && !runs_.contains(ends))) {
        return nullptr;
    }
    const auto& enclosed = run_on(ends).images[image];
    return enclosed ? &enclosed->values[value] : nullptr;
}

const set_run_result& box_faces::run_on(const std::vector<int>& ends) {
    const auto known = runs_.find(ends);
    if (known != runs_.end()) {
        return known->second;
    }
    number_box face = whole_;
    for (std::size_t j = 0; j < face.size(); ++j) {
        if (ends[j] != 0) {
            const ball end = ends[j] < 0 ? face[j].lower : face[j].upper;
            face[j] = {end, end};
        }
    }
    const auto& made = runs_.emplace(ends, best_run(question_, face, false)).first->second;
    steps_ += made.steps;
    return made;
}

}  // namespace libration::ode
