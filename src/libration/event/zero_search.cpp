#include "libration/event/zero_search.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "exact_zero.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

constexpr int first_pieces = 4;
constexpr long few_digits = 20;  // the initial precision in which pieces are examined

// The derivatives with respect to the leaves, and to the variable.
std::vector<expression> gradient_of(const first_order_form& form, const expression& g) {
    std::vector<expression> derivatives;
    for (const expression& each : form.leaves) {
        derivatives.push_back(partial(g, each));
    }
    derivatives.push_back(partial(g, variable()));
    return derivatives;
}

std::shared_ptr<integration> steps_from(flow_state start, const explicit_system& system, long bits, int direction,
                                        const proof_route& route, error_weights weights) {
    return std::make_shared<integration>(std::move(start), rule_for(system, {bits}, route, weights),
                                         infinite_distance(direction), bits);
}

flow_state state_at_start(const explicit_system& system, const set_start& start, long bits) {
    flow_state state{start_of(system, bits).time, start.states, {}, {}};
    if (start.keeps_derivative) {
        state.derivative = unit_derivative(start.states.centre.size());
    }
    return state;
}

}  // namespace

// Along its own steps or others.
zero_search::zero_search(const explicit_system& system, const expression& g, std::shared_ptr<integration> own,
                         step_sequence* along, long bits, int direction, march_watch watch)
    : form_(system),
      g_(form_.in_leaves(g)),
      slope_(form_.slope_of(g_)),
      gradient_(gradient_of(form_, g_)),
      own_(std::move(own)),
      along_(own_ ? *own_ : *along),
      bits_(bits),
      digits_(decimal_digits(bits) + 10),
      direction_(direction < 0 ? -1 : 1),
      watch_(std::move(watch)),
      time_(start_of(system, bits).time) {}

zero_search::zero_search(const explicit_system& system, const expression& g, long bits, int direction,
                         const proof_route& route, march_watch watch)
    : zero_search(system, g,
                  steps_from(start_of(system, bits), system, bits, direction, route, error_weights::relative), nullptr,
                  bits, direction, std::move(watch)) {
    const precision_scope scope(digits_);
    system.singular() ? begin_at_singular(start_of(system, bits)) : begin_at(system.point());
}

zero_search::zero_search(const explicit_system& system, const expression& g, const kept_part& kept, long bits,
                         int direction, const proof_route& route, march_watch watch)
    : zero_search(system, g, kept.steps->along(kept.part, system, bits, direction, route), nullptr, bits, direction,
                  std::move(watch)) {
    kept_ = kept.steps;
    bits_ = own_->bits();
    digits_ = decimal_digits(bits_) + 10;
    const precision_scope scope(digits_);
    system.singular() ? begin_at_singular(own_->start()) : begin_at(system.point());
}

zero_search::zero_search(const explicit_system& system, const expression& g, const set_start& start, long bits,
                         int direction, const proof_route& route, march_watch watch)
    : zero_search(
          system, g,
          steps_from(state_at_start(system, start, bits), system, bits, direction, route, error_weights::any_width),
          nullptr, bits, direction, std::move(watch)) {
    start_ = {start.at_zero ? 1 : 0, start.sign, start.at_zero ? slope_ : g_};
    sign_ = start_.beside(direction_);
}

zero_search::zero_search(const explicit_system& system, const expression& g, step_sequence& along, long bits,
                         march_watch watch)
    : zero_search(system, g, nullptr, &along, bits, 1, std::move(watch)) {
    const precision_scope scope(digits_);
    begin_at(system.point());
}

zero_search::zero_search(const explicit_system& system, const expression& g, step_sequence& along,
                         const search_start& start, long bits)
    : zero_search(system, g, nullptr, &along, bits, 1, {}) {
    start_ = {start.order, start.sign, g_};
    for (int k = 0; k < start.order; ++k) {
        start_.leading = form_.slope_of(start_.leading);
    }
    sign_ = start.sign;
    if (start.begins) {
        after_ = upper_bound(*start.begins);
    }
}

void zero_search::begin_at(const number& point) {
    start_ = sign_at_start(form_, g_, slope_, point);
    sign_ = start_.beside(direction_);
}

