#include "libration/integration/proved_march.hpp"

#include <algorithm>
#include <utility>

#include "libration/equation/constant_value.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/failure.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

proved_march::proved_march(const explicit_system& system, long bits, march_watch watch, long error_bits,
                           const proof_route& route)
    : proved_march(system, start_of(system, bits), {bits, error_bits}, std::move(watch), route) {}

proved_march::proved_march(const explicit_system& system, const std::vector<ball>& start, long bits, long error_bits,
                           march_watch watch, const proof_route& route)
    : proved_march(system, {start_of(system, bits).time, box_around(start, bits), {}, {}}, {bits, error_bits},
                   std::move(watch), route) {}

proved_march::proved_march(const explicit_system& system, flow_state start, const run_bits& bits, march_watch watch,
                           const proof_route& route)
    : bits_(bits),
      start_(std::move(start)),
      rule_(rule_for(system, bits, route)),
      watch_(std::move(watch)),
      reached_(start_.time) {}

proved_march::proved_march(const kept_part& kept, const explicit_system& system, long bits, int direction,
                           march_watch watch, const proof_route& route)
    : watch_(std::move(watch)),
      kept_(kept.steps),
      along_(kept_->along(kept.part, system, bits, direction, route)),
      reached_(along_->start().time) {
    bits_.bits = along_->bits();
    start_.time = along_->start().time;
    along_->call(watch_, {});
}

// The callbacks do not outlive the question.
proved_march::~proved_march() {
    if (kept_ != nullptr) {
        along_->call({}, {});
    }
}

void proved_march::observe(step_observer observer) {
    observer_ = std::move(observer);
    if (along_) {
        along_->call(watch_, observer_);
    }
}

void proved_march::aim(const number& farthest) {
    const precision_scope scope(decimal_digits(bits_.bits) + 20);
    farthest_ = constant_value<ball>::of(farthest);
}

void proved_march::keep_derivative() {
    start_.derivative = unit_derivative(start_.set.centre.size());
    rule_->begin(start_);  // which may reject it
}

integration& proved_march::along() {
    if (!along_) {
        along_ = std::make_shared<integration>(start_, rule_, start_.time, bits_.bits, watch_, observer_);
    }
    return *along_;
}

std::optional<std::vector<ball>> proved_march::at(const number& time) {
    const precision_scope scope(decimal_digits(bits_.bits) + 20);
    return at(constant_value<ball>::of(time));
}

// The place of a target; std::nullopt for the reason end_.
std::optional<step_at> proved_march::place_of(const ball& target) {
    integration& steps = along();
    const auto gone = [&](const ball& time) { return magnitude(distance_between(time, start_.time)); };
    steps.aim(farthest_ && gone(target) < gone(*farthest_) ? *farthest_ : target);
    for (;; ++now_) {
        const step* const here = steps[now_];
        reached_ = here != nullptr ? here->from().time : steps.reached();
        if (here == nullptr) {
            end_ = steps.why();
            return std::nullopt;
        }
        if (here->reaches(distance_between(target, reached_))) {
            return steps_about(steps, now_, target);
        }
        steps_ += here->cost();
        if (kept_ == nullptr || !kept_->keeps(steps)) {
            steps.forget_before(now_);
        }
    }
}

std::optional<std::vector<ball>> proved_march::at(const ball& target) {
    const precision_scope scope(decimal_digits(bits_.bits) + 20);
    try {
        const auto place = place_of(target);
        return place ? std::optional(values_at(*place)) : std::nullopt;
    } catch (const precision_exhausted&) {
        end_ = stop::precision;
    }
    return std::nullopt;
}

std::optional<std::vector<ball>> proved_march::at_end() {
    if (end_ == stop::none || now_ == 0) {
        return std::nullopt;
    }
    const precision_scope scope(decimal_digits(bits_.bits) + 20);
    try {
        std::size_t last = now_ - 1;
        const auto place = steps_about(*along_, last, reached_);
        return place ? std::optional(values_at(*place)) : std::nullopt;
    } catch (const precision_exhausted&) {
        return std::nullopt;
    }
}

ball_matrix proved_march::derivative_at(const ball& time) { return ode::derivative_at(*place_of(time)); }

}  // namespace libration::ode
