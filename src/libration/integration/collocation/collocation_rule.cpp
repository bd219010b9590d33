#include "collocation_rule.hpp"

#include <algorithm>
#include <utility>

#include "../../algebra/rounded_matrix.hpp"
#include "../lifted_set.hpp"
#include "collocation_step.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/taylor/step_length.hpp"
#include "libration/scalar/ball/failure.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

// The cost of a step grows with the cube of the number of unknowns, that of the preparation with the cube of the bits,
// and the memory for frames of many unknowns with the square of both.
constexpr std::size_t most_collocation_unknowns = 250;
constexpr std::size_t most_unknowns_with_derivative = 40;
constexpr long most_collocation_bits = 1024;
constexpr long most_bits_of_frames_in_double = 400;
// The number of steps in which their length may grow until they pay off.
constexpr long steps_to_grow = 6;
constexpr int steps_without_fast_modes = 3;
// Collocation loses fewer bits than Taylor series, for which the guard bits of a run are chosen. With all bits of the run,
// the values at the last time have 16 bits more than their 20 digits need in problem E5, 35 in POLLU, and 42 in HIRES.
// A larger reduction pays where steps are expensive; if too many bits are missing, there is a second run.
constexpr std::size_t many_unknowns = 7;
constexpr long unneeded_bits = 12;
constexpr long unneeded_bits_of_many = 28;

// The least number of steps of Taylor series that take longer than the preparation of collocation.
unsigned long steps_worth_preparation(long bits, bool in_double) {
    const unsigned long at_200_bits = in_double ? 100 : 1000;
    const auto times = static_cast<unsigned long>(std::max(200L, bits));
    return at_200_bits * times * times * times / (200 * 200 * 200);
}

// Its given unknowns are those of the form.
polynomial_form form_with_variations(const polynomial_form& of) {
    explicit_system system = with_variations(of);
    std::vector<expression> leaves;
    for (const unknown_function& each : system.unknowns()) {
        leaves.push_back(unknown(each.name));
    }
    return {std::move(system), of.given, {}, {}, std::move(leaves)};
}

}  // namespace

collocation_rule::collocation_rule(const polynomial_form& of, long bits, const proof_route& route)
    : system_(of), bits_(bits), route_(route), between_checks_(first_interval()) {
    begin();
}

void collocation_rule::begin() {
    period_.reset();
    between_checks_ = first_interval();
    next_check_ = route_.integrator == integrator_choice::automatic ? between_checks_ : 0;
}

long collocation_rule::bits_of_steps() const {
    return bits_ - (system_.leaves.size() < many_unknowns ? unneeded_bits : unneeded_bits_of_many);
}

bool collocation_rule::is_in_double() const { return system_.leaves.size() >= least_size_in_double; }

// With frames in double, the Brusselator with 100 unknowns takes 4 s for a step and 1 s for one of Taylor series.
long collocation_rule::cost_of_step() const {
    const long at_200_bits = is_in_double() ? 4 : 32;
    const long bits = std::max(200L, bits_);
    const auto columns = static_cast<long>(varied_ ? 1 + system_.given : 1);
    return at_200_bits * bits * bits / (200 * 200) * columns * columns;
}

long collocation_rule::first_interval() const {
    return is_in_double() ? cost_of_step() : steps_without_fast_modes * cost_of_step();
}

std::string collocation_rule::obstacle(bool with_derivative) const {
    if (system_.has_functions) {
        return "needs a polynomial form, which quotients with removable singularities do not have";
    }
    const std::size_t count = system_.leaves.size() * (with_derivative ? 1 + system_.given : 1);
    const std::size_t most = with_derivative ? most_unknowns_with_derivative : most_collocation_unknowns;
    if (count > most) {
        return "is limited to " + std::to_string(most) + " unknowns, and the polynomial form of these equations" +
               (with_derivative ? " with the derivative of the flow, which is needed here," : "") + " has " +
               std::to_string(count);
    }
    const long bits = count < least_size_in_double ? most_collocation_bits : most_bits_of_frames_in_double;
    if (bits_ > bits) {
        return "is limited to a precision of " + std::to_string(bits) + " bits for " + std::to_string(count) +
               " unknowns, and these digits need " + std::to_string(bits_);
    }
    return "";
}

bool collocation_rule::is_worth_a_try(long cost, const magnitude& length, const ball& rest,
                                      bool with_derivative) const {
    if (cost < next_check_ || !obstacle(with_derivative).empty()) {
        return false;
    }
    switch (route_.integrator) {
        case integrator_choice::taylor:
        case integrator_choice::comparison: return false;
        case integrator_choice::collocation: return true;
        case integrator_choice::automatic: break;
    }
    const unsigned long columns = with_derivative ? 1 + system_.given : 1;
    return length * magnitude(steps_worth_preparation(bits_, is_in_double()) * columns * columns) <= magnitude(rest);
}

// The unknowns of the form and then, column by column, its derivatives with respect to the given ones: the identity,
// and for added unknowns the derivatives of their definitions. Each has a width far below the scale of its unknowns, so
// that a column that decays to nothing need not be resolved.
std::optional<tube_set> collocation_rule::with_identity(const ball& time, const state_set& set, tube_set all) const {
    const auto values = varied_values(system_, time, set.hull());
    for (std::size_t k = system_.leaves.size(); k < values.size(); ++k) {
        if (!is_finite(values[k])) {
            return std::nullopt;
        }
        const magnitude of_unknown(values[k % system_.leaves.size()]);
        const magnitude by_unknown = magnitude::below(values[k / system_.leaves.size() - 1]);
        const magnitude scale = by_unknown.is_zero() ? magnitude(values[k]) : of_unknown / by_unknown;
        all.centre.push_back(midpoint_alone(values[k]));
        all.errors.add_coordinate({}, magnitude::radius_of(values[k]) + scale.shifted(-bits_));
    }
    return all;
}

