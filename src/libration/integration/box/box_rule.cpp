#include "box_rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../../algebra/dense_matrix.hpp"
#include "../../expansion/set_values.hpp"
#include "libration/expansion/coefficient_digits.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/step_limits.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The precision of the slopes.
constexpr long bits_of_slopes = 64;
// log2 of the number of pieces of a step; and of the growth of the radii on one before a second trial of R.
constexpr long log2_of_pieces = 2;
constexpr long log2_of_trial = 3;
constexpr int most_trials = 4;
// The logarithm of the growth of the radii on a step that replaces one on which no r < R is found.
constexpr unsigned long growth_of_step = 8;
// How often a step is halved on which no r < R is found.
constexpr int most_halvings_of_step = 12;
// Radii of theorem T between those that are tried anyway: the time for them is small next to that of a step of many bits.
constexpr std::array<unsigned long, 3> eighths_of_wider_radius{13, 11, 9};
// log2 of the usual length of a step over the radius of its series, 1/e^2.
constexpr double usual_part_of_radius = -3;

// Removes unknowns whose right-hand side does not vanish from those that stay 0. Returns whether there were any.
bool leaves_zero(std::vector<bool>& zero, const std::vector<bool>& vanishing) {
    bool leaves = false;
    for (std::size_t i = 0; i < zero.size(); ++i) {
        leaves = leaves || (zero[i] && !vanishing[i]);
        zero[i] = zero[i] && vanishing[i];
    }
    return leaves;
}

double largest_in(const std::vector<magnitude>& radii, const std::vector<magnitude>& weights) {
    magnitude largest;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        largest = std::max(largest, radii[i] / weights[i]);
    }
    return log_of(largest);
}

}  // namespace

box_rule::box_rule(const polynomial_form& of, const explicit_system& system, const run_bits& bits,
                   const proof_route& route)
    : lifted_(of),
      tape_(tape::about_points(lifted_.system)),
      slopes_(system),
      bits_(bits),
      route_(route),
      scales_({}) {}

void box_rule::begin(const flow_state& start) {
    if (start.derivative) {
        throw error(error_kind::argument, error_subject::integrator, "comparison",
                    "carries no derivative of the flow, which is needed here: use automatic or taylor");
    }
    const precision_scope scope(decimal_digits(bits_.bits));
    scales_ = unknown_scales(start.set.hull());
    origin_ = start.time;
    steps_ = 0;
    growth_ = 0;
    most_length_.reset();
    shape_.clear();
    largest_.clear();
}

next_step box_rule::next(const flow_state& from, const ball& rest) {
    scales_.measure_errors(from.set.errors);
    radii_.clear();
    for (std::size_t i = 0; i < lifted_.given; ++i) {
        radii_.push_back(from.set.reach(i));
    }
    make_expansion(from, rest);
    const auto end_without_step = [&] {
        return next_step{{}, scales_.wide(2 * widest_set) ? stop::precision : stop::step_too_small};
    };
    if (!expand_centre(from)) {
        return end_without_step();
    }
    scales_.measure_sizes(now_->of_centre, tail_->radius);
    if (loses_a_decaying_unknown(from.set.centre)) {
        return {{}, stop::precision};
    }
    scales_.resolve(widest_set);
    weights_.clear();
    for (const long each : scales_.exponents()) {
        weights_.push_back(magnitude::of(1, each));
    }
    double wanted = scales_.longest(visible_tail(), now_->bits, usual_bits_below_set);
    wanted = plan_ ? std::min(wanted, plan_->log_of_length) : wanted;
    const int direction = arb_is_negative(rest.handle()) != 0 ? -1 : 1;
    // Of 16 bits, so that the ends of the pieces are exact.
    magnitude length = power_of_two(log_of(std::min(
        {route_.shortened(power_of_two(wanted)), tail_->radius.shifted(-1), most_length_.value_or(tail_->radius)})));
    const auto series = made_series();
    const magnitude least =
        magnitude(distance_between(from.time, origin_)) * magnitude::of(1, log2_of_least_step(bits_.bits));
    for (int halving = 0; halving <= most_halvings_of_step; ++halving) {
        if (steps_ >= most_series_steps || length <= least) {
            break;
        }
        if (add_pieces(*series, from.time, length, direction)) {
            ++steps_;
            const double before = largest_in(radii_, weights_);
            growth_ = before == nothing ? 0 : largest_in(series->last, weights_) - before;
            most_length_ = halving > 0 ? std::optional(length.shifted(1)) : std::nullopt;
            return {std::make_shared<box_step>(from, series, length.exact() * direction)};
        }
        length = std::min(length.shifted(-1), halving == 0 ? length_by_slopes(from, direction) : length);
    }
    return end_without_step();
}

