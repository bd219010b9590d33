// The method of steps: the solution of a delay differential equation from breaking point to breaking point.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "delay_errors.hpp"
#include "delay_pieces.hpp"
#include "libration/equation/delay_system.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/taylor/step_length.hpp"
#include "libration/scalar/ball/failure.hpp"

namespace libration::ode {

// In balls every result is proved (theorem M); other scalars round. A step ends at the latest where the next step of a
// delayed value begins, so that this value is one polynomial on it.
template <field R>
class delay_march {
public:
    static constexpr long most_steps = 10'000'000;

    // With so many bits, those of R in arithmetic that rounds. The system must outlive this object.
    delay_march(const delay_system& system, long bits, march_watch watch = {})
        : system_(system), bits_(bits), watch_(std::move(watch)), pieces_(system) {
        const precision_scope scope(decimal_digits(bits) + 10);
        for (const number& each : system.starts()) {
            state_.push_back(constant_value<R>::of(each));
        }
        errors_.begin(state_);
        begin_piece();
    }

    // The leaves at a time from the initial point on, which increases from call to call. std::nullopt for the reason
    // end().
    std::optional<std::vector<R>> at(const number& time) {
        const precision_scope scope(decimal_digits(bits_) + 10);
        try {
            while ((time - pieces_.ends()).sign() > 0) {
                if (!finish_piece()) {
                    return std::nullopt;
                }
            }
            const R distance = constant_value<R>::of(time - pieces_.begins());
            while (!complete_ && !certainly_negative(R(distance - next_begins_))) {
                if (!take_step()) {
                    return std::nullopt;
                }
            }
            return values_at(distance);
        } catch (const precision_exhausted&) {
            end_ = stop::precision;
        }
        return std::nullopt;
    }

    // The next step, valid until the one after it; null for the reason end(). Not together with at().
    const delay_step<R>* next_step() {
        const precision_scope scope(decimal_digits(bits_) + 10);
        try {
            if (complete_) {
                pieces_.begin_next();
                begin_piece();
            }
            return take_step() ? &pieces_.steps().back() : nullptr;
        } catch (const precision_exhausted&) {
            end_ = stop::precision;
        }
        return nullptr;
    }
    // The time of the beginning of such a step.
    R beginning_of(const delay_step<R>& step) const { return R(origin_ + step.begins); }

    stop end() const { return end_; }
    // The time up to which the steps lead.
    ball reached() const { return as_ball(R(origin_ + next_begins_)); }
    long steps() const { return steps_; }
    long bits() const { return bits_; }

private:
    using state_errors = std::conditional_t<std::same_as<R, ball>, proved_errors, rounding_errors<R>>;

    // The end of a step: the distance from the beginning of the piece.
    struct step_end {
        R at;
        bool of_piece = false;
    };

    void begin_piece() {
        origin_ = constant_value<R>::of(pieces_.begins());
        length_ = constant_value<R>::of(pieces_.ends() - pieces_.begins());
        next_begins_ = R(0);
        complete_ = false;
        if (!stage_ || pieces_.passed() > passed_) {
            passed_ = pieces_.passed();
            stage_ = std::make_unique<stage_series<R>>(stage_now(), taylor_order(static_cast<int>(bits_)) + 2);
            errors_.begin_stage(stage_->form);
        }
    }

    // The equations from here on, with rounded initial values, which have no effect on the series.
    delay_stage stage_now() const {
        if (pieces_.is_first()) {
            return system_.first_stage();
        }
        std::vector<number> inputs;
        for (const delayed_leaf& each : system_.delayed()) {
            if (each.delay < passed_) {
                const auto series = pieces_.view(each.delay, next_begins_).series(each.leaf);
                inputs.push_back(rounded_number(series[0]));
                inputs.push_back(rounded_number(series[1]));
            }
        }
        std::vector<number> leaves;
        for (const R& each : state_) {
            leaves.push_back(rounded_number(each));
        }
        return system_.stage(passed_, pieces_.begins(), leaves, inputs);
    }

    bool finish_piece() {
        while (!complete_) {
            if (!take_step()) {
                return false;
            }
        }
        pieces_.begin_next();
        begin_piece();
        return true;
    }

    // By the last step that contains it.
    std::vector<R> values_at(const R& distance) const {
        const delayed_view<R> here = pieces_.view(distance);
        std::vector<R> values;
        for (std::size_t k = 0; k < system_.leaves().size(); ++k) {
            values.push_back(with_error(here.value(k), here.error(k, R(0)).value));
        }
        return values;
    }

