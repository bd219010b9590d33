#include "certified_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../integration/lifted_set.hpp"
#include "certificate_format.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration::ode {

namespace {

constexpr long guard_of_rounding = 8;
// The bounds of the program that checks are integers times 2^-S; S has so many bits more than the polynomials.
constexpr long more_bits_of_bounds = 64;
constexpr double digits_below_width = 4;
// Integers of a certificate have five digits.
constexpr long most_certified_steps = 99'999;
constexpr long steps_of_estimate = 100;
// Where steps grow by such a factor from one estimate to the next, no number of steps is expected. Otherwise a run ends if
// so many times the steps that are possible are expected.
constexpr double growing = 1.25;
constexpr double doubtful = 4;

[[noreturn]] void refuse_steps(double expected, const rational& time) {
    const precision_scope scope(20);
    throw error(error_kind::argument, error_subject::certificate, "",
                "contains at most " + std::to_string(most_certified_steps) + " steps, and to time " +
                    to_finite_decimal(time).value_or(time.str()) + " there would be about " +
                    to_decimal(mpfr(expected), 2) +
                    ": choose an earlier time, or leave it out and compare two proofs with --check");
}

// The box of all unknowns of the form, from a box of the given ones. The checker encloses the sine of [a, b] by that of
// a, with b - a as radius.
std::optional<tube_set> box_of_start(const polynomial_form& of, const ball& time, const std::vector<ball>& given) {
    expression_values<ball> values(of.leaves, time);
    for (const ball& each : given) {
        values.push_back(each);
    }
    for (const expression& each : of.added) {
        ball value = values.of(each);
        if (each.kind() == node_kind::function &&
            (each.function() == function_kind::sin || each.function() == function_kind::cos)) {
            value = widened(value, magnitude::radius_of(values.of(each.left())).shifted(2));
        }
        if (!is_finite(value)) {
            return std::nullopt;
        }
        values.push_back(value);
    }
    tube_set set;
    std::vector<magnitude> radii;
    for (const ball& each : values.values()) {
        set.centre.push_back(midpoint_alone(each));
        const magnitude radius = magnitude::radius_of(each);
        radii.push_back(radius + radius.shifted(-10));
    }
    set.errors = lohner_set(std::move(radii));
    set.slow = set.centre.size();
    return set;
}

}  // namespace

certified_run::certified_run(const explicit_system& system, const polynomial_form& form, const run_choice& choice)
    : form_(form),
      begins_in_box_(!choice.starts.empty()),
      integrator_(form, choice.bits, 0, {choice.slowest_fast, digits_below_width}),
      map_(form),
      rounding_(choice.bits - guard_of_rounding, integrator_.bits() + more_bits_of_bounds),
      begin_(*system.point().fraction()) {
    bits_ = integrator_.bits() + 2L * integrator_.degree() + more_bits_of_bounds;
    if (choice.rounds) {
        integrator_.prove_by([this](tube_proof& by, const tube_candidate& found, const tube_set& start) {
            return tube_ = rounding_.tube(by, found, start);
        });
    } else if (choice.keeps_tubes) {
        integrator_.prove_by([this](tube_proof& by, const tube_candidate& found, const tube_set& start) {
            return tube_ = by.tube(found, start, supremum_rule::coefficients);
        });
    }
    const precision_scope scope(decimal_digits(bits_));
    time_ = constant_value<ball>::of(system.point());
    add_starts(system, choice);
}

void certified_run::add_starts(const explicit_system& system, const run_choice& choice) {
    std::vector<ball> starts;
    for (const auto& values : system.starts()) {
        for (const number& each : values) {
            const auto open = std::ranges::find(choice.starts, starts.size(), &start_interval::place);
            starts.push_back(open == choice.starts.end()
                                 ? constant_value<ball>::of(each)
                                 : hull(from_rational<ball>(open->low), from_rational<ball>(open->high)));
        }
    }
    const std::size_t own = choice.varied ? starts.size() : 0;
    for (std::size_t k = 0; k < own; ++k) {
        starts.emplace_back(k == *choice.varied ? 1 : 0);
    }
    std::vector<magnitude> radii;
    for (const ball& each : starts) {
        given_.centre.push_back(midpoint_alone(each));
        radii.push_back(magnitude::radius_of(each));
    }
    given_.errors = lohner_set(std::move(radii));
    given_.slow = given_.centre.size();
}