void zero_search::begin_at_singular(const flow_state& start) {
    if (direction_ < 0) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "has a singular initial point, and events are searched only after it");
    }
    expression_values<ball> values(form_.leaves, start.time);
    for (const ball& each : start.set.hull()) {
        values.push_back(each);
    }
    sign_ = known_sign(values.of(g_));
    if (sign_ == 0) {
        throw error(error_kind::undecided, "event", "",
                    "is not excluded within the first step from the initial point, where the equation is singular");
    }
}

std::optional<ball_matrix> zero_search::derivative() {
    if (step_ != nullptr) {
        return step_->from().derivative;
    }
    return own_->last().derivative;
}

const expression& zero_search::curvature() {
    if (!curvature_) {
        curvature_ = form_.slope_of(slope_);
    }
    return *curvature_;
}

// The values of expressions in leaves at a distance.
expression_values<ball> zero_search::values_at(const ball& distance) const {
    expression_values<ball> values(form_.leaves, time_ + distance);
    for (const ball& each : own_ ? step_->values(distance) : step_->shared_values(distance)) {
        values.push_back(each);
    }
    return values;
}

zero_search::sample zero_search::sampled(const ball& distance) const {
    auto values = values_at(distance);
    return {values.of(g_), slope_at(distance, values), values.values()};
}

// gamma' at the values at a distance.
ball zero_search::slope_at(const ball& distance, expression_values<ball>& values) const {
    const std::vector<ball> slopes = step_->slopes(distance);
    if (slopes.empty()) {
        return values.of(slope_);
    }
    ball sum = values.of(gradient_.back());
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        if (!gradient_[i].is(0)) {
            sum += values.of(gradient_[i]) * slopes[i];
        }
    }
    return sum;
}

// The sign of g at an exact distance; 0 if it is undecided.
int zero_search::sign_at(const ball& distance) const {
    const auto sign = [&] { return known_sign(of_state(g_, distance * direction_)); };
    {
        const precision_scope few(few_digits);
        if (const int known = sign(); known != 0) return known;
    }
    return sign();
}

std::optional<proved_event> zero_search::at_start() const {
    if (start_.order == 0) {
        return std::nullopt;
    }
    proved_event event{time_, {}, crossing::any};
    for (const number& each : form_.starts) {
        event.state.push_back(constant_value<ball>::of(each));
    }
    if (start_.order % 2 != 0) {
        event.way = start_.sign > 0 ? crossing::up : crossing::down;
    }
    return event;
}

// The direction of t in which g crosses 0 next.
crossing zero_search::way_of_next() const { return sign_ * direction_ < 0 ? crossing::up : crossing::down; }

double zero_search::distance_by_tangent() const {
    const precision_scope few(few_digits);
    const step* const next = along_[number_];
    if (next == nullptr) {
        return std::numeric_limits<double>::infinity();
    }
    expression_values<ball> values(form_.leaves, next->from().time);
    for (const ball& each : next->shared_values(ball(0))) {
        values.push_back(each);
    }
    const double distance = -as_double(values.of(g_) / values.of(slope_)) * direction_;
    return distance > 0 ? distance : std::numeric_limits<double>::infinity();
}

// Whether a piece from the initial point contains the whole ball in which a search from a set begins.
bool zero_search::covers_beginning(const step_piece& p) const {
    return !after_ || !exactly_less(lower_bound(time_ + p.to), *after_);
}

// No zero except at the initial point: gamma^(k) excludes 0 on the piece.
zero_search::verdict zero_search::judged_at_start(const step_piece& p) {
    const ball span = span_of(p);
    const bool covered = covers_beginning(p);
    if (covered && is_finite(of_state(g_, span)) && known_sign(of_state(start_.leading, span)) != 0) {
        return {finding::no_zero, sign_};
    }
    return !covered || p.is_narrow(bits_) ? undecided_on(p, sampled(span)) : verdict{finding::open, 0};
}

zero_search::verdict zero_search::undecided_on(const step_piece& p, const sample& all) {
    const ball& first = direction_ > 0 ? p.from : p.to;
    const ball& last = direction_ > 0 ? p.to : p.from;
    undecided_ = {lower_bound(time_ + first * direction_), upper_bound(time_ + last * direction_), magnitude(all.value),
                  magnitude(all.slope)};
    return {finding::undecided, 0};
}

