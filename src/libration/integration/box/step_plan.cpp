#include "step_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../expansion/set_values.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// Bits of the coefficients more than their contributions need.
constexpr double bits_of_guard = 32;
// log2 of R over the radius of theorem T, and of its bound there over the size of the unknown.
constexpr double below_radius = 0.15;
constexpr double bits_of_bound = 16;
constexpr double least_bits_per_term = 1.2;
// The length of a step is rounded.
constexpr double rounding_of_length = 1 + 1. / 4096;
constexpr int most_equal_steps = 64;

// The cost of a series of order N is about N^p: squared for few bits, less with products in blocks.
double exponent_of_cost(double bits) { return std::clamp(2.3 - bits / 2048, 1.5, 2.0); }

int longest_order(long bits) { return 3 * taylor_order(static_cast<int>(bits)) / 2; }

double log_of_size(long double a) {
    return a == 0 ? -std::numeric_limits<double>::infinity() : static_cast<double>(std::ilogb(a) + 1);
}

}  // namespace

step_planner::step_planner(const tape& of, long bits) : unknowns_(of.orders().size()), bits_(bits) {
    try {
        series_.emplace(of, longest_order(bits));
    } catch (const error&) {
        series_.reset();  // a constant that long double does not represent
    }
}

std::optional<planned_step> step_planner::plan(const ball& time, const std::vector<ball>& values, double way) {
    if (!series_) {
        return std::nullopt;
    }
    std::vector<long double> start;
    start.reserve(values.size());
    for (const ball& each : values) {
        start.push_back(midpoint_of(each).convert_to<long double>());
    }
    try {
        series_->about(midpoint_of(time).convert_to<long double>(), as_state(start));
    } catch (const error&) {
        return std::nullopt;  // a function that long double does not have
    }
    double log_of_radius = no_radius;
    for (std::size_t i = 0; i < unknowns_; ++i) {
        const long double* const a = series_->coefficients(static_cast<int>(i));
        if (!std::all_of(a, a + series_->order() + 1, [](long double each) { return std::isfinite(each); })) {
            return std::nullopt;
        }
        log_of_radius = std::min(log_of_radius, estimated_radius(a, series_->order(), [](long double each) {
                                     return each == 0 ? magnitude() : magnitude::of(1, std::ilogb(each) + 1);
                                 }));
    }
    if (log_of_radius == no_radius) {
        return std::nullopt;
    }
    const double length = planned_length(way, log_of_radius);
    const int order = order_for(length, log_of_radius);
    return planned_step{length, order, digits_for(length, order)};
}

int step_planner::order_for(double log_of_length, double log_of_radius) const {
    const double bits_per_term = log_of_radius - below_radius - log_of_length;
    return bits_per_term < least_bits_per_term
               ? std::numeric_limits<int>::max()
               : static_cast<int>((static_cast<double>(bits_) + bits_of_bound) / bits_per_term) + 3;
}

double step_planner::planned_length(double way, double log_of_radius) const {
    const double exponent = exponent_of_cost(static_cast<double>(bits_));
    double best = log_of_radius - below_radius - exponent / std::log(2.);
    double least = std::numeric_limits<double>::infinity();
    if (!(way > 0 && way < most_equal_steps * std::exp2(best))) {
        return best;
    }
    for (int steps = 1; steps <= most_equal_steps + 1; ++steps) {
        const double length = std::log2(way / steps * rounding_of_length);
        const int order = order_for(length, log_of_radius);
        const double cost = steps * std::pow(order, exponent);
        if (order <= series_->order() && cost < least) {
            least = cost;
            best = length;
        }
    }
    return best;
}

std::vector<long> step_planner::digits_for(double log_of_length, int order) const {
    std::vector<double> bits(static_cast<std::size_t>(order), -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < unknowns_; ++i) {
        const long double* const a = series_->coefficients(static_cast<int>(i));
        double largest = -std::numeric_limits<double>::infinity();
        for (int n = 0; n <= order; ++n) {
            largest = std::max(largest, log_of_size(a[n]) + n * log_of_length);
        }
        for (int n = 0; n < order && std::isfinite(largest); ++n) {
            double& most = bits[static_cast<std::size_t>(n)];
            most = std::max(most, log_of_size(a[n]) + n * log_of_length - largest);
        }
    }
    std::vector<long> digits(bits.size());
    double most = -static_cast<double>(bits_);
    for (std::size_t n = bits.size(); n-- > 0;) {
        most = std::max(most, bits[n]);
        digits[n] = decimal_digits(static_cast<long>(std::ceil(static_cast<double>(bits_) + most + bits_of_guard)));
    }
    return digits;
}

}  // namespace libration::ode
