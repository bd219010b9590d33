#include "eigenvalue_search.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/algebra/ball_matrix.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/scalar.hpp"

namespace libration::ode {

namespace {

constexpr long first_bits = 96;
constexpr long most_bits_of_count = 6144;
constexpr int most_moves = 6;
constexpr long bits_at_eigenvalue = 768;
constexpr long bits_of_move = 200;
constexpr int most_doublings = 60;
constexpr int most_quarterings = 7;
constexpr int most_bisections_of_index = 4000;
constexpr long narrow_bits = 24;
constexpr int most_steps_of_search = 400;
constexpr long bits_of_narrowing = 128;
constexpr long steps_of_a_run = 1000;
constexpr int most_narrowings = 60;
constexpr int most_widenings = 8;
constexpr long log2_of_widening = 6;
constexpr double slope_margin = 6;
constexpr double least_margin = 12;
constexpr long most_bits_of_digits = 400'000;

ball middle_of(const ball& a, const ball& b) { return exact_midpoint(ldexp(a + b, -1)); }

}  // namespace

eigenvalue_search::eigenvalue_search(well_problem of, std::function<void(long)> watch)
    : of_(std::move(of)), watch_(std::move(watch)) {}

ball eigenvalue_search::largest() const { return known_.rbegin()->first; }

long eigenvalue_search::below(ball& e) {
    long bits = first_bits;
    for (int move = 0; move < most_moves; ++move) {
        for (; bits <= most_bits_of_count; bits *= 2) {
            watch_(bits);
            const precision_scope scope(decimal_digits(bits));
            if (const auto n = of_.eigenvalues_below(e)) {
                known_.insert_or_assign(e, *n);
                return *n;
            }
            if (move == 0 && bits >= bits_at_eigenvalue) {
                break;  // E may be an eigenvalue
            }
        }
        const precision_scope scope(decimal_digits(bits_of_move + bits_at_eigenvalue));
        const ball size = abs(e) + ldexp(ball(1), -narrow_bits);
        e = exact_midpoint(e + ldexp(size, -bits_of_move - move));
    }
    throw error(error_kind::undecided, error_subject::problem, "",
                "has a number of eigenvalues below " + std::to_string(as_double(e)) + " that is not decided by " +
                    std::to_string(most_bits_of_count) + " bits");
}

bool eigenvalue_search::has(long count) {
    const precision_scope scope(decimal_digits(first_bits));
    const auto [least, size] = of_.bottom();
    if (known_.empty() || known_.begin()->second > 0) {
        ball e = exactly(std::isfinite(least) ? least - size : 0);
        if (const auto top = of_.continuum()) {
            const ball end = from_rational<ball>(*top);
            e = certainly_less(e, end) ? e : exact_midpoint(end - 1);
        }
        const ball first = e;
        for (int k = 0; below(e) > 0 && k < most_doublings; ++k) {
            e = exact_midpoint(first - ldexp(exactly(size), k));
        }
    }
    const ball first = known_.begin()->first;
    const auto top = of_.continuum();
    for (int k = 0; known_.rbegin()->second < count && !complete_; ++k) {
        ball e = exact_midpoint(first + ldexp(exactly(size), k));
        if (top) {
            const ball end = from_rational<ball>(*top);
            e = exact_midpoint(end - ldexp(end - first, -2 * (k + 1)));
        }
        below(e);
        complete_ = k + 1 == (top ? most_quarterings : most_doublings);
    }
    return known_.rbegin()->second >= count;
}

// Two numbers with index and index + 1 eigenvalues below them.
eigenvalue_search::bracket eigenvalue_search::isolated(long index) {
    for (int k = 0; k < most_bisections_of_index; ++k) {
        auto high = known_.begin();
        while (high->second <= index) {
            ++high;
        }
        const auto low = std::prev(high);
        if (low->second == index && high->second == index + 1) {
            return {low->first, high->first};
        }
        const precision_scope scope(decimal_digits(bits_at_eigenvalue));
        ball e = middle_of(low->first, high->first);
        if (known_.contains(e)) {
            break;
        }
        below(e);
    }
    throw error(error_kind::undecided, error_subject::problem, "",
                "has eigenvalues that are not told apart near " + std::to_string(as_double(known_.rbegin()->first)));
}

std::optional<ball> eigenvalue_search::value(const ball& e, long bits) {
    watch_(bits);
    const precision_scope scope(decimal_digits(bits));
    return of_.wronskian(e);
}

eigenvalue_search::iterate eigenvalue_search::first_iterate(const bracket& around) {
    const precision_scope scope(decimal_digits(bits_of_narrowing));
    const ball width = around.high - around.low;
    const double size = log_of(magnitude(width));
    iterate result{middle_of(around.low, around.high), ball(1), -1, size, size};
    for (long bits = bits_of_narrowing; bits <= most_bits_of_count; bits *= 2) {
        const auto low = value(around.low, bits);
        const auto high = value(around.high, bits);
        if (low && high && !contains_zero(*high - *low)) {
            result.slope = exact_midpoint((*high - *low) / width);
            break;
        }
    }
    return result;
}

// Regula falsi and bisection by turns.
eigenvalue_search::bracket eigenvalue_search::narrowed(bracket around, long index, long narrow) {
    long bits = bits_of_narrowing + 2 * narrow;
    const precision_scope scope(decimal_digits(bits));
    const bool rises = index % 2 != 0;                                 // the sign below is that of (-1)^index
    const ball least_size = ldexp(around.high - around.low, -narrow);  // for an eigenvalue 0
    auto at_low = value(around.low, bits);
    auto at_high = value(around.high, bits);
    for (int k = 0; k < most_steps_of_search; ++k) {
        const ball width = around.high - around.low;
        const ball size = abs(around.low) + abs(around.high) + least_size;
        if (certainly_less(ldexp(width, narrow), size)) {
            break;
        }
        ball e = middle_of(around.low, around.high);
        if (k % 3 != 2 && at_low && at_high && !contains_zero(*at_high - *at_low)) {
            const ball other = exact_midpoint(around.low - *at_low * width / (*at_high - *at_low));
            // Not too near to an end.
            const ball least = ldexp(width, -8);
            e = certainly_less(around.low + least, other) && certainly_less(other, around.high - least) ? other : e;
        }
        const auto w = value(e, bits);
        if (!w || contains_zero(*w)) {
            if (bits > most_bits_of_count) {
                break;
            }
            bits *= 2;
            continue;
        }
        const bool is_low = (arb_is_negative(w->handle()) != 0) == rises;
        (is_low ? around.low : around.high) = e;
        (is_low ? at_low : at_high) = w;
    }
    return around;
}

// The secant method, each step with the bits that it needs.
bool eigenvalue_search::improve(iterate& at, const bracket& around, long bits) {
    const precision_scope scope(decimal_digits(bits));
    const auto log2_of = [](const ball& x) { return log_of(magnitude(x)); };
    std::optional<std::pair<ball, ball>> last;
    long now = std::min(bits, first_bits);
    for (int k = 0; k < most_steps_of_search; ++k) {
        const auto w = value(at.e, now);
        const bool decided = w && !contains_zero(*w);
        if (w && !decided) {
            at.log2_error = std::min(at.log2_error, log2_of(*w) - log2_of(at.slope) + 1);
        }
        if (decided) {
            double slope_error = at.log2_slope_error;
            if (last && !contains_zero(at.e - last->first) && !contains_zero(*w - last->second)) {
                at.slope = exact_midpoint((*w - last->second) / (at.e - last->first));
                const double of_rounding =
                    std::max(log_of(magnitude::radius_of(*w)), log_of(magnitude::radius_of(last->second))) -
                    log2_of(*w - last->second);
                slope_error = std::max(of_rounding, log2_of(at.e - last->first)) + slope_margin;
            }
            at.log2_slope_error = std::min(slope_error, -1.);
            last = {at.e, *w};
            const ball step = exact_midpoint(*w / at.slope);
            const ball next = exact_midpoint(at.e - step);
            if (!certainly_less(around.low, next) || !certainly_less(next, around.high)) {
                return false;
            }
            at.e = next;
            const double of_rounding = log_of(magnitude::radius_of(*w)) - log2_of(at.slope);
            at.log2_error = std::max(log2_of(step) + at.log2_slope_error, of_rounding + 1);
        }
        const double size = std::max(log2_of(at.e), at.log2_least);
        const double least = size - static_cast<double>(bits) + least_margin;
        if (at.log2_error <= least || (!decided && now >= bits)) {
            return true;
        }
        const double known = size - at.log2_error;
        now = std::min(bits, decided ? std::max(now, static_cast<long>(2 * known) + first_bits) : 2 * now);
    }
    return false;
}

known_value eigenvalue_search::digits_of(long index, long digits) {
    const bracket whole = isolated(index);
    long narrow = narrow_bits;
    bracket around = narrowed(whole, index, narrow);
    iterate at = first_iterate(around);
    known_value kept;
    const bool rises = index % 2 != 0;
    const auto missing = prove_digits(digits, "eigenvalue", [&](const run_bits& run, run_demand& demand) {
        for (int k = 0; !improve(at, around, run.bits) && k < most_narrowings; ++k) {
            narrow += bits_of_narrowing / 2;
            around = narrowed(around, index, narrow);
            at = first_iterate(around);
        }
        const precision_scope scope(decimal_digits(run.bits));
        demand.cost(steps_of_a_run);
        const std::string name = std::to_string(index);
        // The signs on both sides.
        ball width = ldexp(ball(1), static_cast<long>(std::ceil(at.log2_error)) + 2);
        for (int k = 0; k < most_widenings; ++k, width = ldexp(width, log2_of_widening)) {
            const ball low = exact_midpoint(at.e - width);
            const ball high = exact_midpoint(at.e + width);
            const bool inside = certainly_less(whole.low, low) && certainly_less(high, whole.high);
            const auto at_low = value(inside ? low : whole.low, run.bits);
            const auto at_high = at_low ? value(inside ? high : whole.high, run.bits) : at_low;
            if (at_high && (rises ? certainly_less(*at_low, ball(0)) && certainly_less(ball(0), *at_high)
                                  : certainly_less(ball(0), *at_low) && certainly_less(*at_high, ball(0)))) {
                demand.improve(kept, inside ? hull(low, high) : hull(whole.low, whole.high), name, "E_" + name);
                return;
            }
        }
        demand.undecided(name, "has no digits that are decided by " + std::to_string(run.bits) + " bits",
                         most_bits_of_digits);
    });
    if (missing && !kept.decimal && kept.bound.empty()) {
        throw error(*missing);
    }
    return kept;
}

}  // namespace libration::ode
