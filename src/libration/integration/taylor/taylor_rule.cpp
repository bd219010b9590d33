#include "taylor_rule.hpp"

#include <algorithm>
#include <utility>

#include "../../expansion/set_values.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/step_limits.hpp"
#include "libration/integration/taylor/taylor_march.hpp"

namespace libration::ode {

namespace {

// The bits of the error map that its truncation need not preserve.
constexpr long bits_below_truncation = 40;
// log2 of the factor by which the error map shortens a step that justifies more terms.
constexpr double worth_more_terms = 0.3;
// The bits of the error map that its largest terms may lose before its precision is increased.
constexpr double bits_to_lose = 16;
// log2 of the uncertainty of the error map from which on shorter steps pay off, of the factor by which it may grow
// more than the length of the step, and how often that is halved.
constexpr double significant_uncertainty = -12;
constexpr double excess_growth = 0.3;
constexpr int most_halvings_for_width = 5;

// The set in the scales of the unknowns, or its box if that is far less wide: if the scales differ by more than the
// precision of the frame, columns that are not along the axes lose the smaller unknowns.
lohner_set settled_or_box(const lohner_set& errors, const std::vector<long>& scales) {
    constexpr long bits_lost = 8;
    lohner_set settled = errors.settled(scales);
    std::vector<magnitude> box;
    magnitude largest;  // so that noise in an unknown that has hardly any error does not count
    for (std::size_t i = 0; i < errors.size(); ++i) {
        box.push_back(errors.reach(i));
        largest = std::max(largest, box.back());
    }
    bool is_lost = false;
    for (std::size_t i = 0; i < box.size(); ++i) {
        is_lost = is_lost || largest.shifted(bits_lost) < settled.reach(i);
    }
    return is_lost ? lohner_set(std::move(box)) : settled;
}

// A set of many unknowns is not wrapped in another frame in so many steps, as long as what the steps add is this number
// of bits below it: each frame costs a part of a bit.
constexpr int most_unsettled_steps = 32;
constexpr long bits_below_columns = 8;

int first_set_order(const run_bits& bits, const proof_route& route) {
    return taylor_order(static_cast<int>(bits.error_bits)) - 2 + route.more_terms;
}

}  // namespace

taylor_rule::taylor_rule(const polynomial_form& of, const run_bits& bits, const proof_route& route,
                         error_weights weights)
    : lifted_(of),
      tape_(tape::about_points(lifted_.system)),
      varied_(lifted_),
      bits_(bits),
      route_(route),
      weights_(weights),
      set_order_(first_set_order(bits, route)),
      scales_({}),
      set_bits_(bits.error_bits) {}

void taylor_rule::begin(const flow_state& start) {
    const precision_scope scope(decimal_digits(bits_.bits));
    set_order_ = first_set_order(bits_, route_);
    set_bits_ = bits_.error_bits;
    scales_ = unknown_scales(start.set.hull());
    switch (weights_) {
        case error_weights::relative: break;
        case error_weights::absolute: scales_.weigh_by_errors(); break;
        case error_weights::any_width: scales_.accept_any_width(); break;
    }
    if (start.derivative) {
        scales_.weigh_by_scales();
    }
    origin_ = start.time;
    steps_ = 0;
    unsettled_ = most_unsettled_steps;
}

next_step taylor_rule::next(const flow_state& from, const ball& rest) {
    time_ = from.time;
    set_ = from.set;
    scales_.measure_errors(set_.errors);
    make_expansions();
    if (!expand_centre()) {
        return {{}, end_without_bounds()};
    }
    scales_.measure_sizes(now_->of_centre, tail_->radius);
    if (scales_.lost(widest_set)) {
        return {{}, stop::precision};
    }
    scales_.resolve(widest_set);
    double growth = 0;
    if (!expand_set()) {
        return {{}, end_without_bounds()};
    }
    const double wanted = wanted_length(growth);
    // A contracting map may need more bits.
    const long bits = bits_.error_bits + static_cast<long>(2 * growth - bits_to_lose);
    if (bits > set_bits_) {
        set_bits_ = bits + usual_bits_below_set;
        if (!expand_set()) {
            return {{}, end_without_bounds()};
        }
    }
    const auto series = made_series();
    // Within both radii, also if that of the variations has become less with more bits.
    magnitude length =
        std::min({route_.shortened(power_of_two(wanted)), tail_->radius.shifted(-1), set_tail_->radius.shifted(-1)});
    if (scales_.accepts_any_width()) {
        length = shortened_for_width(*series, length);
    }
    series->length = length;
    if (steps_ >= most_series_steps ||
        length <= magnitude(distance_between(time_, origin_)) * magnitude::of(1, log2_of_least_step(bits_.bits))) {
        return {{}, stop::step_too_small};
    }
    ++steps_;
    const int direction = arb_is_negative(rest.handle()) != 0 ? -1 : 1;
    return {std::make_shared<series_step>(flow_state{time_, set_, from.derivative, {}}, series,
                                          length.exact() * direction)};
}

// No radius was found; a narrow set is not the reason.
stop taylor_rule::end_without_bounds() const {
    return scales_.wide(2 * widest_set) ? stop::precision : stop::step_too_small;
}

void taylor_rule::make_expansions() {
    const long usual = run_bits::usual_error_bits;
    const long bits =
        std::clamp(scales_.accuracy(bits_.bits) + usual_bits_below_set, usual, std::max(bits_.bits, usual));
    if (!now_ || bits > now_->bits || now_->bits > bits + bits / 8 + 16 || now_->of_set.order() != set_order_) {
        const long some_more = std::min(bits_.bits, bits + bits / 16);
        const precision_scope scope(decimal_digits(some_more));
        const int order = taylor_order(static_cast<int>(some_more)) + 2 + route_.more_terms;
        now_.reset(new expansions{some_more, taylor_expansion<ball>(tape_, order, route_.product),
                                  set_expansion(varied_, set_order_, route_.product)});
    }
}

// The series of the centre, and its remainder.
bool taylor_rule::expand_centre() {
    const precision_scope scope(decimal_digits(now_->bits));
    const auto all = lifted_values(lifted_, time_, set_.centre);
    if (!all_finite(all)) {
        return false;
    }
    now_->of_centre.about(time_, as_state(all));
    log_of_radius_ = estimated_radius(now_->of_centre, all.size());
    // At an equilibrium only the variations have a finite radius.
    if (log_of_radius_ == no_radius && expand_variations()) {
        log_of_radius_ = now_->of_set.estimated_radius();
    }
    tail_ = tail_near(tape_, now_->of_centre, time_, log_of_radius_);
    return tail_.has_value();
}

// The series of the set with its variations, in low precision, and their remainders.
bool taylor_rule::expand_set() {
    const precision_scope few(decimal_digits(set_bits_));
    if (settles()) {
        set_.errors = settled_or_box(set_.errors, scales_.exponents());
    }
    if (!expand_variations()) {
        return false;
    }
    const double radius = std::min(log_of_radius_, now_->of_set.estimated_radius());
    set_tail_ = now_->of_set.tail(time_, radius);
    return set_tail_.has_value();
}

// Whether the set gets another frame before this step.
bool taylor_rule::settles() {
    const lohner_set& errors = set_.errors;
    const bool is_parallelepiped = errors.columns().size() == errors.size() && varied_.jacobian() != nullptr;
    if (!is_parallelepiped || scales_.accepts_any_width() || ++unsettled_ > most_unsettled_steps) {
        unsettled_ = 0;
        return true;
    }
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (!(errors.added()[i].shifted(bits_below_columns) <= errors.reach(i))) {
            unsettled_ = 0;
            return true;
        }
    }
    return false;
}