zero_search::verdict zero_search::judged(step_piece& p) {
    const precision_scope scope(p.digits);
    const ball span = span_of(p);
    sample all = sampled(span);
    if (const int sign = known_sign(all.value); sign != 0) {
        return {finding::no_zero, sign};
    }
    if (!is_finite(all.value)) {  // while folding may leave a slope
        const bool ends = p.is_narrow(bits_) || ++examined_ > most_pieces_of_a_step;
        return ends ? undecided_on(p, all) : verdict{finding::open, 0};
    }
    if (const int sign = known_sign(all.slope); sign != 0) {
        return {finding::monotone, sign};
    }
    const sample middle = sampled(exact_midpoint(span));
    const ball beside = span - exact_midpoint(span);
    // The mean value form of gamma, with gamma' enclosed directly, then by its own mean value form with gamma''.
    for (const bool curved : {false, true}) {
        if (curved && has_own_slopes_) {
            break;
        }
        if (curved) {
            all.slope = middle.slope + of_state(curvature(), span) * beside;
            if (const int sign = known_sign(all.slope); sign != 0) {
                return {finding::monotone, sign};
            }
        }
        all.value = middle.value + all.slope * beside;
        if (const int sign = known_sign(all.value); sign != 0) {
            return {finding::no_zero, sign};
        }
    }
    const bool no_use = magnitude(all.slope) * magnitude::radius_of(span) <= magnitude::radius_of(middle.value);
    if (no_use && p.digits < digits_) {
        p.digits = std::min(2 * p.digits, digits_);
        return judged(p);
    }
    const bool narrow = no_use || p.is_narrow(bits_);
    if (!narrow && ++examined_ <= most_pieces_of_a_step) {
        return {finding::open, 0};
    }
    const verdict undecided = undecided_on(p, all);
    undecided_->too_many_pieces = !narrow;
    return undecided;
}

// The later part first, so that the earlier part is processed next.
void zero_search::split(const step_piece& p) {
    if (is_start(p) || has_own_slopes_ || !split_at_turn(p)) {
        const ball middle = p.middle();
        pieces_.push_back(p.behind(middle));
        pieces_.push_back(p.before(middle));
    }
}

// If gamma'' excludes 0 on the piece, gamma turns there at most once: splits off a neighbourhood of that point, on both
// sides of which gamma is monotone. False if that is not proved.
bool zero_search::split_at_turn(const step_piece& p) {
    const precision_scope scope(p.digits);
    const ball span = span_of(p);
    const int bent = known_sign(of_state(curvature(), span)) * direction_;
    if (bent == 0 || !is_finite(of_state(g_, span))) {
        return false;
    }
    const auto place = zero_within(
        span, [&](const ball& at) { return of_state(slope_, at); },
        [&](const ball& at) { return of_state(curvature(), at); });
    if (!place) {
        return false;
    }
    const ball wide = widened(*place, magnitude::radius_of(*place) * magnitude(8U)) * direction_;
    const ball first = lower_bound(wide);
    const ball last = upper_bound(wide);
    const bool inside = exactly_less(p.from, last) && exactly_less(first, p.to) &&
                        magnitude::radius_of(wide) * magnitude(2U) <= magnitude::radius_of(span);
    const bool before = exactly_less(p.from, first);
    const bool behind = exactly_less(last, p.to);
    if (!inside || (before && known_sign(of_state(slope_, first * direction_)) != -bent) ||
        (behind && known_sign(of_state(slope_, last * direction_)) != bent)) {
        return false;
    }
    step_piece rest = p;
    if (behind) {
        pieces_.push_back(p.behind(last));
        pieces_.back().slope = bent;
        rest = p.before(last);
    }
    pieces_.push_back(before ? rest.behind(first) : rest);
    if (before) {
        pieces_.push_back(rest.before(first));
        pieces_.back().slope = -bent;
    }
    return true;
}

std::optional<proved_event> zero_search::examined(step_piece p) {
    const verdict found = p.slope != 0  ? verdict{finding::monotone, p.slope}
                          : is_start(p) ? judged_at_start(p)
                                        : judged(p);
    switch (found.kind) {
        case finding::no_zero: return with_sign(found.sign);
        case finding::monotone: return passed(p, found.sign);
        case finding::open: split(p); return std::nullopt;
        case finding::undecided: break;
    }
    const auto near = [&](const step_piece& whole) {
        return exact_zero_near(g_, hull(time_ + whole.from * direction_, time_ + whole.to * direction_));
    };
    if (const auto zero = is_start(p) ? std::nullopt : near(p)) {
        // With the pieces behind it for which the same holds, which need not be split.
        for (bool more = true; more && !pieces_.empty() && !pieces_.back().beyond;) {
            step_piece wider = p;
            wider.to = pieces_.back().to;
            const auto same = near(wider);
            more = same && (same->time - zero->time).sign() == 0;
            if (more) {
                p = std::move(wider);
                pieces_.pop_back();
            }
        }
        return at_exact_zero(p, *zero);
    }
    end_ = search_end::undecided;
    return std::nullopt;
}