long certified_run::bits_of_bounds() const { return bits_ + more_bits_of_bounds; }

bool certified_run::begin(const rational& farthest) {
    const precision_scope scope(decimal_digits(bits_));
    auto set = start_set();
    if (!set) {
        return false;
    }
    // The checker encloses the initial values in a box of about this size.
    std::vector<magnitude> added = set->errors.added();
    for (magnitude& each : added) {
        each += magnitude::of(1, 3 - bits_of_bounds());
    }
    set->errors = lohner_set(set->errors.columns(), set->errors.blocks(), set->errors.radii(), std::move(added));
    const ball rest = from_rational<ball>(farthest) - time_;
    integrator_.begin(time_, *set, first_length(set->centre, rest));
    farthest_ = farthest;
    start_ = counted_from_ = begin_.convert_to<double>();
    return prepare();
}

// The checker begins with the box of the enclosures of all unknowns, which matters if the given ones have a width.
std::optional<tube_set> certified_run::start_set() const {
    return begins_in_box_ ? box_of_start(form_, time_, given_.hull()) : lifted_set(form_, time_, given_);
}

bool certified_run::advance(const certificate_watch& watch) {
    const precision_scope scope(decimal_digits(bits_));
    begin_ += fraction_of(integrator_.length());
    integrator_.step();
    if (watch) {
        watch(integrator_.reached(), bits());
    }
    count_step();
    return prepare();
}

void certified_run::count_step() {
    if (++taken_ % steps_of_estimate == 0) {
        const auto now = begin_.convert_to<double>();
        const double length = std::abs(now - counted_from_) / steps_of_estimate;
        const double longest = std::max(length, std::abs(now - start_) / static_cast<double>(taken_));
        const double expected = static_cast<double>(taken_) + std::abs(farthest_.convert_to<double>() - now) / longest;
        if (length < growing * counted_length_ && expected > doubtful * most_certified_steps) {
            refuse_steps(expected, farthest_);
        }
        counted_from_ = now;
        counted_length_ = length;
    }
    if (taken_ >= most_certified_steps) {
        refuse_steps(static_cast<double>(taken_), farthest_);
    }
}

std::optional<std::vector<ball>> certified_run::at(const ball& time, const certificate_watch& watch) {
    const precision_scope scope(decimal_digits(bits_));
    for (;;) {
        const ball rest = time - integrator_.reached();
        if (certainly_less(abs(rest), abs(integrator_.length())) || arb_is_zero(rest.handle()) != 0) {
            return integrator_.values_at(rest);
        }
        if (!advance(watch)) {
            return std::nullopt;
        }
    }
}

bool certified_run::prepare() {
    if (!integrator_.prepare()) {
        return false;
    }
    if (rounding_.step()) {
        text_ += text_of(*rounding_.step());
        ++steps_;
    }
    return true;
}

// The reciprocal of the largest derivative of f, at most the remaining time; no proof depends on it.
ball certified_run::first_length(const std::vector<ball>& state, const ball& rest) const {
    std::vector<ball> constants;
    for (const number& each : map_.constants()) {
        constants.push_back(constant_value<ball>::of(each));
    }
    magnitude rate;
    for (const ball& each : map_.in(number_ring<ball>{constants, time_}, state, true).entries) {
        rate = std::max(rate, magnitude(each));
    }
    const bool backwards = arb_is_negative(rest.handle()) != 0;
    const ball whole = midpoint_alone(rest);
    if (rate.is_zero() || !rate.is_finite() || magnitude(whole) <= magnitude(1U) / rate) {
        return arb_is_zero(whole.handle()) != 0 ? ball(1) : whole;
    }
    const ball length = (magnitude(1U) / rate).exact();
    return backwards ? -length : length;
}

}  // namespace libration::ode
