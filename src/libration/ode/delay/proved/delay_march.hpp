// The method of steps: the solution of a delay differential equation from breaking point to breaking point.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "../../proved/set_values.hpp"
#include "delay_pieces.hpp"
#include "libration/ode/delay/delay_system.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/ode/step.hpp"
#include "libration/scalar/ball/failure.hpp"

namespace libration::ode {

// In balls every result is proved (theorem D); other scalars round. A step ends at the latest where the next step of a
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
            end_ = march_end::precision;
        }
        return std::nullopt;
    }

    march_end end() const { return end_; }
    // The time up to which the steps lead.
    ball reached() const { return as_ball(R(origin_ + next_begins_)); }
    long steps() const { return steps_; }

private:
    // The equations of a stage in polynomial form, and their series.
    struct stage_series {
        explicit stage_series(delay_stage made, int order)
            : stage(std::move(made)),
              form(lifted(stage.system)),
              steps(tape::about_points(form.system)),
              expansion(steps, order) {}

        delay_stage stage;
        lifted_system form;
        tape steps;
        taylor_expansion<R> expansion;
    };

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
            stage_ = std::make_unique<stage_series>(stage_now(), taylor_order(static_cast<int>(bits_)) + 2);
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
                inputs.push_back(rounded(series[0]));
                inputs.push_back(rounded(series[1]));
            }
        }
        std::vector<number> leaves;
        for (const R& each : state_) {
            leaves.push_back(rounded(each));
        }
        return system_.stage(passed_, pieces_.begins(), leaves, inputs);
    }

    static number rounded(const R& x) {
        constexpr int bits = 30;
        const double value = rough_value(x);
        if (!std::isfinite(value)) {
            throw precision_exhausted("a state");
        }
        int exponent = 0;
        const double mantissa = std::frexp(value, &exponent);
        const rational power = exponent >= bits ? rational(integer(1) << (exponent - bits))
                                                : rational(integer(1), integer(1) << (bits - exponent));
        return number(rational(static_cast<long>(std::ldexp(mantissa, bits))) * power);
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
            values.push_back(with_error(here.series(k)[0], here.error(k, R(0)).value));
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
            if (auto made = step_of(length)) {
                finish_step(*std::move(made), end);
                return true;
            }
            end = shorter(length);
        }
        end_ = has_digits() ? march_end::steps : march_end::precision;
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
    std::optional<delay_step<R>> step_of(const R& length);
    void finish_step(delay_step<R> made, const step_end& end);

    bool is_too_short(const R& length) const {
        const double least = std::ldexp(std::abs(rough_value(next_begins_)), -least_step_bits);
        return !(rough_value(length) > std::max(least, std::numeric_limits<double>::min()));
    }
    bool has_digits() const {
        magnitude size, error;
        for (const R& each : state_) {
            size = larger_of(size, size_above(each));
            error = larger_of(error, error_of(each));
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
    // Errors of a step are this number of bits below those of its initial values.
    static constexpr double bits_below_error = 12;

    const delay_system& system_;
    long bits_;
    march_watch watch_;
    delay_pieces<R> pieces_;
    std::unique_ptr<stage_series> stage_;
    std::size_t passed_ = 0;
    std::vector<delayed_view<R>> views_;  // of each input, from the beginning of the step on
    R origin_ = R(0);                     // the beginning of the piece
    R length_ = R(0);                     // of the piece
    R next_begins_ = R(0);                // the distance of the next step from it, exact
    bool complete_ = false;               // whether the steps extend to its end
    std::vector<R> state_;                // at the beginning of the next step
    long steps_ = 0;
    march_end end_ = march_end::none;
};

// The series about the beginning of the step; false if the values there are not finite.
template <field R>
bool delay_march<R>::expand() {
    const delay_stage& stage = stage_->stage;
    const int order = stage_->expansion.order();
    std::vector<R> given(stage_->form.given, R(0));
    for (std::size_t k = 0; k < state_.size(); ++k) {
        given[stage.leaves[k]] = state_[k];
    }
    views_.clear();
    std::vector<known_series<R>> known;
    for (const delayed_input& each : stage.inputs) {
        views_.push_back(pieces_.view(each.of.delay, next_begins_));
        const auto series = views_.back().series(each.of.leaf);
        given[each.value] = with_error(series[0], views_.back().error(each.of.leaf, R(0)).value);
        given[each.slope] = series[1];
        std::vector<R> slopes(static_cast<std::size_t>(order) + 1, R(0));
        for (int n = 0; n < order; ++n) {
            slopes[static_cast<std::size_t>(n)] = R(series[static_cast<std::size_t>(n) + 1] * (n + 1));
        }
        known.push_back({static_cast<int>(each.slope), std::move(slopes)});
    }
    const R time = R(origin_ + next_begins_);
    const auto all = lifted_values(stage_->form, time, given);
    const bool finite = std::ranges::all_of(all, [](const R& each) { return size_above(each).is_finite(); });
    if (finite) {
        stage_->expansion.about(time, as_state(all), known);
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
        const double allowed = std::max(size - static_cast<double>(bits_), log_of(error_of(a[0])) - bits_below_error);
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
    if (const double parts = std::ceil(gap / std::exp2(log_of_length())); parts > 1) {
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

// std::nullopt if there is no bound for this length.
template <field R>
std::optional<delay_step<R>> delay_march<R>::step_of(const R& length) {
    const delay_stage& stage = stage_->stage;
    const int order = stage_->expansion.order();
    delay_step<R> made{.begins = next_begins_, .length = length, .series = {}, .error = {}, .slope_error = {}};
    std::optional<remainder_bound> bound;
    if constexpr (std::same_as<R, ball>) {
        std::vector<known_remainder> known;
        for (std::size_t i = 0; i < views_.size(); ++i) {
            known.push_back(
                {static_cast<int>(stage.inputs[i].slope), views_[i].error(stage.inputs[i].of.leaf, length).slope});
        }
        bound =
            bounded_remainder(stage_->steps, stage_->expansion, R(origin_ + next_begins_), magnitude(length), known);
        if (!bound) {
            return std::nullopt;
        }
    }
    for (const std::size_t place : stage.leaves) {
        const R* const a = stage_->expansion.coefficients(static_cast<int>(place));
        made.series.emplace_back(a, a + order + 1);
        made.error.push_back(bound ? bound->error[place] : magnitude());
        made.slope_error.push_back(bound ? bound->slope_error[place] : magnitude());
    }
    return made;
}

template <field R>
void delay_march<R>::finish_step(delay_step<R> made, const step_end& end) {
    for (std::size_t k = 0; k < state_.size(); ++k) {
        state_[k] = with_error(value_of(made.series[k], made.length), made.error[k]);
    }
    pieces_.add(std::move(made));
    next_begins_ = end.at;
    complete_ = end.of_piece;
    if (++steps_ % steps_unwatched == 0 && watch_) {
        watch_(reached(), bits_);
    }
}

}  // namespace libration::ode