    bool take_step() {
        const bool finite = expand();
        step_end end = finite ? end_of_step() : step_end{next_begins_};
        for (int attempt = 0; attempt < most_attempts; ++attempt) {
            const R length = R(end.at - next_begins_);
            if (is_too_short(length) || steps_ >= most_steps) {
                break;
            }
            if (step_of(length)) {
                finish_step(end);
                log_of_limit_ =
                    attempt > 0 ? std::log2(rough_value(length)) + growth_of_limit : log_of_limit_ + growth_of_limit;
                return true;
            }
            end = shorter(length);
        }
        end_ = has_digits() ? stop::step_too_small : stop::precision;
        return false;
    }

    bool expand();
    step_end end_of_step() const;
    step_end shorter(const R& length) const { return {after(std::log2(rough_value(length)) - 1), false}; }
    // The exact distance of about 2^log_of_length from the beginning of the step.
    R after(double log_of_length) const {
        constexpr int bits = 24;
        const double whole = std::floor(log_of_length);
        const int mantissa = static_cast<int>(std::ldexp(std::exp2(log_of_length - whole), bits));
        return exact_sum(next_begins_, binary_fraction(next_begins_, mantissa, static_cast<int>(whole) - bits));
    }
    double log_of_length() const;
    bool step_of(const R& length);
    void finish_step(const step_end& end);

    bool is_too_short(const R& length) const {
        const double least = std::ldexp(std::abs(rough_value(next_begins_)), -least_step_bits);
        return !(rough_value(length) > std::max(least, std::numeric_limits<double>::min()));
    }
    bool has_digits() const {
        magnitude size, error;
        for (std::size_t k = 0; k < state_.size(); ++k) {
            size = larger_of(size, size_above(state_[k]));
            error = larger_of(error, errors_.reach(k));
        }
        return error <= size * magnitude::of(1, 2 * static_cast<long>(widest_set));
    }
    static magnitude error_of(const ball& x) { return magnitude::radius_of(x); }
    template <ordered_scalar T>
    static magnitude error_of(const T& /*x*/) {
        return {};
    }

    static constexpr int most_attempts = 60;
    static constexpr int least_step_bits = 40;
    static constexpr int bits_of_equal_ends = 24;
    static constexpr double most_log_of_parts = 60;
    static constexpr long steps_unwatched = 16;
    // log2 of the factor by which the longest length that is tried grows per step, after one that was too long.
    static constexpr double growth_of_limit = 0.25;
    // Errors of a step are this number of bits below those of its initial values.
    static constexpr double bits_below_error = 12;

    const delay_system& system_;
    long bits_;
    march_watch watch_;
    delay_pieces<R> pieces_;
    std::unique_ptr<stage_series<R>> stage_;
    std::size_t passed_ = 0;
    std::vector<delayed_view<R>> views_;  // of each input, from the beginning of the step on
    std::vector<R> given_;                // the state at the beginning of the step, with the inputs
    std::vector<known_series<R>> known_;  // the slopes of the inputs
    delay_step<R> made_;                  // the step, and the state at its end
    std::vector<R> image_;
    state_errors errors_;
    double log_of_limit_ = no_radius;  // of the length of a step, log2
    R origin_ = R(0);                  // the beginning of the piece
    R length_ = R(0);                  // of the piece
    R next_begins_ = R(0);             // the distance of the next step from it, exact
    bool complete_ = false;            // whether the steps extend to its end
    std::vector<R> state_;             // at the beginning of the next step
    long steps_ = 0;
    stop end_ = stop::none;
};

// The series about the beginning of the step; false if the values there are not finite.
template <field R>
bool delay_march<R>::expand() {
    const int order = stage_->expansion.order();
    given_ = state_;
    given_.resize(stage_->form.given, R(0));
    views_.clear();
    known_.clear();
    for (const delayed_input& each : stage_->stage.inputs) {
        views_.push_back(pieces_.view(each.of.delay, next_begins_));
        const auto series = views_.back().series(each.of.leaf);
        given_[each.value] = with_error(series[0], views_.back().error(each.of.leaf, R(0)).value);
        given_[each.slope] = series[1];
        std::vector<R> slopes(static_cast<std::size_t>(order) + 1, R(0));
        for (int n = 0; n < order; ++n) {
            slopes[static_cast<std::size_t>(n)] = R(series[static_cast<std::size_t>(n) + 1] * (n + 1));
        }
        known_.push_back({static_cast<int>(each.slope), std::move(slopes)});
    }
    const R time = R(origin_ + next_begins_);
    const auto all = lifted_values(stage_->form, time, given_);
    const bool finite = std::ranges::all_of(all, [](const R& each) { return size_above(each).is_finite(); });
    if (finite) {
        stage_->expansion.about(time, as_state(all), known_);
    }
    return finite;
}

// log2 of the length at which the last terms are below the last bit of each unknown, or far below its error.
template <field R>
double delay_march<R>::log_of_length() const {
    const auto& expansion = stage_->expansion;
    const int order = expansion.order();
    const std::size_t count = stage_->steps.orders().size();
    double radius = no_radius;
    for (std::size_t i = 0; i < count; ++i) {
        const R* const a = expansion.coefficients(static_cast<int>(i));
        radius = std::min(radius, estimated_radius(a, order, [](const R& x) { return size_above(x); }));
    }
    if (radius == no_radius) {
        return no_radius;
    }
    double least = radius - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const R* const a = expansion.coefficients(static_cast<int>(i));
        double size = nothing;
        for (int n = 0; n <= order; ++n) {
            size = std::max(size, log_of(size_above(a[n])) + n * (radius - 3));
        }
        const magnitude error = i < state_.size() ? errors_.reach(i) : error_of(a[0]);
        const double allowed = std::max(size - static_cast<double>(bits_), log_of(error) - bits_below_error);
        for (int n = order - 1; n <= order; ++n) {
            if (const double last = log_of(size_above(a[n])); n > 0 && last > nothing) {
                least = std::min(least, (allowed - last) / n);
            }
        }
    }
    return least;
}