std::shared_ptr<const step> collocation_rule::first(long cost, const flow_state& from, const magnitude& length,
                                                    const ball& rest) {
    const bool with_derivative = from.derivative.has_value();
    if (!is_worth_a_try(cost, length, rest, with_derivative)) {
        return nullptr;
    }
    const std::size_t given = from.set.centre.size();
    const bool has_more_columns = from.set.errors.columns().size() > given;
    const auto set = has_more_columns ? set_of_first(given, from.set) : std::optional(from.set);
    if (!set) {
        return nullptr;
    }
    next_check_ = cost + between_checks_;
    between_checks_ *= 2;
    if (!integrator_) {
        integrator_.emplace(system_, bits_of_steps(), route_.more_terms);
    }
    auto all = lifted_set(system_, from.time, *set);
    if (!all) {
        return nullptr;
    }
    coordinates_.reset();
    varied_.reset();
    other_.reset();
    largest_.assign(given, nothing);
    decaying_.clear();
    const ball first = arb_is_negative(rest.handle()) != 0 ? -length.exact() : length.exact();
    if (route_.integrator == integrator_choice::automatic &&
        !integrator_->is_smooth_over(from.time, all->centre, first)) {
        return nullptr;
    }
    if (with_derivative) {
        all = with_identity(from.time, *set, *std::move(all));
        if (!all) {
            return nullptr;
        }
        varied_ = form_with_variations(system_);
        other_.emplace(*varied_, bits_of_steps(), route_.more_terms);
    }
    current().begin(from.time, *all, first);
    period_ = std::make_shared<carried>();
    derivative_ = from.derivative;
    has_set_ = true;
    steps_of_period_ = 0;
    length_to_pay_ = length * magnitude(static_cast<unsigned long>(cost_of_step()));
    auto made = made_from(from);
    if (!made) {
        period_.reset();
    }
    return made;
}

std::shared_ptr<const step> collocation_rule::made_from(const flow_state& from) {
    collocation_integrator& by = current();
    if (!by.prepare()) {
        return nullptr;
    }
    collocation_step::parts parts{
        by.prepared(), coordinates_, system_.given, system_.leaves.size(), varied_ ? derivative_ : std::nullopt, {}, {},
        period_};
    pays_ = length_to_pay_ <= magnitude(by.length());
    by.step();
    ++steps_of_period_;
    parts.all_at_end = by.set();
    parts.set_at_end = set_of_first(system_.given, by.set());
    if (parts.set_at_end && coordinates_) {
        parts.set_at_end = coordinates_->from_coordinates().image(by.reached(), *parts.set_at_end);
    }
    has_set_ = parts.set_at_end.has_value();
    const step::origin made{by.bits(), by.degree(), step_method::collocation, cost_of_step()};
    return std::make_shared<collocation_step>(from, std::move(parts), made);
}

bool collocation_rule::continues(long cost) {
    if (pays_) {
        between_checks_ = first_interval();
    }
    next_check_ = cost + between_checks_;
    if (route_.integrator == integrator_choice::collocation) {
        return true;
    }
    return current().steps_without_fast_modes() < steps_without_fast_modes &&
           (steps_of_period_ <= steps_to_grow || pays_);
}

std::vector<ball> collocation_rule::hull() const {
    return given_unknowns(current().set().hull(), system_.given, coordinates_.get(), current().reached());
}

std::shared_ptr<const step> collocation_rule::next(const flow_state& from) {
    follow_decay(from);
    return made_from(from);
}

flow_state collocation_rule::end_of(const flow_state& from) {
    period_.reset();
    if (!has_set_) {
        throw precision_exhausted("an error set");
    }
    return {from.time, from.set, from.derivative, {}};
}

// Looks for coordinates if the list of the unknowns that have decayed is another one: with the first of them those that
// have come half of the way.
void collocation_rule::follow_decay(const flow_state& from) {
    const std::vector<ball> now = hull();
    std::vector<std::size_t> half_decayed;
    bool decayed = false;
    for (std::size_t k = 0; k < now.size(); ++k) {
        const double size = log_of(magnitude(now[k]));
        largest_[k] = std::max(largest_[k], size);
        const bool resolved = arb_contains_zero(now[k].handle()) == 0;
        const double lost = resolved ? largest_[k] - size : 0;
        decayed = decayed || lost > static_cast<double>(bits_);
        if (lost > static_cast<double>(bits_) / 2) {
            half_decayed.push_back(k);
        }
    }
    if (!varied_ && decayed && half_decayed != decaying_) {
        decaying_ = std::move(half_decayed);
        change_coordinates(from);
    }
}

void collocation_rule::change_coordinates(const flow_state& from) {
    auto found = has_set_ ? decay_coordinates::of(system_, decaying_, from.set) : std::nullopt;
    const ball time = current().reached();
    const auto changed = found ? found->to_coordinates().image(time, from.set) : std::nullopt;
    const auto all = changed ? lifted_set(found->system(), time, *changed) : std::nullopt;
    if (!all) {
        return;
    }
    const ball length = current().next_length();
    coordinates_ = std::make_shared<decay_coordinates>(*std::move(found));
    other_.emplace(coordinates_->system(), bits_of_steps(), route_.more_terms);
    other_->begin(time, *all, length);
}

}  // namespace libration::ode
