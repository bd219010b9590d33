#include "set_run.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "../../integration/model/model_range.hpp"
#include "../../integration/model/model_rule.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/integration/integration.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// log2 of the number of pieces of a step on which a solution is enclosed over a span of time, and how often one of them is
// halved.
constexpr long log2_of_pieces = 4;
constexpr int most_halvings_of_piece = 4;

// log2 of the excess of the bounds on a piece, of which there are many, over the range of a set.
constexpr long log2_of_excess_on_pieces = -3;

// Of a piece that is not halved, relative to the width of the enclosures at three of its times.
const magnitude sharp_width = magnitude::of(257, -8);

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

// All unknowns at a distance within a step, exact and not negative, and more narrowly those of the problem for which that
// was necessary.
struct moment {
    ball distance;
    std::vector<ball> values;
    std::vector<std::optional<ball>> narrow;

    const ball& narrowest(std::size_t place) const { return narrow[place] ? *narrow[place] : values[place]; }
};

// The values at the ends of a piece of a step and in its middle.
using piece_moments = std::array<moment*, 3>;

// Bounds of an unknown of the problem on a piece of a step.
struct bounded_value {
    closed_interval bounds;
    bool sharp = false;    ///< hardly wider than the values at the ends and in the middle
    bool extends = false;  ///< beyond the bounds of earlier pieces
};

std::size_t count_of_wide(const number_box& box) {
    return static_cast<std::size_t>(std::ranges::count_if(box, has_width));
}

// A run in one direction.
struct set_run_request {
    const set_problem& of;
    const number_box& box;
    bool with_derivatives;
    bool forward;
    long bits;
    const march_watch& watch;
};

// By any rule.
class set_run {
public:
    set_run(const set_run_request& how, set_run_result& result, flow_state start, std::shared_ptr<step_rule> rule,
            long bits)
        : how_(how),
          result_(result),
          form_(how.of.system()),
          of_start_(how.of.derivative_of_start(how.box)),
          origin_(start.time),
          along_(std::move(start), std::move(rule), origin_, bits, how.watch) {}
    set_run(const set_run&) = delete;
    set_run& operator=(const set_run&) = delete;
    virtual ~set_run() = default;