bool taylor_rule::expand_variations() {
    const precision_scope few(decimal_digits(set_bits_));
    return now_->of_set.about(time_, set_.hull());
}

std::shared_ptr<taylor_series> taylor_rule::made_series() const {
    auto series = std::make_shared<taylor_series>();
    series->places = varied_.places();
    for (std::size_t i = 0; i < lifted_.given; ++i) {
        series->centre.push_back(now_->of_centre.series_of(static_cast<int>(i)));
        auto& row = series->variations.emplace_back();
        for (std::size_t j = 0; j < lifted_.given; ++j) {
            const ball* const first = now_->of_set.coefficients(i, j);
            row.emplace_back(std::vector<ball>(first, first + now_->of_set.order() + 1));
        }
    }
    series->tail = *tail_;
    series->set_tail = *set_tail_;
    series->bits = now_->bits;
    series->set_bits = set_bits_;
    series->errors = set_.errors;
    return series;
}

// log2 of the longest step with a tail below the last bits of each unknown and small in the error map; any length is
// valid. `growth` is that of the terms of the map.
double taylor_rule::wanted_length(double& growth) {
    const variation_places places = varied_.places();
    const auto wanted = static_cast<double>(bits_below_truncation - bits_.error_bits);
    const double of_centre = scales_.longest(*tail_, now_->bits, usual_bits_below_set);
    const double at_first = std::min(of_centre, longest_for_map(*set_tail_, scales_, places, wanted));
    growth = growth_of_terms(now_->of_set, scales_, places.given, at_first);
    const double of_set = longest_for_map(*set_tail_, scales_, places, wanted - growth);
    // If the flow contracts much faster than the solution moves, the error map needs more terms and bits.
    if (of_set + worth_more_terms < of_centre) {
        set_order_ = std::min(set_order_ + set_order_ / 4, now_->of_centre.order());
    }
    return std::min(at_first, of_set);
}

// The derivative over a wide set is enclosed the less sharply the longer the step is: until its uncertainty grows about
// as the length.
magnitude taylor_rule::shortened_for_width(const taylor_series& series, magnitude length) const {
    const auto uncertainty = [&](const magnitude& at) {
        const ball_matrix map = series.derivative_of_flow(at.exact());
        double most = nothing;
        for (std::size_t i = 0; i < map.size(); ++i) {
            for (std::size_t j = 0; j < map.size(); ++j) {
                const double scale = scales_[j].scale - scales_[i].scale;
                most = std::max(most, log_of(magnitude::radius_of(map[i][j])) + scale);
            }
        }
        return most;
    };
    double now = uncertainty(length);
    for (int halving = 0; halving < most_halvings_for_width && now > significant_uncertainty; ++halving) {
        const magnitude half = length.shifted(-1);
        const double then = uncertainty(half);
        if (now - then < 1 + excess_growth) {
            break;
        }
        length = half;
        now = then;
    }
    return length;
}

bool taylor_rule::loses_an_unknown(const std::vector<ball>& hull) const {
    std::vector<ball> centre;
    std::vector<magnitude> reach;
    for (const ball& each : hull) {
        centre.push_back(midpoint_alone(each));
        reach.push_back(magnitude::radius_of(each));
    }
    return scales_.may_be_lost(centre, reach, widest_set);
}

}  // namespace libration::ode
