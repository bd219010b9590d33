#include "libration/integration/proved_march.hpp"

#include <algorithm>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "../expansion/set_values.hpp"
#include "libration/integration/taylor/taylor_march.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "method_choice.hpp"
#include "root/root_rule.hpp"

namespace libration::ode {

namespace {

// The errors added by a step are this number of bits below the set: 2^16 steps add as much as its width.
constexpr long bits_below_the_set = 20;
// The bits of the error map that its truncation need not preserve.
constexpr long bits_below_truncation = 40;
// The number of steps between two calls of the progress callback, unless steps take long.
constexpr long steps_unwatched = 64;
constexpr long bits_unwatched = 4096;
// log2 of the factor by which the error map shortens a step that justifies more terms.
constexpr double worth_more_terms = 0.3;
// The bits of the error map that its largest terms may lose before its precision is increased.
constexpr double bits_to_lose = 16;
// log2 of the uncertainty of the error map from which on shorter steps pay off, of the factor by which it may grow
// more than the length of the step, and how often that is halved.
constexpr double significant_uncertainty = -12;
constexpr double excess_growth = 0.3;
constexpr int most_halvings_for_width = 5;

// From an initial point with roots of the distance from it the first steps are those of a root_rule.
bool begins_at_root(const explicit_system& system) { return system.singular() && system.singular()->root > 1; }

singular_step begin_of(const explicit_system& system, long bits, const proof_route& route) {
    if (begins_at_root(system)) {
        return {first_order_form(system).about_points(system.point()), enclosed_start(system, bits), {}};
    }
    return system.singular() ? proved_singular_step(system, bits, route)
                             : singular_step{system, enclosed_start(system, bits), {}};
}

state_set box_around(const std::vector<ball>& start, long bits) {
    const precision_scope scope(decimal_digits(bits));
    state_set box;
    std::vector<magnitude> widths;
    for (const ball& each : start) {
        box.centre.push_back(exact_midpoint(each));
        widths.emplace_back(each - box.centre.back());
    }
    box.errors = lohner_set(std::move(widths));
    return box;
}

}  // namespace

proved_march::~proved_march() = default;

proved_march::proved_march(const explicit_system& system, long bits, march_watch watch, long error_bits,
                           const proof_route& route)
    : proved_march(begin_of(system, bits, route), bits, std::move(watch), error_bits, route) {
    if (begins_at_root(system)) {
        const precision_scope scope(decimal_digits(bits));
        if (!roots_) {
            roots_ = std::make_unique<root_rule>(system, std::vector<root_time>(), bits, error_bits, route);
        }
        roots_->begin_at_start(system);
        time_ = roots_->time();
        before_ = roots_->before();
    } else if (system.singular()) {
        singular_ = system;
    }
}

proved_march::proved_march(singular_step begin, long bits, march_watch watch, long error_bits, const proof_route& route)
    : proved_march(begin.beyond, begin.state, bits, error_bits, std::move(watch), route) {
    before_ = std::move(begin.on_the_way);
}

proved_march::proved_march(const explicit_system& system, const std::vector<ball>& start, long bits, long error_bits,
                           march_watch watch, const proof_route& route)
    : proved_march(system, box_around(start, bits), start, bits, error_bits, std::move(watch), route) {}

proved_march::proved_march(const explicit_system& system, state_set start, long bits, march_watch watch,
                           const proof_route& route)
    : proved_march(system, start, start.hull(), bits, usual_error_bits, std::move(watch), route) {
    scales_.accept_any_width();
}

proved_march::proved_march(const explicit_system& system, state_set start, const std::vector<ball>& hull, long bits,
                           long error_bits, march_watch watch, const proof_route& route)
    : lifted_(lifted(system)),
      tape_(tape::about_points(lifted_.system)),
      varied_tape_(tape::about_points(with_variations(lifted_))),
      bits_(bits),
      error_bits_(error_bits),
      route_(route),
      set_order_(taylor_order(static_cast<int>(error_bits)) - 2 + route.more_terms),
      set_(std::move(start)),
      scales_(hull),
      set_bits_(error_bits),
      watch_(std::move(watch)),
      collocation_(std::make_unique<method_choice>(lifted_, bits, route)) {
    require_integrator();
    if (auto times = root_times(system); !times.empty()) {
        roots_ = std::make_unique<root_rule>(system, std::move(times), bits, error_bits, route);
    }
    const precision_scope scope(decimal_digits(bits));
    time_ = constant_value<ball>::of(system.point());
    origin_ = time_;
}

const proved_step* proved_march::stopped(march_end why) {
    end_ = why;
    return nullptr;
}

const proved_step* proved_march::prepare() {
    if (now_ && now_->ready_) {
        return now_.get();
    }
    scales_.measure_errors(set_.errors);
    make_step();
    if (!expand_centre()) {
        return stopped_by_bounds();
    }
    scales_.measure_sizes(now_->of_centre_, now_->tail_->radius);
    if (scales_.lost(widest_set)) {
        return stopped(march_end::precision);
    }
    scales_.resolve(widest_set);
    if (!expand_set()) {
        return stopped_by_bounds();
    }
    if (choose_length() && !expand_set()) {
        return stopped_by_bounds();
    }
    const magnitude gone(time_ - origin_);
    if (steps_ >= most_steps || now_->length_ <= gone * magnitude::of(1, -40)) {
        return stopped(march_end::steps);
    }
    now_->ready_ = true;
    return now_.get();
}

// No radius was found; a narrow set is not the reason.
const proved_step* proved_march::stopped_by_bounds() {
    return stopped(scales_.wide(2 * widest_set) ? march_end::precision : march_end::steps);
}

void proved_march::make_step() {
    const long bits =
        std::clamp(scales_.accuracy(bits_) + bits_below_the_set, usual_error_bits, std::max(bits_, usual_error_bits));
    if (!now_ || bits > now_->bits_ || now_->bits_ > bits + bits / 8 + 16 || now_->of_set_.order() != set_order_) {
        const long some_more = std::min(bits_, bits + bits / 16);
        const precision_scope scope(decimal_digits(some_more));
        now_.reset(new proved_step(tape_, varied_tape_, some_more, set_order_, route_));
    }
}

// The series of the centre, and its remainder.
bool proved_march::expand_centre() {
    const precision_scope scope(decimal_digits(now_->bits_));
    const auto all = lifted_values(lifted_, time_, set_.centre);
    if (!all_finite(all)) {
        return false;
    }
    now_->of_centre_.about(time_, as_state(all));
    now_->log_of_radius_ = estimated_radius(now_->of_centre_, all.size());
    if (now_->log_of_radius_ == no_radius && expand_variations()) {
        now_->log_of_radius_ = radius_of_variations();
    }
    now_->tail_ = tail_near(tape_, now_->of_centre_, time_, now_->log_of_radius_);
    return now_->tail_.has_value();
}

// The series of the set with its variations, in low precision, and their remainders.
bool proved_march::expand_set() {
    const precision_scope few(decimal_digits(set_bits_));
    set_.errors = set_.errors.settled(scales_.exponents());
    now_->errors_ = set_.errors;
    now_->set_bits_ = set_bits_;
    if (!expand_variations()) {
        return false;
    }
    const double radius = std::min(now_->log_of_radius_, radius_of_variations());
    now_->set_tail_ = tail_near(varied_tape_, now_->of_set_, time_, radius);
    return now_->set_tail_.has_value();
}

bool proved_march::expand_variations() {
    const precision_scope few(decimal_digits(set_bits_));
    const auto varied = varied_values(lifted_, time_, set_.hull());
    const bool finite = all_finite(varied);
    if (finite) {
        now_->of_set_.about(time_, as_state(varied));
    }
    return finite;
}

// At an equilibrium only the variations have a finite radius.
double proved_march::radius_of_variations() const {
    return estimated_radius(now_->of_set_, varied_tape_.orders().size());
}

// The longest step with a tail below the last bits of each unknown and small in the error map; any length is valid.
// Returns whether that map needs more bits.
bool proved_march::choose_length() {
    const variation_places places{lifted_.given, lifted_.leaves.size()};
    const auto wanted = static_cast<double>(bits_below_truncation - error_bits_);
    const double of_centre = scales_.longest(*now_->tail_, now_->bits_, bits_below_the_set);
    const double at_first = std::min(of_centre, longest_for_map(*now_->set_tail_, scales_, places, wanted));
    const double growth = growth_of_terms(now_->of_set_, scales_, places, at_first);
    const double of_set = longest_for_map(*now_->set_tail_, scales_, places, wanted - growth);
    now_->length_ = route_.shortened(power_of_two(std::min(at_first, of_set)));
    if (scales_.accepts_any_width()) {
        shorten_for_width();
    }
    // If the flow contracts much faster than the solution moves, the error map needs more terms and bits.
    if (of_set + worth_more_terms < of_centre) {
        set_order_ = std::min(set_order_ + set_order_ / 4, now_->of_centre_.order());
    }
    const long bits = error_bits_ + static_cast<long>(2 * growth - bits_to_lose);
    const bool more = bits > set_bits_;
    if (more) {
        set_bits_ = bits + bits_below_the_set;
    }
    return more;
}

// The derivative over a wide set is enclosed the less sharply the longer the step is: until its uncertainty grows about
// as the length.
void proved_march::shorten_for_width() {
    const auto uncertainty = [this](const magnitude& length) {
        const ball_matrix map = now_->derivative_of_flow(length.exact());
        double most = nothing;
        for (std::size_t i = 0; i < map.size(); ++i) {
            for (std::size_t j = 0; j < map.size(); ++j) {
                const double scale = scales_[j].scale - scales_[i].scale;
                most = std::max(most, log_of(magnitude::radius_of(map[i][j])) + scale);
            }
        }
        return most;
    };
    double now = uncertainty(now_->length_);
    for (int halving = 0; halving < most_halvings_for_width && now > significant_uncertainty; ++halving) {
        const magnitude half = now_->length_.shifted(-1);
        const double then = uncertainty(half);
        if (now - then < 1 + excess_growth) {
            return;
        }
        now_->length_ = half;
        now = then;
    }
}

void proved_march::take(const proved_step& prepared, int direction) {
    use_step(direction);
    move(prepared, direction < 0 ? -prepared.length().exact() : prepared.length().exact());
    count_steps(1);
}

// The set, and the derivative of the flow, to this distance within the step.
void proved_march::move(const proved_step& prepared, const ball& distance) {
    used_ = false;
    const precision_scope scope(decimal_digits(prepared.bits()));
    const auto image = prepared.flow_of_centre(distance);
    std::vector<magnitude> added;
    for (std::size_t i = 0; i < image.size(); ++i) {
        set_.centre[i] = exact_midpoint(image[i]);
        added.emplace_back(image[i] - set_.centre[i]);
    }
    arb_add(time_.handle(), time_.handle(), distance.handle(), ARF_PREC_EXACT);
    const precision_scope few(decimal_digits(set_bits_));
    const ball_matrix map = prepared.derivative_of_flow(distance);
    now_->ready_ = false;
    if (derivative_) {
        derivative_ = product(map, *derivative_);
    }
    set_.errors = set_.errors.image(map, added);
}

void proved_march::count_steps(long count) {
    steps_ += count;
    if (watch_ && (steps_ / steps_unwatched != (steps_ - count) / steps_unwatched || bits_ > bits_unwatched)) {
        watch_(time_, bits_);
    }
}

void proved_march::keep_derivative() {
    scales_.weigh_by_scales();
    if (singular_) {
        const precision_scope scope(decimal_digits(bits_));
        const ball distance = time_ - constant_value<ball>::of(singular_->point());
        derivative_ = derivative_beyond_start(*singular_, distance, error_bits_, route_);
        require_integrator();
        return;
    }
    if (roots_ && roots_->is_active()) {
        roots_->keep_derivative();
    }
    derivative_ = ball_matrix(lifted_.given);
    for (std::size_t i = 0; i < lifted_.given; ++i) {
        for (std::size_t j = 0; j < lifted_.given; ++j) {
            (*derivative_)[i].emplace_back(i == j ? 1 : 0);
        }
    }
    require_integrator();
}

ball_matrix proved_march::derivative_at(const ball& time) const {
    const precision_scope few(decimal_digits(set_bits_));
    const ball distance = time - time_;
    const bool in_root = roots_ && roots_->is_active();
    return product(in_root                     ? roots_->derivative_at(distance)
                   : collocation_->is_active() ? collocation_->derivative_at(distance)
                                               : now_->derivative_of_flow(distance),
                   *derivative_);
}

std::optional<std::vector<ball>> proved_march::at(const number& time) {
    const precision_scope scope(decimal_digits(bits_) + 20);
    return at(constant_value<ball>::of(time));
}

// Without rounding between exact times, so that the end of a step is in it.
ball proved_march::distance_to(const ball& target) const {
    ball distance;
    const bool exact = is_exact(target) && is_exact(time_);
    arb_sub(distance.handle(), target.handle(), time_.handle(), exact ? ARF_PREC_EXACT : ball::working_bits());
    return distance;
}

std::optional<std::vector<ball>> proved_march::at(const ball& target) {
    const precision_scope scope(decimal_digits(bits_) + 20);
    try {
        for (;;) {
            const ball distance = distance_to(target);
            const int direction = arb_is_negative(distance.handle()) != 0 ? -1 : 1;
            const enclosed_step* const step = prepare_towards(distance);
            if (step == nullptr) {
                break;
            }
            if (step->reaches(distance)) {
                use_prepared(target, direction);
                return step->values_at(distance);
            }
            take_prepared(direction);
        }
    } catch (const precision_exhausted&) {
        end_ = march_end::precision;
    }
    return std::nullopt;
}

}  // namespace libration::ode
