#include "libration/integration/step.hpp"

#include <algorithm>
#include <limits>

#include "../algebra/dense_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/taylor/step_length.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// log2 of the largest of |radius/midpoint|.
double log2_of_relative_width(const std::vector<ball>& hull) {
    double most = -std::numeric_limits<double>::infinity();
    for (const ball& each : hull) {
        const magnitude reach = magnitude::radius_of(each);
        if (!reach.is_zero()) {
            const magnitude least = magnitude::below(midpoint_alone(each));
            most = std::max(most,
                            least.is_zero() ? std::numeric_limits<double>::infinity() : log_of(reach) - log_of(least));
        }
    }
    return most;
}

}  // namespace

step_report step::report() const {
    return {as_double(from_.time), as_double(length_), made_.bits,
            made_.order,           made_.method,       log2_of_relative_width(from_.set.hull())};
}

bool step::reaches(const ball& distance) const {
    ball size, whole;
    arb_abs(size.handle(), distance.handle());
    arb_abs(whole.handle(), length_.handle());
    return arb_le(size.handle(), whole.handle()) != 0;
}

bool step::covers(const ball& distance) const {
    const bool backwards = arb_is_negative(length_.handle()) != 0;
    const ball nearest = backwards ? -upper_bound(distance) : lower_bound(distance);
    return arb_is_nonnegative(nearest.handle()) != 0 && reaches(distance);
}

std::vector<ball> step::shared_values(const ball& distance) const {
    constexpr std::size_t most_kept = 64;
    const auto bits = static_cast<long>(ball::working_bits());
    const std::lock_guard guard(kept_guard_);
    const auto known = std::ranges::find_if(kept_, [&](const kept_values& each) {
        return each.bits == bits && arb_equal(each.distance.handle(), distance.handle()) != 0;
    });
    if (known != kept_.end()) {
        return known->values;
    }
    auto found = values(distance);
    if (kept_.size() < most_kept) {
        kept_.push_back({distance, bits, found});
    }
    return found;
}

ball step::end_time() const { return exact_sum(from_.time, length_); }

state_set box_around(const std::vector<ball>& values, long bits) {
    const precision_scope scope(decimal_digits(bits));
    state_set box;
    std::vector<magnitude> widths;
    for (const ball& each : values) {
        box.centre.push_back(exact_midpoint(each));
        widths.emplace_back(each - box.centre.back());
    }
    box.errors = lohner_set(std::move(widths));
    return box;
}

ball distance_between(const ball& a, const ball& b) {
    ball distance;
    const bool exact = is_exact(a) && is_exact(b);
    arb_sub(distance.handle(), a.handle(), b.handle(), exact ? ARF_PREC_EXACT : ball::working_bits());
    return distance;
}

ball_matrix unit_derivative(std::size_t size) {
    ball_matrix result(size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            result[i].emplace_back(i == j ? 1 : 0);
        }
    }
    return result;
}

}  // namespace libration::ode
