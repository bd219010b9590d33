#include "set_run.hpp"

#include <algorithm>
#include <utility>

#include "libration/ode/first_order_form.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// log2 of the number of pieces of a step on which a solution is enclosed over a span of time, and how often one of them is
// halved.
constexpr long log2_of_pieces = 4;
constexpr int most_halvings = 4;

// Of the working precision, besides the bits of the integration.
constexpr long guard_digits_of_run = 20;

bool is_not_beyond(const ball& a, const ball& b) { return !exactly_less(b, a); }

// Distances from the initial point in the direction of a run, exact, 0 <= from <= to.
struct distance_span {
    std::size_t index;
    ball from, to;
    bool done = false;
};

// The part of a span in a direction; std::nullopt if it is on the other side. The initial point belongs to forward.
std::optional<distance_span> part_of(const time_span& span, std::size_t index, const number& point, bool forward) {
    const ball from = constant_value<ball>::of(span.from - point) * (forward ? 1 : -1);
    const ball to = constant_value<ball>::of(span.to - point) * (forward ? 1 : -1);
    const ball nearest = lower_bound(forward ? from : to);
    const ball farthest = upper_bound(forward ? to : from);
    const int side = known_sign(farthest);
    if (side < 0 || (side == 0 && !forward)) {
        return std::nullopt;
    }
    return distance_span{index, known_sign(nearest) > 0 ? nearest : ball(0), farthest};
}

// Bounds of the unknowns of the problem on a piece of a step.
struct enclosed_piece {
    std::vector<closed_interval> values;
    std::vector<bool> monotone;  ///< in time
};

// A run in one direction.
struct span_run_request {
    const set_problem& of;
    long bits;
    bool with_derivatives;
    const march_watch& watch;
    const proof_route& route;
};

class set_run {
public:
    set_run(const number_box& box, const span_run_request& how, bool forward, set_run_result& result)
        : how_(how),
          result_(result),
          forward_(forward),
          form_(how.of.system()),
          of_start_(how.of.derivative_of_start(box)),
          march_(how.of.system(), how.of.states_of(box), how.bits, how.watch, route_for(box, how.route)) {
        if (how.with_derivatives) {
            march_.keep_derivative();
        }
    }

    // False if the proof ends before the last of the spans.
    bool reaches(std::vector<distance_span>& parts) {
        try {
            while (!std::ranges::all_of(parts, &distance_span::done)) {
                if (!takes_step(parts)) {
                    return false;
                }
            }
            return true;
        } catch (const precision_exhausted&) {
            return false;
        }
    }

    ball reached() const { return march_.reached(); }
    long steps() const { return steps_; }
    // With respect to the numbers of the box, at reached(); empty if they are not requested.
    ball_matrix derivatives_at_end() const {
        return march_.derivative() ? by_box(*march_.derivative()) : ball_matrix();
    }

private:
    ball signed_distance(const ball& distance) const { return forward_ ? distance : -distance; }

    bool takes_step(std::vector<distance_span>& parts) {
        ball farthest = gone_;
        for (const distance_span& each : parts) {
            farthest = exactly_less(farthest, each.to) ? each.to : farthest;
        }
        const ball rest = signed_distance(exact_sum(farthest, -gone_));
        const enclosed_step* const step = march_.prepare_towards(rest);
        if (step == nullptr) {
            return false;
        }
        ++steps_;
        const ball length = step->length_of_step();
        const ball end = exact_sum(gone_, length);
        for (distance_span& each : parts) {
            if (!each.done && is_not_beyond(each.from, end)) {
                each.done = is_not_beyond(each.to, end);
                const ball first = exactly_less(gone_, each.from) ? exact_sum(each.from, -gone_) : ball(0);
                enclose(*step, first, each.done ? exact_sum(each.to, -gone_) : length, each.index);
            }
        }
        if (is_not_beyond(farthest, end)) {
            march_.use_prepared(march_.reached() + rest, forward_ ? 1 : -1);
        } else {
            march_.take_prepared(forward_ ? 1 : -1);
            gone_ = end;
        }
        return true;
    }

    // The solutions from one distance to another within a step.
    void enclose(const enclosed_step& step, const ball& first, const ball& last, std::size_t index) {
        if (!is_long(first, last)) {
            const auto over = step.values_at(signed_distance(hull(first, last)));
            std::vector<closed_interval> values;
            for (const std::size_t place : how_.of.own()) {
                values.push_back({lower_bound(over[place]), upper_bound(over[place])});
            }
            add(values, derivatives_at(signed_distance(hull(first, last))), index);
            return;
        }
        const ball piece = exact_multiple(exact_sum(last, -first), 1, -log2_of_pieces);
        ball from = first;
        for (int i = 1; i < 1 << log2_of_pieces; ++i) {
            const ball to = exact_sum(from, piece);
            enclose_piece(step, from, to, index, most_halvings);
            from = to;
        }
        enclose_piece(step, from, last, index, most_halvings);
    }