// The end of the step by its own length, by the next steps of the delayed values, and the end of the piece.
template <field R>
auto delay_march<R>::end_of_step() const -> step_end {
    std::vector<step_end> ends{{length_, true}};
    for (const delayed_view<R>& each : views_) {
        if (const auto rest = each.rest()) {
            ends.push_back({one_of(R(next_begins_ + *rest)), false});
        }
    }
    const auto distance = [&](const step_end& end) { return rough_value(R(end.at - next_begins_)); };
    double gap = distance(ends.front());
    for (const step_end& each : ends) {
        gap = std::min(gap, distance(each));
    }
    if (const double parts = std::ceil(gap / std::exp2(std::min(log_of_length(), log_of_limit_))); parts > 1) {
        return {after(std::log2(gap) - std::min(std::log2(parts), most_log_of_parts)), false};
    }
    // Of ends at nearly the same time the last one, so that no short step is left; the end of the piece is exact.
    const double near = gap * (1 + std::ldexp(1.0, -bits_of_equal_ends));
    if (distance(ends.front()) <= near) {
        return ends.front();
    }
    std::erase_if(ends, [&](const step_end& each) { return distance(each) > near; });
    return *std::ranges::max_element(ends, {}, distance);
}

// Prepares the step; false if there is no bound for this length.
template <field R>
bool delay_march<R>::step_of(const R& length) {
    const int order = stage_->expansion.order();
    const R time = R(origin_ + next_begins_);
    std::vector<magnitude> slope_errors;
    for (std::size_t i = 0; i < views_.size(); ++i) {
        slope_errors.push_back(views_[i].error(stage_->stage.inputs[i].of.leaf, length).slope);
    }
    std::optional<remainder_bound> bound;
    if constexpr (std::same_as<R, ball>) {
        std::vector<known_remainder> known;
        for (std::size_t i = 0; i < known_.size(); ++i) {
            known.push_back({known_[i].unknown, slope_errors[i]});
        }
        bound = bounded_remainder(stage_->steps, stage_->expansion, time, magnitude(length), known);
        if (!bound) {
            return false;
        }
    }
    if (!errors_.enclose({time, length, given_, known_, slope_errors})) {
        return false;
    }
    made_ = {.begins = next_begins_, .length = length, .series = {}, .error = {}, .slope_error = {}};
    image_.clear();
    const auto spread = errors_.spread(state_.size());
    for (std::size_t k = 0; k < state_.size(); ++k) {
        const R* const a = stage_->expansion.coefficients(static_cast<int>(k));
        made_.series.emplace_back(a, a + order + 1);
        const series_error own = bound ? series_error{bound->error[k], bound->slope_error[k]} : series_error{};
        made_.error.push_back(own.value + spread[k].value);
        made_.slope_error.push_back(own.slope + spread[k].slope);
        image_.push_back(with_error(value_of(made_.series[k], length), own.value));
    }
    return true;
}

template <field R>
void delay_march<R>::finish_step(const step_end& end) {
    state_ = image_;
    errors_.advance(state_, made_.series);
    pieces_.add(std::move(made_));
    next_begins_ = end.at;
    complete_ = end.of_piece;
    if (++steps_ % steps_unwatched == 0 && watch_) {
        watch_(reached(), bits_);
    }
}

}  // namespace libration::ode
