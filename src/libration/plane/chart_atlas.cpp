#include "libration/plane/chart_atlas.hpp"

#include <cmath>

namespace libration::ode {

namespace {

// The inverse of the size from which chart 0 is used again, relative to that of the change to chart 1.
constexpr double hysteresis_of_charts = 1.6;

}  // namespace

chart_atlas::chart_atlas(const explicit_system& system, double size, std::size_t shown)
    : given_(system),
      regular_(regular_coordinates::of(system)),
      order_(system.unknowns().size() == 1 ? static_cast<std::size_t>(system.unknowns().front().order) : 0),
      size_(size),
      shown_(shown) {
    if (regular_ && given_.carried() != order_) {
        regular_.reset();  // functions of several values in the coefficients have no values in the other chart
    }
    if (regular_) {
        beyond_.emplace(regular_->system());
    }
}

std::size_t chart_atlas::chosen(std::size_t now, const std::vector<complex_ball>& state) const {
    if (!has_poles()) {
        return 0;
    }
    const double first = std::abs(rounded_midpoint(state[0]));
    return now == 0 ? (first > size_ ? 1 : 0) : (first * size_ > hysteresis_of_charts ? 0 : 1);
}

std::vector<complex_ball> chart_atlas::converted(std::size_t from, std::size_t to, const complex_ball& offset,
                                                 const std::vector<complex_ball>& state) const {
    if (from == to) {
        return state;
    }
    if (to == 1) {
        return regular_->from(time(offset), state);
    }
    std::vector<complex_ball> result{complex_ball(1) / state[0]};
    if (order_ == 2) {
        result.push_back(state[1] / (state[0] * state[0]));
    }
    return result;
}

complex_ball chart_atlas::time(const complex_ball& offset) const {
    return {constant_value<ball>::of(given_.origin()) + offset.re, offset.im};
}

}  // namespace libration::ode