    // A piece on which a value may turn, and which would extend its bounds, is halved.
    void enclose_piece(const enclosed_step& step, const ball& first, const ball& last, std::size_t index,
                       int halvings) {
        const enclosed_piece piece = narrowed(step, first, last);
        if (halvings > 0 && extends(piece, index)) {
            const ball middle = exact_multiple(exact_sum(first, last), 1, -1);
            enclose_piece(step, first, middle, index, halvings - 1);
            enclose_piece(step, middle, last, index, halvings - 1);
            return;
        }
        add(piece.values, derivatives_at(signed_distance(hull(first, last))), index);
    }

    bool extends(const enclosed_piece& piece, std::size_t index) const {
        const auto& kept = result_.images[index];
        for (std::size_t k = 0; k < piece.values.size(); ++k) {
            if (!piece.monotone[k] && (!kept || exactly_less(piece.values[k].lower, kept->values[k].lower) ||
                                       exactly_less(kept->values[k].upper, piece.values[k].upper))) {
                return true;
            }
        }
        return false;
    }

    void add(const std::vector<closed_interval>& values, const ball_matrix& derivatives, std::size_t index) {
        auto& kept = result_.images[index];
        if (!kept) {
            kept = set_image{values, derivatives};
            return;
        }
        for (std::size_t k = 0; k < values.size(); ++k) {
            extend(kept->values[k], values[k]);
            for (std::size_t j = 0; j < derivatives[k].size(); ++j) {
                kept->derivatives[k][j] = hull(kept->derivatives[k][j], derivatives[k][j]);
            }
        }
    }

    // Whether a piece is more than the rounding of one time.
    bool is_long(const ball& first, const ball& last) const {
        return exactly_less(exact_sum(first, exact_multiple(last, 1, -how_.bits / 2)), last);
    }

    // A value whose slope has one sign on a piece has its bounds at the ends. Of others with the slope s in S, |y(t) -
    // y(m)| <= |S| |t - m|, m the middle, also bounds it.
    enclosed_piece narrowed(const enclosed_step& step, const ball& first, const ball& last) const {
        const ball middle = exact_multiple(exact_sum(first, last), 1, -1);
        const ball distance = signed_distance(hull(first, last));
        const auto over = step.values_at(distance);
        const auto slopes = form_.slopes_at(over, ball(march_.reached() + distance));
        const auto at_first = step.values_at(signed_distance(first));
        const auto at_middle = step.values_at(signed_distance(middle));
        const auto at_last = step.values_at(signed_distance(last));
        const magnitude half(exact_sum(last, -middle));
        enclosed_piece result;
        for (const std::size_t place : how_.of.own()) {
            closed_interval each{lower_bound(over[place]), upper_bound(over[place])};
            result.monotone.push_back(known_sign(slopes[place]) != 0);
            const ball near = result.monotone.back() ? hull(at_first[place], at_last[place])
                                                     : widened(at_middle[place], magnitude(slopes[place]) * half);
            if (const ball lower = lower_bound(near); exactly_less(each.lower, lower)) each.lower = lower;
            if (const ball upper = upper_bound(near); exactly_less(upper, each.upper)) each.upper = upper;
            result.values.push_back(std::move(each));
        }
        return result;
    }

    // At a distance within the step.
    ball_matrix derivatives_at(const ball& distance) const {
        return how_.with_derivatives ? by_box(march_.derivative_at(march_.reached() + distance))
                                     : ball_matrix(how_.of.own().size());
    }

    // With respect to the numbers of the box, from that with respect to the initial state.
    ball_matrix by_box(const ball_matrix& of_flow) const {
        ball_matrix result;
        for (const std::size_t place : how_.of.own()) {
            auto& row = result.emplace_back(how_.of.sets().size(), ball(0));
            for (std::size_t j = 0; j < row.size(); ++j) {
                for (std::size_t i = 0; i < of_start_.size(); ++i) {
                    row[j] += of_flow[place][i] * of_start_[i][j];
                }
            }
        }
        return result;
    }

    const span_run_request& how_;
    set_run_result& result_;
    bool forward_;
    first_order_form form_;
    ball_matrix of_start_;
    proved_march march_;
    ball gone_{0};  // the distance at the beginning of the next step
    long steps_ = 0;
};

}  // namespace

set_run_result span_question::enclosed_from(const number_box& box, bool with_derivatives) const {
    const precision_scope scope(decimal_digits(bits_) + guard_digits_of_run);
    const span_run_request how{of_, bits_, with_derivatives, watch_, route_};
    set_run_result result;
    result.images.resize(spans_.size());
    for (const bool forward : {true, false}) {
        std::vector<distance_span> parts;
        for (std::size_t i = 0; i < spans_.size(); ++i) {
            if (auto part = part_of(spans_[i], i, of_.system().point(), forward)) {
                parts.push_back(std::move(*part));
            }
        }
        if (parts.empty()) {
            continue;
        }
        set_run run(box, how, forward, result);
        const bool reaches = run.reaches(parts);
        result.steps += run.steps();
        if (!reaches && result.complete) {
            result.complete = false;
            result.reached = run.reached();
            result.forward = forward;
            result.derivatives = run.derivatives_at_end();
        }
        for (const distance_span& each : parts) {
            if (!each.done) {
                result.images[each.index].reset();
            }
        }
    }
    return result;
}

}  // namespace libration::ode