// On the hull of the piece and a zero of order k, the only one there: g has the sign of g^(k) behind it, and that of (-1)^k
// g^(k) before it. The next piece may contain the same zero at its beginning.
std::optional<proved_event> zero_search::at_exact_zero(const step_piece& p, const exact_zero& zero) {
    const bool touches = zero.order % 2 == 0;
    const int behind = touches || direction_ > 0 ? zero.sign : -zero.sign;
    const int before = touches ? behind : -behind;
    const ball time = constant_value<ball>::of(zero.time);
    const ball distance = time - time_;
    if (known_sign(distance * direction_ - p.to) > 0) {
        return with_sign(before);
    }
    if (known_sign(distance * direction_ - p.from) < 0) {
        return with_sign(behind);
    }
    if (open_ && before != sign_) {  // there is a zero before this one
        pieces_.push_back(p);
        return with_sign(before);
    }
    const bool again = touched_ && (*touched_ - zero.time).sign() == 0;
    if (!again && before != sign_) {
        end_ = search_end::undecided;
        return std::nullopt;
    }
    const crossing way = touches ? crossing::any : way_of_next();
    touched_ = zero.time;
    sign_ = behind;
    open_ = false;
    parts_.clear();
    if (again || (way_ != crossing::any && way_ != way)) {
        return std::nullopt;
    }
    return proved_event{time, sampled(distance).state, way,
                        step_->from().derivative ? step_->derivative(distance) : ball_matrix(), zero.time};
}

// g has this sign from here on.
std::optional<proved_event> zero_search::with_sign(int sign) {
    if (sign != sign_) {
        return joined();
    }
    parts_.clear();
    open_ = false;
    return std::nullopt;
}

// A piece on which g is monotone.
std::optional<proved_event> zero_search::passed(const step_piece& p, int slope) {
    if (slope * direction_ == sign_) {
        if (open_) {
            throw std::logic_error("a monotone function that turns");
        }
        return std::nullopt;
    }
    const int behind = sign_at(p.to);
    if (behind == sign_) {
        return with_sign(behind);
    }
    if (way_ == crossing::any || way_ == way_of_next()) {
        add_part(p);
    }
    open_ = true;
    return behind == 0 ? std::nullopt : joined();
}

// Encloses the zero if it is on the piece, on which gamma is monotone: by Newton's method and, as long as a strongly
// varying slope prevents that from narrowing, by signs between the ends. Nothing is added if the zero is not on the
// piece.
void zero_search::add_part(step_piece p) {
    for (;;) {
        const auto place = zero_within(
            span_of(p), [&](const ball& at) { return sampled(at).value; },
            [&](const ball& at) { return sampled(at).slope; });
        if (!place) {
            return;
        }
        sample here = sampled(*place);
        p = p.within(*place * direction_);
        const bool converged = known_sign(here.slope) != 0 && known_sign(of_state(g_, exact_midpoint(*place))) == 0;
        if (converged || p.is_narrow(bits_) || !narrowed_by_signs(p)) {
            const ball time = time_ + *place;
            parts_.push_back({time, std::move(here.state), crossing::any,
                              step_->from().derivative ? step_->derivative(*place) : ball_matrix()});
            return;
        }
    }
}

// Cuts the piece on which gamma is monotone at its middle; if gamma is not distinguished from 0 there, which may be its
// zero, between the middle and both ends.
bool zero_search::narrowed_by_signs(step_piece& p) const {
    const auto cut = [&](const ball& place) {
        const bool inside = exactly_less(p.from, place) && exactly_less(place, p.to);
        const int sign = inside ? sign_at(place) : 0;
        if (sign != 0) p = sign == sign_ ? p.behind(place) : p.before(place);
        return sign != 0;
    };
    const ball middle = p.middle();
    if (cut(middle)) {
        return true;
    }
    const ball first = p.before(middle).middle();
    const ball last = p.behind(middle).middle();
    const bool before = cut(first);
    return cut(last) || before;
}

