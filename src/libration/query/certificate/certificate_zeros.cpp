#include "certificate_zeros.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certificate_format.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr int newton_steps = 3;
// The condition at both ends of an interval is about so many times 2^-1 its distance from the polynomial.
constexpr unsigned long margin_of_ends = 8;
// More bits if signs are not decided, which gives little information on how many are needed.
constexpr long bits_for_signs = 24;
// log2 of the width of an interval relative to the printed one, at least.
constexpr long least_width = -64;
constexpr double digits_of_bit = 0.30103;

// The form with the condition and its derivative as right-hand sides of two further unknowns.
polynomial_form with_condition_rows(const lifted_functions& of) {
    polynomial_form result = of.form;
    std::vector<expression> right = of.form.system.right();
    for (const expression& each : {of.functions.front(), of.slopes.front()}) {
        result.leaves.push_back(unknown("g" + std::to_string(result.leaves.size())));
        right.push_back(each);
    }
    result.system = explicit_system::first_order(result.leaves, std::move(right), of.form.system.point());
    return result;
}

std::vector<magnitude> larger_radii(const solution_tube& tube) {
    std::vector<magnitude> result;
    for (std::size_t b = 0; b < tube.blocks.size(); ++b) {
        result.push_back(std::max(tube.first[b], tube.last[b]));
    }
    return result;
}

magnitude size_of(const rational& x) { return magnitude(from_rational<ball>(x)); }

}  // namespace

zeros_on_steps::zeros_on_steps(const certified_zeros& of, const lifted_functions& form, bool vanishes, long bits)
    : of_(of),
      vanishes_(vanishes),
      bits_(bits),
      map_(with_condition_rows(form)),
      constants_(map_.enclosed_constants(bits)),
      forms_(bits),
      start_(*form.form.system.point().fraction()) {
    for (const ball& each : constants_) {
        constant_bounds_.emplace_back(each);
    }
}

long zeros_on_steps::lacking_bits_in(const solution_tube& tube, const rational& begin) {
    const precision_scope scope(decimal_digits(bits_));
    begin_ = begin;
    length_ = fraction_of(tube.on.length);
    follow(tube);
    while (intervals_.size() < of_.times.size()) {
        const decimal_interval& printed = of_.times[intervals_.size()];
        if (place_of((printed.low + printed.high) / 2) > 1) {
            break;
        }
        if (const long lacking = lacking_bits_of_next(); lacking > 0) {
            return lacking;
        }
    }
    for (std::size_t k = 0; k <= intervals_.size(); ++k) {
        const int alternating = k % 2 == 0 ? 1 : -1;
        std::vector<int> signs;
        if (const span gap = gap_before(k); gap.from <= gap.to) {
            signs.push_back(alternating * sign(gap));
        }
        if (const span in = k < intervals_.size() ? places_of(k) : span{1, -1}; in.from <= in.to) {
            signs.push_back(-alternating * sure(derivative_, in));
        }
        for (const int each : signs) {
            if (each == 0 || each == -sign_) {
                return bits_for_signs;
            }
            sign_ = each;
        }
    }
    return 0;
}

// The part of interval k in the step, in x; from > to if there is none.
zeros_on_steps::span zeros_on_steps::places_of(std::size_t k) const {
    const rational low = place_of(intervals_[k].low);
    const rational high = place_of(intervals_[k].high);
    return {std::max(rational(-1), std::min(low, high)), std::min(rational(1), std::max(low, high))};
}

// The part of the times between interval k and the one before it, or up to the end of the step.
zeros_on_steps::span zeros_on_steps::gap_before(std::size_t k) const {
    const auto [from, to] = [&]() -> std::pair<rational, rational> {
        const auto end = [&](std::size_t i, bool first) {
            return (length_ > 0) == first ? intervals_[i].low : intervals_[i].high;
        };
        const rational before = k == 0 ? start_ : end(k - 1, false);
        const bool last = k == of_.times.size();
        return {place_of(before), k < intervals_.size() ? place_of(end(k, true))
                                  : last                ? place_of(before)
                                                        : rational(1)};
    }();
    return {std::max(rational(-1), from), std::min(rational(1), to)};
}

// The condition and its derivative with respect to x on the step.
void zeros_on_steps::follow(const solution_tube& tube) {
    const std::size_t n = tube.curve.size();
    const ball half = shifted(tube.on.length, -1);
    const auto radii = larger_radii(tube);
    std::vector<ball_polynomial> curve(n + 2);
    std::vector<bounded_change> bounds(n + 2);
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<ball> row;
        for (std::size_t j = 0; j < n; ++j) {
            row.push_back(forms_.supremum(tube.frame[i * n + j]).exact());
        }
        curve[i] = shifted(tube.curve[i], tube.scales[i]);
        bounds[i] = {forms_.supremum(curve[i]), reach_of_row(row, tube.blocks, radii).shifted(tube.scales[i])};
    }
    const ball middle = tube.on.start + half;
    auto along = map_.in(polynomial_ring{constants_, {middle, half}}, curve, false).slopes;
    auto changes = map_.in(change_ring{constant_bounds_, magnitude(middle) + magnitude(half)}, bounds, false).slopes;
    along[n + 1] = multiple_of(half, along[n + 1]);
    changes[n + 1].change *= magnitude(half);
    const auto row = [&](std::size_t i) {
        const magnitude& change = changes[i].change;
        const magnitude reach = change + change.shifted(-8) + magnitude::of(1, 2 - bits_);
        return function_on_step{along[i], forms_.supremum(derivative_of(along[i])), reach};
    };
    function_ = row(n);
    derivative_ = row(n + 1);
}

