#include "event_question.hpp"

#include <string>

#include "../../equation/bound_text.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// Of the working precision, besides the bits of the integration.
constexpr long guard_digits = 20;

closed_interval bounds_of(const ball& x) { return {lower_bound(x), upper_bound(x)}; }

ball any_number() {
    ball all;
    arb_zero_pm_inf(all.handle());
    return all;
}

}  // namespace

event_question::event_question(const set_problem& of, const set_event_request& asked, long bits,
                               const march_watch& watch, const proof_route& route)
    : set_query(of, bits, watch, route),
      asked_(asked),
      direction_(asked.before && (*asked.before - of.system().point()).sign() < 0 ? -1 : 1),
      form_(of.system()),
      g_(form_.in_leaves(of.condition())),
      slope_(form_.slope_of(g_)),
      coefficient_(form_.leaves.size()) {
    std::vector<std::size_t> moving;
    for (std::size_t k = 0; k < form_.leaves.size(); ++k) {
        gradient_.push_back(partial(g_, form_.leaves[k]));
        if (!gradient_[k].is(0) && !form_.slopes[k].is(0)) {
            moving.push_back(k);
        }
    }
    if (moving.size() == 1 && gradient_[moving.front()].is_constant() && partial(g_, variable()).is(0)) {
        coefficient_[moving.front()] = gradient_[moving.front()].constant();
    }
}

// The value at an event of the unknown x in c x + h = 0.
ball event_question::by_condition(std::size_t place, const proved_event& event) const {
    expression_values<ball> values(form_.leaves, event.time);
    for (std::size_t k = 0; k < event.state.size(); ++k) {
        values.push_back(k == place ? ball(0) : event.state[k]);
    }
    return -values.of(g_) / constant_value<ball>::of(*coefficient_[place]);
}

// Throws error of the kind undecided if the condition may hold at the initial point of some solutions, but not of all.
set_start event_question::start_from(const number_box& box) const {
    set_start start{of_.states_of(box)};
    expression_values<ball> values(form_.leaves, constant_value<ball>::of(of_.system().point()));
    for (const ball& each : start.states.hull()) {
        values.push_back(each);
    }
    const ball value = values.of(g_);
    start.at_zero = arb_is_zero(value.handle()) != 0;
    start.sign = known_sign(start.at_zero ? values.of(slope_) : value);
    if (start.sign == 0) {
        throw error(error_kind::undecided, error_subject::condition, "",
                    start.at_zero ? "holds at the initial point, and its two sides may touch there"
                                  : "may hold at the initial point of some of the solutions");
    }
    return start;
}

// Rows for the time and the unknowns of the problem, columns for the numbers of the box.
ball_matrix event_question::derivatives_of(const proved_event& event, const ball_matrix& of_start) const {
    const ball_matrix of_state = product(event.flow, of_start);
    expression_values<ball> values(form_.leaves, event.time);
    for (const ball& each : event.state) {
        values.push_back(each);
    }
    const ball slope = values.of(slope_);
    const std::vector<ball> slopes = form_.slopes_at(event.state, event.time);
    ball_matrix rows(1 + of_.own().size(), std::vector<ball>(of_.sets().size(), ball(0)));
    // Of the unknown x in c x + h = 0: h is a function of constant unknowns.
    const auto by_others = [&](std::size_t place, std::size_t j) {
        ball sum(0);
        for (std::size_t k = 0; k < gradient_.size(); ++k) {
            if (k != place && !gradient_[k].is(0)) {
                sum += values.of(gradient_[k]) * of_state[k][j];
            }
        }
        return ball(-sum / constant_value<ball>::of(*coefficient_[place]));
    };
    for (std::size_t j = 0; j < of_.sets().size(); ++j) {
        ball change(0);
        for (std::size_t k = 0; k < gradient_.size(); ++k) {
            change += values.of(gradient_[k]) * of_state[k][j];
        }
        ball& of_time = rows[0][j];
        of_time = known_sign(slope) == 0 ? any_number() : ball(-change / slope);
        for (std::size_t i = 0; i < of_.own().size(); ++i) {
            const std::size_t place = of_.own()[i];
            rows[i + 1][j] =
                coefficient_[place] ? by_others(place, j) : ball(of_state[place][j] + slopes[place] * of_time);
        }
    }
    return rows;
}