// An unknown that was distinguished from 0, is not any more, and has been larger than it is now. One that only grows was
// distinguished as long as the errors of the others had not reached it: in a long chain, what the ends cause in the
// middle.
bool box_rule::loses_a_decaying_unknown(const std::vector<ball>& centre) {
    bool loses = false;
    largest_.resize(centre.size(), nothing);
    for (std::size_t i = 0; i < centre.size(); ++i) {
        const unknown_scale& now = scales_[i];
        if (now.reach == nothing || now.reach - now.size < widest_set) {
            largest_[i] = std::max(largest_[i], log_of(magnitude(centre[i])));
        } else if (now.reach - now.size > widest_set) {
            loses = loses || now.size < largest_[i];
            largest_[i] = nothing;
        }
    }
    return loses;
}

void box_rule::make_expansion(const flow_state& from, const ball& rest) {
    const long usual = run_bits::usual_error_bits;
    const long needed =
        std::clamp(scales_.accuracy(bits_.bits) + usual_bits_below_set, usual, std::max(bits_.bits, usual));
    const bool keeps = now_ && needed <= now_->bits && now_->bits <= needed + needed / 8 + 16;
    const long bits = keeps ? now_->bits : std::min(bits_.bits, needed + needed / 16);
    plan_step(from, rest, bits);
    const precision_scope scope(decimal_digits(bits));
    const int order = plan_ ? plan_->order : taylor_order(static_cast<int>(bits)) + 2;
    const int longest = order + route_.more_terms;
    if (!keeps || now_->of_centre.order() < longest || now_->of_centre.order() > longest + longest / 8) {
        now_.reset();  // first, for its memory
        now_.reset(new expansion{bits, taylor_expansion<ball>(tape_, longest, route_.product)});
    }
}

void box_rule::plan_step(const flow_state& from, const ball& rest, long bits) {
    plan_.reset();
    if (bits < least_bits_of_plan) {
        return;
    }
    if (!planner_ || planner_->bits() != bits) {
        planner_ = std::make_unique<step_planner>(tape_, bits);
    }
    const precision_scope few(decimal_digits(bits_of_slopes));
    const auto all = lifted_values(lifted_, from.time, from.set.centre);
    if (all_finite(all)) {
        plan_ = planner_->plan(from.time, all, std::abs(as_double(rest)));
    }
}

// The tail as far as it shows next to the radii of the coefficients at the usual length of a step: an unknown that is much
// smaller than those that it is a difference of has no more digits than they have. For the choice of the length alone.
tail_bound box_rule::visible_tail() const {
    const double distance = log_of(tail_->radius) + usual_part_of_radius;
    tail_bound visible = *tail_;
    for (std::size_t i = 0; i < lifted_.given; ++i) {
        const ball* const a = now_->of_centre.coefficients(static_cast<int>(i));
        double rounding = nothing;
        for (int n = 0; n <= now_->of_centre.order(); ++n) {
            rounding = std::max(rounding, log_of(magnitude::radius_of(a[n])) + n * distance);
        }
        const double hidden = rounding - (scales_[i].size - static_cast<double>(now_->bits));
        if (hidden > 0 && std::isfinite(hidden)) {
            visible.error[i] = visible.error[i].shifted(-static_cast<long>(hidden));
        }
    }
    return visible;
}

// Over which the radii grow by no more than a few bits, by the slopes at the beginning; infinite if there are none.
magnitude box_rule::length_by_slopes(const flow_state& from, int direction) {
    const precision_scope few(decimal_digits(bits_of_slopes));
    const auto slopes = slopes_.over(from.time, from.set.hull(), direction);
    magnitude largest;
    for (std::size_t i = 0; slopes && i < slopes->size(); ++i) {
        magnitude sum = magnitude(slopes->diagonal[i]) * weights_[i];
        for (std::size_t k = slopes->first[i]; k < slopes->first[i + 1]; ++k) {
            sum.add_product(slopes->beside[k], weights_[slopes->columns[k]]);
        }
        largest = std::max(largest, sum / weights_[i]);
    }
    const magnitude length = magnitude(growth_of_step) / largest;
    return length.is_finite() ? power_of_two(log_of(length)) : length;
}

bool box_rule::expand_centre(const flow_state& from) {
    const precision_scope scope(decimal_digits(now_->bits));
    const auto all = lifted_values(lifted_, from.time, from.set.centre);
    if (!all_finite(all)) {
        return false;
    }
    const coefficient_digits fewer(plan_ ? plan_->digits : std::vector<long>());
    now_->of_centre.about(from.time, as_state(all));
    const double log_of_radius = estimated_radius(now_->of_centre, all.size());
    if (!plan_ || log_of_radius == no_radius) {
        tail_ = tail_near(tape_, now_->of_centre, from.time, log_of_radius);
        return tail_.has_value();
    }
    const series_sizes sizes = sizes_of(tape_, now_->of_centre, from.time, now_->of_centre.order());
    const auto bound_at = [&](const magnitude& radius) { return bounded_tail(tape_, sizes, radius); };
    tail_ = first_tail(log_of_radius, bound_at);
    for (std::size_t i = 0; tail_ && i < eighths_of_wider_radius.size(); ++i) {
        if (auto wider = bound_at(tail_->radius * magnitude::of(eighths_of_wider_radius[i], -3))) {
            tail_ = std::move(wider);
            break;
        }
    }
    return tail_.has_value();
}