// The interval of the next zero: decimals a little farther apart than the condition is known.
long zeros_on_steps::lacking_bits_of_next() {
    const decimal_interval& printed = of_.times[intervals_.size()];
    ball x = from_rational<ball>(place_of((printed.low + printed.high) / 2));
    for (int k = 0; k < newton_steps; ++k) {
        const ball slope = value_of(derivative_.on_curve, x);
        if (contains_zero(slope)) {
            return bits_for_signs;
        }
        x = midpoint_alone(x - value_of(function_.on_curve, x) / slope);
    }
    const magnitude slope = magnitude::below(value_of(derivative_.on_curve, x));
    if (slope.is_zero()) {
        return bits_for_signs;
    }
    const magnitude printed_width = size_of(printed.high - printed.low);
    const magnitude width = std::max(function_.reach * magnitude(margin_of_ends) / slope * size_of(length_ / 2),
                                     printed_width.shifted(least_width));
    const auto digits = static_cast<long>(std::floor(-log_of(width) * digits_of_bit));
    const rational power(pow(integer(10), static_cast<unsigned>(std::abs(digits))));
    const ball time = from_rational<ball>(begin_) + (x + 1L) * from_rational<ball>(length_ / 2);
    const integer units = nearest_integer(time * from_rational<ball>(digits < 0 ? rational(1 / power) : power));
    const auto interval = within_one_unit(units.str() + "e" + std::to_string(-digits), digits);
    if (interval.low < printed.low || interval.high > printed.high) {
        return std::max(2L, static_cast<long>(std::ceil(log_of(width) - log_of(printed_width))) + 4);
    }
    intervals_.push_back(interval);
    return 0;
}

// The sign on a part of the step by the value in the middle and the bounds of the step; 0 if they leave it open.
int zeros_on_steps::sure(const function_on_step& of, const span& in) const {
    const ball value = value_of(of.on_curve, from_rational<ball>((in.from + in.to) / 2));
    const magnitude open = of.slope * size_of((in.to - in.from) / 2) + of.reach;
    return open < magnitude::below(value) ? known_sign(value) : 0;
}

// That of the condition, by halves: on a part where it is monotone those at both ends suffice, and directly after an
// initial point at which it is 0 that of the derivative.
int zeros_on_steps::sign(const span& in) const {
    const int way = sure(derivative_, in);
    const bool begins = vanishes_ && begin_ == start_ && in.from == -1;
    const int left = begins ? way : sure(function_, {in.from, in.from});
    if (left == sure(function_, {in.to, in.to}) && (way != 0 || sure(function_, in) != 0)) {
        return left;
    }
    if (function_.slope * size_of(in.to - in.from) <= function_.reach) {
        return 0;
    }
    const rational middle = (in.from + in.to) / 2;
    const int first = sign({in.from, middle});
    return first != 0 && first == sign({middle, in.to}) ? first : 0;
}

std::optional<std::vector<ball>> zeros_on_steps::values_at(std::size_t k, const solution_tube& tube) {
    const span in = k < intervals_.size() ? places_of(k) : span{1, -1};
    if (in.from > in.to) {
        return std::nullopt;
    }
    const precision_scope scope(decimal_digits(bits_));
    const std::size_t n = tube.curve.size();
    const auto radii = larger_radii(tube);
    const magnitude half = size_of((in.to - in.from) / 2);
    const rational middle = (in.from + in.to) / 2;
    std::vector<ball> values = tube.values_at(from_rational<ball>((middle + 1) * length_ / 2));
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<ball> row;
        for (std::size_t j = 0; j < n; ++j) {
            const ball_polynomial& v = tube.frame[i * n + j];
            row.push_back((forms_.supremum(v) + forms_.supremum(derivative_of(v))).exact());
        }
        const magnitude slope = forms_.supremum(derivative_of(tube.curve[i])) + reach_of_row(row, tube.blocks, radii);
        values[i] = widened(values[i], (slope * half).shifted(tube.scales[i]));
    }
    return values;
}

bool zeros_on_steps::complete() const {
    return intervals_.size() == of_.times.size() &&
           std::max(place_of(intervals_.back().low), place_of(intervals_.back().high)) <= 1;
}

std::string zeros_on_steps::text() const {
    std::string lines;
    for (const decimal_interval& each : intervals_) {
        lines += "zero " + (length_ > 0 ? each.lower + " " + each.upper : each.upper + " " + each.lower) + "\n";
    }
    return lines;
}

}  // namespace libration::ode
