#include "libration/integration/integration.hpp"

#include <algorithm>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/failure.hpp"

namespace libration::ode {

namespace {

// The number of steps between two calls of the progress callback, unless steps take long.
constexpr long steps_unwatched = 64;
constexpr long bits_unwatched = 4096;

}  // namespace

integration::integration(flow_state start, std::shared_ptr<step_rule> rule, ball farthest, long bits, march_watch watch,
                         step_observer observer)
    : start_(std::move(start)),
      rule_(std::move(rule)),
      farthest_(std::move(farthest)),
      bits_(bits),
      watch_(std::move(watch)),
      observer_(std::move(observer)),
      reached_(start_.time) {
    rule_->begin(start_);
}

const step* integration::operator[](std::size_t k) {
    while (k >= first_ + steps_.size() && why_ == stop::none) {
        if (watch_ &&
            (cost_ / steps_unwatched != watched_ / steps_unwatched || (bits_ > bits_unwatched && cost_ != watched_))) {
            watched_ = cost_;
            watch_(reached_, bits_);
        }
        try {
            make_next();
        } catch (const precision_exhausted&) {
            why_ = stop::precision;
        }
    }
    return k >= first_ && k < first_ + steps_.size() ? steps_[k - first_].get() : nullptr;
}

void integration::make_next() {
    const precision_scope scope(decimal_digits(bits_) + 20);
    const flow_state from = last();
    next_step next = rule_->next(from, distance_between(farthest_, from.time));
    why_ = next.why;
    if (next.made) {
        note(*next.made);
        steps_.push_back(std::move(next.made));
    }
}

void integration::note(const step& made) {
    cost_ += made.cost();
    reached_ = made.end_time();
    const bool by_collocation = made.made().method == step_method::collocation;
    if (by_collocation) {
        if (collocation_.steps++ == 0) {
            collocation_.first = as_double(made.from().time);
        }
        collocation_.periods += in_collocation_ ? 0 : 1;
        const double last = as_double(reached_);
        const double farthest = as_double(farthest_);
        collocation_.last =
            arb_is_negative(made.length().handle()) != 0 ? std::max(last, farthest) : std::min(last, farthest);
    }
    in_collocation_ = by_collocation;
    if (observer_) {
        observer_(made.report());
    }
}

// The last one remains, from which the next one is made.
void integration::forget_before(std::size_t k) {
    while (first_ < k && steps_.size() > 1) {
        steps_.pop_front();
        ++first_;
    }
}

namespace {

// The ends of distances within a step in its direction.
ball nearest_of(const ball& distance, const step& of) {
    return arb_is_negative(of.length().handle()) != 0 ? upper_bound(distance) : lower_bound(distance);
}
ball farthest_of(const ball& distance, const step& of) {
    return arb_is_negative(of.length().handle()) != 0 ? lower_bound(distance) : upper_bound(distance);
}

std::vector<ball> joined(std::vector<ball> a, const std::vector<ball>& b) {
    std::ranges::transform(a, b, a.begin(), [](const ball& x, const ball& y) { return hull(x, y); });
    return a;
}

}  // namespace

std::optional<step_at> steps_about(step_sequence& along, std::size_t& k, const ball& target) {
    const step* here = along[k];
    while (here != nullptr && !here->reaches(distance_between(target, here->from().time))) {
        here = along[++k];
    }
    if (here == nullptr) {
        return std::nullopt;
    }
    const ball distance = distance_between(target, here->from().time);
    if (here->covers(distance)) {
        return step_at{here, distance};
    }
    const step* const before = k > 0 ? along[k - 1] : nullptr;
    const ball begins = before != nullptr ? nearest_of(distance_between(target, before->from().time), *before) : ball();
    if (before == nullptr || !before->covers(begins)) {
        throw precision_exhausted("a time about the beginning of a step");
    }
    return step_at{here, hull(ball(0), farthest_of(distance, *here)), before, hull(begins, before->length())};
}

std::vector<ball> values_at(const step_at& place) {
    auto values = place.here->values(place.distance);
    return place.before != nullptr ? joined(std::move(values), place.before->values(place.distance_before)) : values;
}

ball_matrix derivative_at(const step_at& place) {
    ball_matrix result = place.here->derivative(place.distance);
    if (place.before != nullptr) {
        const ball_matrix other = place.before->derivative(place.distance_before);
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] = joined(std::move(result[i]), other[i]);
        }
    }
    return result;
}

ball infinite_distance(int direction) {
    ball result;
    direction < 0 ? arb_neg_inf(result.handle()) : arb_pos_inf(result.handle());
    return result;
}

}  // namespace libration::ode
