// The errors of the state of a delay differential equation, from step to step.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "delay_stage_series.hpp"
#include "delayed_value.hpp"
#include "libration/integration/taylor/step_length.hpp"

namespace libration::ode {

// The first terms of a series, with a 0 behind them. Returns a bound of the others up to the time `length`.
inline magnitude shorten_series(std::vector<ball>& series, std::size_t count, const magnitude& length) {
    magnitude rest;
    for (std::size_t n = count; n < series.size(); ++n) {
        rest.add_product(magnitude(series[n]), pow(length, n));
    }
    series.resize(count, ball(0));
    series.emplace_back(0);
    return rest;
}

// A step before its errors are known: the distance of its beginning from the initial point, its length, the state there,
// and the known slopes with bounds of their errors.
template <field R>
struct delay_step_start {
    R time, length;
    const std::vector<R>& state;
    const std::vector<known_series<R>>& known;
    const std::vector<magnitude>& slope_errors;
};

// Of arithmetic that rounds: none.
template <field R>
class rounding_errors {
public:
    void begin(std::vector<R>& /*state*/) {}
    void begin_stage(const polynomial_form& /*form*/) {}
    magnitude reach(std::size_t /*leaf*/) const { return {}; }
    bool enclose(const delay_step_start<R>& /*step*/) { return true; }
    std::vector<series_error> spread(std::size_t leaves) const { return std::vector<series_error>(leaves); }
    void advance(std::vector<R>& /*state*/, const std::vector<std::vector<R>>& /*series*/) {}
};

// Of balls: the state is in c + E, c exact. By the derivatives of the solution on a step by its beginning, over the whole
// set (theorem V with the known functions of theorem M).
class proved_errors {
public:
    // Replaces each ball by its midpoint.
    void begin(std::vector<ball>& state) {
        std::vector<magnitude> radii;
        for (ball& each : state) {
            const ball centre = exact_midpoint(each);
            radii.emplace_back(each - centre);
            each = centre;
        }
        errors_ = lohner_set(std::move(radii));
    }

    void begin_stage(const polynomial_form& form) {
        variations_ = std::make_unique<stage_variations>(form, errors_.size());
    }

    // A bound of the error of a leaf at the beginning of the step.
    magnitude reach(std::size_t leaf) const { return errors_.reach(leaf); }

    // Prepares the step; false if it is too long.
    bool enclose(const delay_step_start<ball>& step) {
        const precision_scope few(decimal_digits(stage_variations::bits));
        std::vector<ball> state = step.state;
        for (std::size_t k = 0; k < errors_.size(); ++k) {
            state[k] = widened(state[k], errors_.reach(k));
        }
        const magnitude length(step.length);
        std::vector<known_series<ball>> known = step.known;
        std::vector<known_remainder> rest;
        for (std::size_t i = 0; i < known.size(); ++i) {
            rest.push_back(
                {known[i].unknown,
                 step.slope_errors[i] +
                     shorten_series(known[i].coefficients, static_cast<std::size_t>(variations_->order()), length)});
        }
        length_ = step.length;
        return variations_->expand(step.time, state, known) && variations_->bound(length, rest);
    }

    // For each leaf a bound of the difference, on the whole step, of a solution that begins in c + E to that from c, and of
    // their derivatives.
    std::vector<series_error> spread(std::size_t leaves) const {
        constexpr int parts = 8;
        const precision_scope few(decimal_digits(stage_variations::bits));
        const ball half = length_ / (2 * parts);
        std::vector<series_error> result(leaves);
        for (int i = 0; i < parts; ++i) {
            const ball part = widened(half * (2 * i + 1), magnitude(half));
            const ball_matrix values = variations_->values_at(part);
            const ball_matrix slopes = variations_->slopes_at(part);
            for (std::size_t k = 0; k < leaves; ++k) {
                result[k].value = larger_of(result[k].value, errors_.reach(values, k));
                result[k].slope = larger_of(result[k].slope, errors_.reach(slopes, k));
            }
        }
        return result;
    }

    // From the solution from c at the end of the step to the next c. The scales of the set are those of the series on the
    // step, since a leaf may pass through 0.
    void advance(std::vector<ball>& state, const std::vector<std::vector<ball>>& series) {
        std::vector<magnitude> added;
        std::vector<long> scales;
        for (ball& each : state) {
            const ball centre = exact_midpoint(each);
            added.emplace_back(each - centre);
            each = centre;
        }
        const precision_scope few(decimal_digits(stage_variations::bits));
        errors_ = errors_.image(variations_->values_at(length_), added);
        for (std::size_t k = 0; k < state.size(); ++k) {
            magnitude size = errors_.reach(k);
            for (std::size_t n = 0; n < series[k].size(); ++n) {
                size = larger_of(size, magnitude(series[k][n]) * pow(magnitude(length_), n));
            }
            scales.push_back(size.is_zero() ? 0 : size.exponent());
        }
        errors_ = errors_.settled(scales);
    }

private:
    lohner_set errors_;
    std::unique_ptr<stage_variations> variations_;
    ball length_;
};

}  // namespace libration::ode