    // False if the proof ends before the last of the spans.
    bool reaches(std::vector<distance_span>& parts) {
        ball farthest(0);
        for (const distance_span& each : parts) {
            farthest = exactly_less(farthest, each.to) ? each.to : farthest;
        }
        along_.aim(exact_sum(origin_, signed_distance(farthest)));
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

    const ball& reached() const { return along_.reached(); }
    long steps() const { return steps_; }
    virtual std::vector<width_shares> shares_at_end() const = 0;

protected:
    // With respect to the initial state, at a distance within a step; more narrowly at a time than on a piece.
    virtual ball_matrix derivative_of_flow(const step& of, const ball& distance, bool /*at_time*/) const {
        return of.derivative(distance);
    }
    // One of its values with an excess of about 2^log2_of_excess_on_pieces, or in `enough`; std::nullopt if values_at() is
    // as narrow.
    virtual std::optional<ball> narrow_value(const step& /*of*/, std::size_t /*place*/, const ball& /*distance*/,
                                             const std::optional<enough_bounds>& /*enough*/) const {
        return std::nullopt;
    }
    // Of the values at the beginning of the step.
    virtual std::vector<model_excess> excess_at_start(const step& /*of*/) const { return {}; }

    const set_run_request& how() const { return how_; }
    flow_state last() const { return along_.last(); }
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

private:
    ball signed_distance(const ball& distance) const { return how_.forward ? distance : -distance; }

    ball_matrix derivatives_at(const step& of, const ball& distance, bool at_time) const {
        return how_.with_derivatives ? by_box(derivative_of_flow(of, distance, at_time))
                                     : ball_matrix(how_.of.own().size());
    }

    bool takes_step(std::vector<distance_span>& parts) {
        const step* const next = along_[number_];
        if (next == nullptr) {
            return false;
        }
        ++steps_;
        const ball length = abs(next->length());
        const ball end = exact_sum(gone_, length);
        for (distance_span& each : parts) {
            if (!each.done && is_not_beyond(each.from, end)) {
                each.done = is_not_beyond(each.to, end);
                const ball first = exactly_less(gone_, each.from) ? exact_sum(each.from, -gone_) : ball(0);
                enclose(*next, first, each.done ? exact_sum(each.to, -gone_) : length, each.index);
            }
        }
        along_.forget_before(number_++);
        gone_ = end;
        return true;
    }

    // The solutions from one distance to another within a step.
    void enclose(const step& of, const ball& first, const ball& last, std::size_t index) {
        if (!is_long(first, last)) {
            const ball distance = signed_distance(hull(first, last));
            const auto over = of.narrow_values(distance);
            std::vector<closed_interval> values;
            for (const std::size_t place : how_.of.own()) {
                values.push_back({lower_bound(over[place]), upper_bound(over[place])});
            }
            add({values, derivatives_at(of, distance, true), excess_at_start(of)}, index);
            return;
        }
        const ball piece = exact_multiple(exact_sum(last, -first), 1, -log2_of_pieces);
        moment from = moment_at(of, first);
        for (int i = 1; i <= 1 << log2_of_pieces; ++i) {
            moment to = moment_at(of, i == 1 << log2_of_pieces ? last : exact_sum(from.distance, piece));
            enclose_piece(of, from, to, index, most_halvings_of_piece);
            from = std::move(to);
        }
    }

    moment moment_at(const step& of, const ball& distance) const {
        auto values = of.values(signed_distance(distance));
        std::vector<std::optional<ball>> narrow(values.size());
        return {distance, std::move(values), std::move(narrow)};
    }

    // A piece that would extend the bounds is enclosed more narrowly if it can be, and halved if a value may turn on it.
    void enclose_piece(const step& of, moment& first, moment& last, std::size_t index, int halvings) {
        moment middle = moment_at(of, exact_multiple(exact_sum(first.distance, last.distance), 1, -1));
        std::vector<bounded_value> values = bounded(of, {&first, &middle, &last}, index);
        if (halvings > 0 && std::ranges::any_of(values, [](const bounded_value& v) { return v.extends && !v.sharp; })) {
            enclose_piece(of, first, middle, index, halvings - 1);
            enclose_piece(of, middle, last, index, halvings - 1);
            return;
        }
        const ball distance = signed_distance(hull(first.distance, last.distance));
        set_image image{{}, derivatives_at(of, distance, false), excess_at_start(of)};
        for (bounded_value& each : values) {
            image.values.push_back(std::move(each.bounds));
        }
        add(std::move(image), index);
    }

    bool extends(const closed_interval& value, std::size_t k, std::size_t index) const {
        const auto& kept = result_.images[index];
        return !kept || exactly_less(value.lower, kept->values[k].lower) ||
               exactly_less(kept->values[k].upper, value.upper);
    }

    void add(set_image image, std::size_t index) {
        auto& kept = result_.images[index];
        if (!kept) {
            kept = std::move(image);
            return;
        }
        for (std::size_t k = 0; k < image.values.size(); ++k) {
            extend(kept->values[k], image.values[k]);
            for (std::size_t j = 0; j < image.derivatives[k].size(); ++j) {
                kept->derivatives[k][j] = hull(kept->derivatives[k][j], image.derivatives[k][j]);
            }
        }
    }

    // Whether a piece is more than the rounding of one time.
    bool is_long(const ball& first, const ball& last) {
        return exactly_less(exact_sum(first, exact_multiple(last, 1, -along_.bits() / 2)), last);
    }

    std::vector<bounded_value> bounded(const step& of, const piece_moments& at, std::size_t index) {
        const ball distance = signed_distance(hull(at[0]->distance, at[2]->distance));
        const auto over = of.values(distance);
        const auto slopes = form_.slopes_at(over, ball(of.from().time + distance));
        const magnitude half(exact_sum(at[2]->distance, -at[1]->distance));
        std::vector<bounded_value> result;
        for (std::size_t k = 0; k < how_.of.own().size(); ++k) {
            const std::size_t place = how_.of.own()[k];
            bounded_value value = bounded_by(over[place], values_of(at, place), slopes[place], half);
            if (extends(value.bounds, k, index)) {
                const std::optional<enough_bounds> enough = enough_for(k, index);
                narrow_at(of, *at[0], place, enough);
                narrow_at(of, *at[2], place, enough);
                if (known_sign(slopes[place]) == 0) {
                    const magnitude change = magnitude(slopes[place]) * half;
                    narrow_at(of, *at[1], place, enough ? std::optional(enough->before_widening(change)) : enough);
                }
                value.bounds = bounded_by(over[place], narrowest_of(at, place), slopes[place], half).bounds;
                value.extends = extends(value.bounds, k, index);
            }
            result.push_back(std::move(value));
        }
        return result;
    }

    // The bounds of earlier pieces.
    std::optional<enough_bounds> enough_for(std::size_t k, std::size_t index) const {
        const auto& kept = result_.images[index];
        return kept ? std::optional(enough_bounds{kept->values[k].lower, kept->values[k].upper}) : std::nullopt;
    }

    void narrow_at(const step& of, moment& at, std::size_t place, const std::optional<enough_bounds>& enough) const {
        if (!at.narrow[place]) {
            at.narrow[place] = narrow_value(of, place, signed_distance(at.distance), enough);
        }
    }

    static std::array<ball, 3> values_of(const piece_moments& at, std::size_t place) {
        return {at[0]->values[place], at[1]->values[place], at[2]->values[place]};
    }
    static std::array<ball, 3> narrowest_of(const piece_moments& at, std::size_t place) {
        return {at[0]->narrowest(place), at[1]->narrowest(place), at[2]->narrowest(place)};
    }

    // By its enclosures on a piece, at the ends and in the middle. A value whose slope has one sign on the piece has its
    // bounds at the ends. Of others with the slope s in S, |y(t) - y(m)| <= |S| |t - m|, m the middle, also bounds it.
    static bounded_value bounded_by(const ball& over, const std::array<ball, 3>& at, const ball& slope,
                                    const magnitude& half) {
        const ball of_ends = hull(at[0], at[2]);
        const bool monotone = known_sign(slope) != 0;
        const ball near = monotone ? of_ends : widened(at[1], magnitude(slope) * half);
        bounded_value value{{lower_bound(over), upper_bound(over)}};
        narrow(value.bounds, {lower_bound(near), upper_bound(near)});
        const magnitude attained = magnitude::radius_of(hull(of_ends, at[1])) * sharp_width;
        value.sharp = monotone || radius_of(value.bounds) < attained;
        return value;
    }

    set_run_request how_;
    set_run_result& result_;
    first_order_form form_;
    ball_matrix of_start_;
    ball origin_;
    integration along_;
    std::size_t number_ = 0;  // of the next step
    ball gone_{0};            // the distance at its beginning
    long steps_ = 0;
};

// By theorem V.
class linear_run : public set_run {
public:
    linear_run(const set_run_request& how, set_run_result& result, const proof_route& route)
        : set_run(how, result, start_of_box(how),
                  rule_for(how.of.system(), {how.bits}, route, error_weights::any_width), how.bits) {}

