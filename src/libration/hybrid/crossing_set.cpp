#include "crossing_set.hpp"

#include <algorithm>
#include <utility>

#include "../integration/taylor/series_step.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "states_around.hpp"

namespace libration::ode {

namespace {

// Of expressions in the leaves of a form, at a state and a time.
expression_values<ball> values_in(const first_order_form& form, const std::vector<ball>& state, const ball& time) {
    expression_values<ball> values(form.leaves, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    return values;
}

std::vector<ball> reset_state(const set_crossing& at, const std::vector<ball>& state, const ball& time) {
    auto values = values_in(at.before, state, time);
    std::vector<ball> result;
    for (const expression& each : at.reset) {
        result.push_back(values.of(at.before.in_leaves(each)));
    }
    return result;
}

// Newton's step for g from the middle of a ball of times, by the states at the middle and in the ball.
ball newton_step(const set_crossing& at, const ball& times, const std::vector<ball>& in_middle,
                 const std::vector<ball>& all) {
    const expression g = at.before.in_leaves(*at.g);
    const ball middle = midpoint_alone(times);
    return middle -
           values_in(at.before, in_middle, middle).of(g) / values_in(at.before, all, times).of(at.before.slope_of(g));
}

// Whether every solution through the set of the step has a zero of g in these times: g' excludes 0, and the interval
// Newton step stays within them.
bool every_solution_crosses(const step& here, const set_crossing& at, const ball& times) {
    const ball& begin = here.from().time;
    const ball next = newton_step(at, times, here.values(distance_between(midpoint_alone(times), begin)),
                                  here.values(distance_between(times, begin)));
    return is_finite(next) && contains(times, next);
}

// The time at which the solution through the centre of the set crosses, one of `times`.
std::optional<ball> crossing_of_centre(const taylor_series& series, const ball& begin, const set_crossing& at,
                                       const ball& times) {
    if (at.g == nullptr) {
        return times;
    }
    const ball found = newton_step(at, times, series.flow_of_centre(distance_between(midpoint_alone(times), begin)),
                                   series.flow_of_centre(distance_between(times, begin)));
    ball both;
    const bool meet =
        is_finite(found) && arb_intersection(both.handle(), found.handle(), times.handle(), ball::working_bits()) != 0;
    return meet ? std::optional(both) : std::nullopt;
}

// A bound of |D - 1|, entry by entry, for the derivative D of the flow of the next branch over at most the diameter of the
// ball of times, in the states `around`: exp(w L) - 1, L the norm of the derivative of the right-hand side.
ball change_of_flow(const set_crossing& at, const ball& times, const std::vector<ball>& around) {
    auto values = values_in(at.after, around, times);
    ball largest(0);
    for (const expression& slope : at.after.slopes) {
        ball sum(0);
        for (const expression& leaf : at.after.leaves) {
            sum += abs(values.of(partial(slope, leaf)));
        }
        largest = upper_bound(hull(sum, largest));
    }
    const ball width = magnitude::radius_of(times).shifted(1).exact();
    return upper_bound(expm1(largest * width));
}

// The derivative of the states at `begin` by those at the beginning of the step, without the factor D: over all solutions
// of the set, with the states before and after the event.
ball_matrix map_of_crossing(const ball_matrix& flow, const std::vector<ball>& states, const std::vector<ball>& after,
                            const set_crossing& at, const ball& times) {
    auto values = values_in(at.before, states, times);
    const auto value = [&](const expression& e) { return values.of(at.before.in_leaves(e)); };
    const auto slopes = at.before.slopes_at(states, times);
    const auto slopes_after = at.after.slopes_at(after, times);
    const std::size_t n = states.size();
    std::vector<ball> of_time(n, ball(0));
    if (at.g != nullptr) {
        const ball slope_of_g = values.of(at.before.slope_of(at.before.in_leaves(*at.g)));
        for (std::size_t l = 0; l < n; ++l) {
            const ball by = value(partial(*at.g, at.before.given[l]));
            for (std::size_t j = 0; j < n; ++j) {
                of_time[j] -= by * flow[l][j] / slope_of_g;
            }
        }
    }
    ball_matrix map;
    for (const expression& reset : at.reset) {
        auto& row = map.emplace_back();
        ball moved = value(partial(reset, variable())) - slopes_after[map.size() - 1];
        std::vector<ball> by;
        for (std::size_t l = 0; l < n; ++l) {
            by.push_back(value(partial(reset, at.before.given[l])));
            moved += by[l] * slopes[l];
        }
        for (std::size_t j = 0; j < n; ++j) {
            ball sum = moved * of_time[j];
            for (std::size_t l = 0; l < n; ++l) {
                sum += by[l] * flow[l][j];
            }
            row.push_back(std::move(sum));
        }
    }
    return map;
}

}  // namespace

std::optional<state_set> set_after_crossing(const step& here, const set_crossing& at) {
    const auto* const by_series = dynamic_cast<const series_step*>(&here);
    const ball times = at.g == nullptr ? at.time : widened(at.time, magnitude::radius_of(at.time));
    const ball& start = here.from().time;
    const ball distance = distance_between(times, start);
    if (by_series == nullptr || !here.covers(distance) ||
        (at.g != nullptr && !every_solution_crosses(here, at, times))) {
        return std::nullopt;
    }
    const taylor_series& series = *by_series->series();
    const auto states = here.values(distance);
    const auto after = reset_state(at, states, times);
    const auto around = at.g == nullptr ? std::optional(after) : states_around(at.after, after, times);
    const auto crossing = crossing_of_centre(series, start, at, times);
    if (!around || !crossing) {
        return std::nullopt;
    }
    const auto centre = reset_state(at, series.flow_of_centre(distance_between(*crossing, start)), *crossing);
    const auto around_centre = at.g == nullptr ? std::optional(centre) : states_around(at.after, centre, times);
    if (!around_centre) {
        return std::nullopt;
    }
    const auto image = at.g == nullptr ? centre : states_moved(at.after, centre, *crossing, *around_centre, at.begin);
    ball_matrix map = map_of_crossing(series.derivative_of_flow(distance), states, after, at, times);
    const ball change = at.g == nullptr ? ball(0) : change_of_flow(at, times, *around);
    const auto all_finite = [](const auto& all) {
        return std::ranges::all_of(all, [](const ball& x) { return is_finite(x); });
    };
    if (!is_finite(change) || !all_finite(image) || !std::ranges::all_of(map, all_finite)) {
        return std::nullopt;
    }
    const ball_matrix without_change = map;
    for (std::size_t j = 0; j < map.size(); ++j) {
        ball sum(0);
        for (const auto& row : without_change) {
            sum += abs(row[j]);
        }
        for (auto& row : map) {
            row[j] = widened(row[j], magnitude(change * sum));
        }
    }
    state_set result;
    std::vector<magnitude> added;
    for (const ball& each : image) {
        result.centre.push_back(exact_midpoint(each));
        added.emplace_back(each - result.centre.back());
    }
    result.errors = series.errors.image(map, added);
    return result;
}

}  // namespace libration::ode