// The only zero of the joined pieces, unless it is crossed in the other direction than those that are enclosed.
std::optional<proved_event> zero_search::joined() {
    if (way_ != crossing::any && way_ != way_of_next()) {
        sign_ = -sign_;
        open_ = false;
        return std::nullopt;
    }
    if (parts_.empty()) {
        throw std::logic_error("a zero that is on none of its pieces");
    }
    proved_event event = std::move(parts_.front());
    for (std::size_t k = 1; k < parts_.size(); ++k) {
        event.time = hull(event.time, parts_[k].time);
        for (std::size_t i = 0; i < event.state.size(); ++i) {
            event.state[i] = hull(event.state[i], parts_[k].state[i]);
        }
        for (std::size_t i = 0; i < event.flow.size(); ++i) {
            for (std::size_t j = 0; j < event.flow[i].size(); ++j) {
                event.flow[i][j] = hull(event.flow[i][j], parts_[k].flow[i][j]);
            }
        }
    }
    event.way = way_of_next();
    sign_ = -sign_;
    parts_.clear();
    open_ = false;
    return event;
}

void zero_search::leave_step() {
    time_ = step_->end_time();
    steps_ += step_->cost();
    ++number_;
    step_ = nullptr;
    if (own_ && (kept_ == nullptr || !kept_->keeps(*own_))) {
        own_->forget_before(number_);
    }
    if (watch_) {
        watch_(time_, bits_);
    }
}

// Prepares the pieces of the next step. Returns false for the reason end_.
bool zero_search::begin_step(const std::optional<ball>& end, long last_step) {
    if (step_ != nullptr) {
        leave_step();
    }
    if (!open_ && steps_ >= last_step) {
        end_ = search_end::horizon;
        return false;
    }
    const auto left = [&] { return upper_bound((*end - time_) * direction_); };
    const bool beyond = end && !exactly_less(ball(0), left());
    if (beyond && !open_) {
        end_ = search_end::time;
        return false;
    }
    if (own_) {
        own_->aim(end && !beyond ? upper_bound(*end * direction_) * direction_ : infinite_distance(direction_));
    }
    ball rest;
    arb_pos_inf(rest.handle());
    rest = end && !beyond ? left() : rest;
    step_ = along_[number_];
    if (step_ == nullptr) {
        end_ = along_.why() == stop::step_too_small ? search_end::steps : search_end::precision;
        return false;
    }
    time_ = step_->from().time;
    ball first = abs(step_->length());
    if (exactly_less(rest, first)) {
        pieces_.push_back({rest, first, few_digits, 0, 0, true});
        first = rest;
    }
    for (unsigned long k = first_pieces; k-- > 0;) {
        pieces_.push_back({exact_multiple(first, k, -2), exact_multiple(first, k + 1, -2), few_digits});
    }
    examined_ = 0;
    has_own_slopes_ = !step_->slopes(ball(0)).empty();
    return true;
}

std::optional<proved_event> zero_search::next(crossing way, const std::optional<number>& end,
                                              const std::optional<long>& horizon) {
    const precision_scope scope(digits_);
    const std::optional<ball> last = end ? std::optional(constant_value<ball>::of(*end)) : std::nullopt;
    const auto is_beyond = [&](const ball& time) { return last && known_sign((time - *last) * direction_) > 0; };
    const long last_step = horizon ? steps_ + *horizon
                           : end   ? std::numeric_limits<long>::max()
                                   : steps_ + usual_horizon;
    end_ = search_end::none;
    way_ = way;
    for (step_piece& each : pieces_) {  // of a search with an earlier end
        each.beyond = each.beyond && last && known_sign((*last - time_) * direction_ - each.from) <= 0;
    }
    if (beyond_ && !is_beyond(beyond_->time)) {
        return std::exchange(beyond_, std::nullopt);
    }
    if (beyond_) {
        end_ = search_end::time;
    }
    try {
        while (end_ == search_end::none) {
            if (pieces_.empty() && !begin_step(last, last_step)) {
                break;
            }
            if (!open_ && pieces_.back().beyond) {
                end_ = search_end::time;
                break;
            }
            step_piece next = std::move(pieces_.back());
            pieces_.pop_back();
            auto event = examined(std::move(next));
            if (!event) {
                continue;
            }
            if (!is_beyond(event->time)) {
                return event;
            }
            beyond_ = std::move(event);
            end_ = search_end::time;
        }
    } catch (const precision_exhausted&) {
        end_ = search_end::precision;
    }
    return std::nullopt;
}

}  // namespace libration::ode