std::shared_ptr<box_series> box_rule::made_series() const {
    auto series = std::make_shared<box_series>();
    for (std::size_t i = 0; i < lifted_.given; ++i) {
        series->centre.push_back(now_->of_centre.series_of(static_cast<int>(i)));
    }
    series->tail = *tail_;
    series->bits = now_->bits;
    return series;
}

// The radii on all pieces; false if no r < R is found on one of them.
bool box_rule::add_pieces(box_series& series, const ball& time, const magnitude& length, int direction) {
    const precision_scope few(decimal_digits(bits_of_slopes));
    series.pieces.clear();
    series.last = radii_;
    const magnitude of_piece = length.shifted(-log2_of_pieces);
    ball begins(0);
    for (unsigned long k = 1; k <= 1UL << log2_of_pieces; ++k) {
        const ball ends = exact_multiple(of_piece.exact(), k, 0);
        const ball distance = hull(begins, ends) * direction;
        auto found = over_piece(series, {time + distance, distance, of_piece, direction}, series.last);
        if (!found) {
            return false;
        }
        series.pieces.push_back({ends, std::move(found->most)});
        series.last = std::move(found->last);
        begins = ends;
    }
    return true;
}

// A trial of R: a few times the radii, in the scales of the unknowns or in proportion to the radii on the piece before.
std::vector<magnitude> box_rule::first_tube(const std::vector<magnitude>& start) const {
    const double largest = largest_in(start, weights_);
    const magnitude widest = largest == nothing ? magnitude::of(1, -2 * now_->bits)
                                                : power_of_two(largest + static_cast<double>(log2_of_trial));
    magnitude ratio;
    for (std::size_t i = 0; i < shape_.size(); ++i) {
        ratio = std::max(ratio, shape_[i].is_zero() ? magnitude() : start[i] / shape_[i]);
    }
    std::vector<magnitude> tube;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const bool has_shape = i < shape_.size() && !shape_[i].is_zero() && !ratio.is_zero();
        tube.push_back(has_shape ? (shape_[i] * ratio).shifted(log2_of_trial) : weights_[i] * widest);
    }
    return tube;
}

// r on a piece, for an R that it does not reach.
std::optional<grown_radii> box_rule::over_piece(const box_series& series, const piece_of_time& on,
                                                const std::vector<magnitude>& start) {
    const auto middle = series.flow_of_centre(on.distances);
    std::vector<magnitude> tube = first_tube(start);
    std::vector<bool> zero;  // unknowns that stay 0
    for (std::size_t i = 0; i < middle.size(); ++i) {
        zero.push_back(start[i].is_zero() && arb_is_zero(middle[i].handle()) != 0);
    }
    for (int trial = 0; trial < most_trials; ++trial) {
        auto box = middle;
        for (std::size_t i = 0; i < box.size(); ++i) {
            box[i] = zero[i] ? box[i] : widened(box[i], tube[i]);
        }
        auto slopes = slopes_.over(on.times, box, on.direction);
        if (slopes && leaves_zero(zero, slopes->vanishing)) {
            --trial;  // fewer unknowns stay 0 on it
            continue;
        }
        for (std::size_t i = 0; slopes && i < zero.size(); ++i) {
            if (zero[i]) {
                slopes->clear_row(i);
            }
        }
        auto found = slopes ? grown(*slopes, start, on.length, weights_) : std::nullopt;
        if (!found) {
            return std::nullopt;
        }
        bool within = true;
        for (std::size_t i = 0; i < tube.size(); ++i) {
            within = within && (zero[i] || found->most[i] < tube[i]);
        }
        if (within) {
            shape_ = found->most;
            return found;
        }
        for (std::size_t i = 0; i < tube.size(); ++i) {
            tube[i] = std::max(tube[i], found->most[i].shifted(1));
        }
    }
    return std::nullopt;
}

bool box_rule::loses_an_unknown(const std::vector<ball>& hull) const {
    std::vector<ball> centre;
    std::vector<magnitude> reach;
    for (const ball& each : hull) {
        centre.push_back(midpoint_alone(each));
        reach.push_back(magnitude::radius_of(each));
    }
    return scales_.may_be_lost(centre, reach, widest_set);
}

}  // namespace libration::ode