    std::vector<width_shares> shares_at_end() const override {
        const auto derivative = last().derivative;
        return derivative ? shares_of(by_box(*derivative), how().box) : std::vector<width_shares>();
    }

private:
    static flow_state start_of_box(const set_run_request& how) {
        flow_state start{start_of(how.of.system(), how.bits).time, how.of.states_of(how.box), {}, {}};
        if (how.with_derivatives) {
            start.derivative = unit_derivative(start.set.centre.size());
        }
        return start;
    }
};

// By Taylor models.
class model_run : public set_run {
public:
    model_run(const set_run_request& how, set_run_result& result)
        : model_run(how, result, std::make_shared<model_rule>(how.of.system(), count_of_wide(how.box))) {}

    std::vector<width_shares> shares_at_end() const override {
        std::vector<width_shares> result;
        const flow_state end = last();
        if (const model_state* const at = model_state::of(end)) {
            for (const std::size_t place : how().of.own()) {
                result.push_back(shares_in(at->set.models[place]));
            }
        }
        return result;
    }

protected:
    ball_matrix derivative_of_flow(const step& of, const ball& distance, bool at_time) const override {
        return at_time ? dynamic_cast<const model_step&>(of).narrow_derivative(distance) : of.derivative(distance);
    }
    std::optional<ball> narrow_value(const step& of, std::size_t place, const ball& distance,
                                     const std::optional<enough_bounds>& enough) const override {
        return dynamic_cast<const model_step&>(of).narrow_value(place, distance, log2_of_excess_on_pieces, enough);
    }
    std::vector<model_excess> excess_at_start(const step& of) const override {
        std::vector<model_excess> result;
        const model_set& set = model_state::of(of.from())->set;
        for (const std::size_t place : how().of.own()) {
            result.push_back({set.reach(place).shifted(1), shares_in(set.models[place])});
        }
        return result;
    }

private:
    model_run(const set_run_request& how, set_run_result& result, const std::shared_ptr<model_rule>& rule)
        : set_run(how, result, rule->start_from(how.of.states_of(how.box)), rule, model_rule::working_bits) {}

