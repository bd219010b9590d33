#include "box_choice.hpp"

#include <algorithm>
#include <cmath>

#include "libration/digits/precision_loop.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

namespace {

constexpr long steps_before_choice = 4;
constexpr double clear_difference = 2;
// What is predicted reaches so many times the way so far: a fast decay at the beginning does not last.
constexpr double most_times_the_way = 16;
// Operations of the reorthogonalisation of theorem V, in units of a product of 64 bits, per unknown cubed.
constexpr double cost_of_orthogonalisation = 6;

// The product of two series in so many bits: order^2/2 products of numbers, in units of one of 64 bits.
double cost_of_series_product(double bits) {
    const double order = taylor_order(static_cast<int>(bits));
    return order * order / 2 * (1 + std::pow(bits / 512, 1.6));
}

}  // namespace

void box_choice::add(double growth, double distance, double accuracy) {
    accuracy_ = accuracy;
    if (++steps_ == 1) {
        return;  // the scales of the first one are those of unknowns that may be 0 at the initial point
    }
    growth_ += std::max(growth, 0.0);
    way_ += std::abs(distance);
}

bool box_choice::prefers_columns(double rest) const {
    if (steps_ < steps_before_choice || unknowns_ > most_unknowns_with_columns) {
        return false;
    }
    constexpr double least = run_bits::usual_error_bits;
    const double left = std::isfinite(rest) ? std::min(std::abs(rest), most_times_the_way * way_) : way_;
    const double lost = growth_ / way_ * left;
    const double first = std::max(accuracy_, least + lost);
    const double last = std::max(first - lost, least);
    const auto products = static_cast<double>(products_);
    const auto size = static_cast<double>(unknowns_);
    const double by_box = products *
                          (cost_of_series_product(first) + cost_of_series_product((first + last) / 2) * 4 +
                           cost_of_series_product(last)) /
                          6;
    const double by_columns =
        products * (cost_of_series_product(std::max(accuracy_, least)) + 2 * size * cost_of_series_product(least)) +
        cost_of_orthogonalisation * size * size * size;
    return by_box > clear_difference * by_columns;
}

}  // namespace libration::ode