set_image event_question::image_of(const proved_event& event, const ball_matrix& of_start,
                                   bool with_derivatives) const {
    set_image image{{bounds_of(event.time)}, {}};
    for (const std::size_t place : of_.own()) {
        image.values.push_back(bounds_of(coefficient_[place] ? by_condition(place, event) : event.state[place]));
    }
    image.derivatives =
        with_derivatives ? derivatives_of(event, of_start) : ball_matrix(image.values.size(), std::vector<ball>{});
    return image;
}

// False if it is not decided whether the event of every solution is before the end.
bool event_question::note_event(const proved_event& event, const ball_matrix& of_start, bool with_derivatives,
                                std::size_t index, set_run_result& result) const {
    if (asked_.before) {
        const ball left = (constant_value<ball>::of(*asked_.before) - event.time) * direction_;
        if (known_sign(lower_bound(left)) < 0) {
            result.complete = false;
            result.reason =
                "is not proved to be before that time for every solution: it is in " + bounds_text(event.time);
            return false;
        }
    }
    result.images[index] = image_of(event, of_start, with_derivatives);
    return true;
}

void event_question::note_end(const zero_search& search, std::size_t index, set_run_result& result) const {
    const std::string found = std::to_string(index);
    result.complete = false;
    switch (search.end()) {
        case search_end::time:
            result.reason = "is not found before that time: " + found + " were found";
            result.may_divide = false;
            break;
        case search_end::horizon:
            result.reason = "is not found within " + std::to_string(search.steps()) + " steps, up to " +
                            proved_reach_text(search.reached(), direction_ >= 0) +
                            ": give an end of the search, or a larger horizon: " + found + " were found";
            result.may_divide = false;
            break;
        case search_end::undecided:
            result.reason = "is not decided: the condition may hold in " +
                            interval_text(search.undecided().from, search.undecided().to);
            break;
        case search_end::none:
        case search_end::steps:
        case search_end::precision:
            result.reason = text_of_reach(search.reached(), search.steps() > 0, direction_ >= 0);
            break;
    }
}

set_run_result event_question::enclosed_from(const number_box& box, bool with_derivatives) const {
    const precision_scope scope(decimal_digits(bits_) + guard_digits);
    set_run_result result;
    result.images.resize(static_cast<std::size_t>(asked_.count));
    result.forward = direction_ >= 0;
    result.reached = constant_value<ball>::of(of_.system().point());
    const ball_matrix of_start = of_.derivative_of_start(box);
    set_start start;
    try {
        start = start_from(box);
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided) {
            throw;
        }
        result.complete = false;
        result.reason = "is not decided: the condition " + problem.reason();
        return result;
    }
    start.keeps_derivative = with_derivatives;
    zero_search search(of_.system(), of_.condition(), start, bits_, direction_, route_for(box, route_), watch_);
    for (std::size_t i = 0; i < result.images.size(); ++i) {
        const auto event = search.next(asked_.way, asked_.before, asked_.horizon);
        if (!event) {
            note_end(search, i, result);
            result.begins = search.steps() > 0;
            result.may_divide = result.may_divide && (result.begins || is_defined_at_corners(of_, box));
        }
        if (!event || !note_event(*event, of_start, with_derivatives, i, result)) {
            result.reached = search.reached();
            if (const auto derivative = search.derivative()) {
                const ball_matrix all = product(*derivative, of_start);
                ball_matrix own;
                for (const std::size_t place : of_.own()) {
                    own.push_back(all[place]);
                }
                result.shares = shares_of(own, box);
            }
            break;
        }
    }
    result.steps = search.steps();
    return result;
}

}  // namespace libration::ode