    // By the terms of a model that are not linear.
    width_shares shares_in(const taylor_model& model) const {
        width_shares result;
        std::size_t variable = 0;
        for (const closed_interval& each : how().box) {
            result.push_back(has_width(each) ? model.nonlinear_share(variable++) : magnitude());
        }
        return result;
    }
};

}  // namespace

bool span_question::has_spans() const { return !std::ranges::all_of(spans_, is_time); }

set_run_result span_question::enclosed_from(const number_box& box, bool with_derivatives) const {
    return linear_from(box, with_derivatives, true);
}

set_run_result span_question::enclosed_at_times(const number_box& box, bool with_derivatives) const {
    return linear_from(box, with_derivatives, false);
}

set_run_result span_question::linear_from(const number_box& box, bool with_derivatives, bool with_spans) const {
    return enclosed_by(box, with_derivatives, with_spans, [&](const set_run_request& how, set_run_result& result) {
        return std::make_unique<linear_run>(how, result, route_for(box, route_));
    });
}

std::optional<set_run_result> span_question::enclosed_by_models(const number_box& box, bool with_derivatives) const {
    if (const std::size_t wide = count_of_wide(box); wide == 0 || wide > model_rule::most_variables) {
        return std::nullopt;
    }
    return enclosed_by(box, with_derivatives, true, [](const set_run_request& how, set_run_result& result) {
        return std::make_unique<model_run>(how, result);
    });
}

template <class MakeRun>
set_run_result span_question::enclosed_by(const number_box& box, bool with_derivatives, bool with_spans,
                                          const MakeRun& make) const {
    const precision_scope scope(decimal_digits(bits_) + guard_digits_of_run);
    set_run_result result;
    result.images.resize(spans_.size());
    for (const bool forward : {true, false}) {
        std::vector<distance_span> parts;
        for (std::size_t i = 0; i < spans_.size(); ++i) {
            if (!with_spans && !is_time(spans_[i])) {
                continue;
            }
            if (auto part = part_of(spans_[i], i, of_.system().point(), forward)) {
                parts.push_back(std::move(*part));
            }
        }
        if (parts.empty()) {
            continue;
        }
        const std::unique_ptr<set_run> run = make({of_, box, with_derivatives, forward, bits_, watch_}, result);
        const bool reaches = run->reaches(parts);
        result.steps += run->steps();
        if (!reaches && result.complete) {
            result.complete = false;
            result.reached = run->reached();
            result.begins = run->steps() > 0;
            result.may_divide = result.begins || is_defined_at_corners(of_, box);
            result.forward = forward;
            result.shares = run->shares_at_end();
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
