#include "well_problem.hpp"

#include <algorithm>
#include <cmath>

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

namespace {

constexpr double nearest_sample = 1. / 64;
constexpr double farthest_sample = 1000;
constexpr double factor_of_samples = 1.25;
constexpr double nearest_part = 1e-9;
constexpr int largest_log2_of_size = 100;

// s of x, as an exact number: m is a dyadic fraction, or x = 0.
ball place_of(const well_equation& of, const rational& x) { return of.exponential ? ball(1) : from_rational<ball>(x); }

// The condition of a left end for the reflected well.
well_end reflected_end(well_end end) {
    if (end.point) {
        end.point = -*end.point;
    }
    end.slope = -end.slope;
    return end;
}

// With psi > 0 to the left of the end.
well_end directed(well_end end) {
    if (end.value < 0 || (end.value == 0 && end.slope > 0)) {
        end.value = -end.value;
        end.slope = -end.slope;
    }
    return end;
}

}  // namespace

well_problem::well_problem(const well_equation& of, const well_end& left, const well_end& right, const rational& m)
    : left_(of.reflected(), directed(reflected_end(left)), of.exponential ? ball(1) : place_of(of, -m)),
      right_(of, directed(right), place_of(of, m)) {
    if (left.point || of.exponential) {
        first_ = of.exponential ? (left.point ? 1 : 0) : left.point->convert_to<double>();
    }
    if (right.point) {
        last_ = of.exponential ? 1 : right.point->convert_to<double>();
    }
}

well_problem::bottom_of_well well_problem::bottom() const {
    bottom_of_well result;
    double place = 0;
    const auto seen = [&](double s) {
        const double v = right_.potential_near(s);
        if (s >= first_ && s <= last_ && std::isfinite(v) && v < result.least) {
            result.least = v;
            place = s;
        }
    };
    const double middle = std::isfinite(first_) ? first_ : std::isfinite(last_) ? last_ : 0;
    seen(middle);
    for (double distance = nearest_sample; distance < farthest_sample; distance *= factor_of_samples) {
        seen(middle - distance);
        seen(middle + distance);
    }
    const double first = std::fabs(place - middle);  // at the nearest one a pole may be nearer
    const bottom_of_well sampled = result;
    const double sampled_place = place;
    double drop = 0;
    for (double near = first; first > nearest_sample && near > first * nearest_part; near /= 2) {
        const double here = place;
        const double before = result.least;
        seen(here - near);
        seen(here + near);
        drop = before - result.least;
    }
    if (drop > std::fabs(result.least) / 4) {  // towards a pole
        result = sampled;
        place = sampled_place;
    }
    // Where V has risen by s within 1/sqrt(s).
    const auto contains = [&](double size) {
        bool any = false;
        for (const double s : {place - 1 / std::sqrt(size), place + 1 / std::sqrt(size)}) {
            const double rise = right_.potential_near(s) - result.least;
            any = any || (s > first_ && s < last_ && rise <= size);
            if (s > first_ && s < last_ && !(rise <= size)) {
                return false;
            }
        }
        return any;
    };
    if (right_.is_in_x() && std::isfinite(result.least)) {
        const auto sized = [](int exponent) { return std::ldexp(1., exponent); };
        int exponent = largest_log2_of_size;
        while (exponent > -largest_log2_of_size && contains(sized(exponent - 1))) {
            --exponent;
        }
        result.size = exponent == largest_log2_of_size ? 1 : sized(exponent);
    }
    return result;
}

std::optional<well_problem::both_states> well_problem::states(const ball& e, bool counts_zeros) const {
    auto left = left_.at(e, counts_zeros);
    if (!left) {
        return std::nullopt;
    }
    left->slope = -left->slope;
    auto right = right_.at(e, counts_zeros);
    return right ? std::optional(both_states{*std::move(left), *std::move(right)}) : std::nullopt;
}

std::optional<long> well_problem::eigenvalues_below(const ball& e) const {
    const auto both = states(e, true);
    if (!both) {
        return std::nullopt;
    }
    const ball w = both->left.slope * both->right.value - both->left.value * both->right.slope;
    if (contains_zero(w)) {
        return std::nullopt;
    }
    const long zeros = both->left.zeros + both->right.zeros;
    const bool even = arb_is_positive(w.handle()) != 0;
    return (zeros % 2 == 0) == even ? zeros : zeros + 1;
}

std::optional<ball> well_problem::wronskian(const ball& e) const {
    const auto both = states(e, false);
    if (!both) {
        return std::nullopt;
    }
    const auto unit = [](const end_state& of) { return ball(1) / sqrt(of.value * of.value + of.slope * of.slope); };
    const ball w = both->left.slope * both->right.value - both->left.value * both->right.slope;
    return w * unit(both->left) * unit(both->right);
}

std::optional<rational> well_problem::continuum() const {
    const auto left = left_.continuum();
    const auto right = right_.continuum();
    return left && right ? std::min(*left, *right) : left ? left : right;
}

}  // namespace libration::ode
