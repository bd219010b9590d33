#include "orbit_map.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr double most_parts_of_period = 20'000;
constexpr int most_halvings_of_step = 8;

bool is_prime(long n) {
    for (long k = 2; k * k <= n; ++k) {
        if (n % k == 0) {
            return false;
        }
    }
    return n > 1;
}

bool are_apart(const std::vector<ball>& a, const std::vector<ball>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!contains_zero(a[i] - b[i])) {
            return true;
        }
    }
    return false;
}

// Whether a step avoids a state between two distances, in halves of halves.
bool avoids(const step& along, const std::vector<ball>& state, const ball& from, const ball& to, int halvings) {
    if (are_apart(along.values(hull(from, to)), state)) {
        return true;
    }
    const ball middle = exact_midpoint((from + to) / 2);
    return halvings > 0 && avoids(along, state, from, middle, halvings - 1) &&
           avoids(along, state, middle, to, halvings - 1);
}

}  // namespace

// A time during which the solution does not return, at most an eighth of the period or a step more; 0 if none is proved.
ball orbit_map::time_away(step_sequence& along, const std::vector<ball>& start, const ball& period) const {
    const step* here = along[0];
    if (here == nullptr) {
        return ball(0);
    }
    ball from = here->length();
    const auto is_still_monotone = [&] {
        const auto slopes = form_.slopes_at(here->values(hull(ball(0), from)), ball(0));
        return !std::ranges::all_of(slopes, [](const ball& slope) { return contains_zero(slope); });
    };
    for (int k = 0; !is_still_monotone(); ++k) {
        if (k == most_halvings_of_step) {
            return ball(0);
        }
        from = exact_midpoint(from / 2);
    }
    ball away = from;
    for (std::size_t k = 0; here != nullptr; here = along[++k]) {
        if (!avoids(*here, start, k == 0 ? from : ball(0), here->length(), most_halvings_of_step)) {
            break;
        }
        away = here->end_time() - along[0]->from().time;
        if (certainly_less(period, away * 8)) {
            break;
        }
    }
    return away;
}

std::vector<ball> orbit_map::start_at(const std::vector<ball>& x) const {
    std::vector<ball> start;
    for (const number& each : form_.starts) {
        start.push_back(constant_value<ball>::of(each));
    }
    for (std::size_t k = 0; k < conditions_.free.size(); ++k) {
        start[conditions_.free[k]] = x[k];
    }
    return start;
}

ball orbit_map::period_at(const std::vector<ball>& x) const {
    return conditions_.is_period_free ? x.back() : constant_value<ball>::of(period_);
}

// Newton's method may leave for any period, up to which an integration would not end.
void orbit_map::require_near_guess(const ball& period) const {
    const ball guess = constant_value<ball>::of(period_);
    if (certainly_less(period * 2, guess) || certainly_less(guess * 2, period)) {
        throw error(error_kind::undecided, error_subject::solution, "",
                    "was not found: Newton's method left the neighbourhood of the closest return, from the period " +
                        to_decimal(midpoint_of(guess), 6) + " to " + to_decimal(midpoint_of(period), 6) +
                        ": choose an initial point nearer to a periodic orbit");
    }
}

std::optional<orbit_end> orbit_map::end_after(const std::vector<ball>& start, const ball& time, long bits,
                                              long error_bits) const {
    proved_march march(system_, start, bits, error_bits, watch_, route_);
    march.keep_derivative();
    const ball target = march.reached() + time;
    auto state = march.at(target);
    if (!state) {
        return std::nullopt;
    }
    auto slope = form_.slopes_at(*state, target);
    return orbit_end{start, *std::move(state), std::move(slope), march.derivative_at(target)};
}

std::optional<orbit_end> orbit_map::end_at(const std::vector<ball>& x, long bits, long error_bits) const {
    const precision_scope scope(decimal_digits(bits));
    const ball period = period_at(x);
    require_near_guess(period);
    return end_after(start_at(x), conditions_.reversal.empty() ? period : period / 2, bits, error_bits);
}

std::optional<orbit_end> orbit_map::end_of_period(const std::vector<ball>& x, long bits, long error_bits) const {
    const precision_scope scope(decimal_digits(bits));
    return end_after(start_at(x), period_at(x), bits, error_bits);
}

std::optional<enclosed_map> orbit_map::operator()(const std::vector<ball>& x, long bits, long error_bits) const {
    const precision_scope scope(decimal_digits(bits));
    const auto end = end_at(x, bits, error_bits);
    if (!end) {
        return std::nullopt;
    }
    const bool half = !conditions_.reversal.empty();
    enclosed_map result;
    for (const std::size_t i : conditions_.rows) {
        result.value.push_back(half ? end->state[i] : end->state[i] - end->start[i]);
        auto& row = result.derivative.emplace_back();
        for (const std::size_t j : conditions_.free) {
            row.push_back(i == j && !half ? end->flow[i][j] - 1 : end->flow[i][j]);
        }
        if (conditions_.is_period_free) {
            row.push_back(half ? end->slope[i] / 2 : end->slope[i]);
        }
    }
    return result;
}

bool orbit_map::all_conditions_follow(const orbit_end& end) const {
    if (conditions_.dropped.empty()) {
        return true;
    }
    // Every point of the segment is in these balls, and the matrix of integrals of its entries is in that of balls.
    expression_values<ball> values(form_.leaves, ball(0));
    for (std::size_t i = 0; i < end.start.size(); ++i) {
        const bool kept = std::ranges::find(conditions_.dropped, i) == conditions_.dropped.end();
        if (conditions_.reversal.empty()) {
            values.push_back(kept ? end.start[i] : hull(end.start[i], end.state[i]));
        } else {
            values.push_back(conditions_.reversal[i] > 0 ? end.state[i] : kept ? ball(0) : hull(ball(0), end.state[i]));
        }
    }
    dense_matrix matrix(conditions_.dropped.size(), conditions_.dropped.size());
    for (std::size_t i = 0; i < conditions_.integrals.size(); ++i) {
        for (const expression& each : conditions_.integrals[i].gradient) {
            if (!is_finite(values.of(each))) {
                return false;
            }
        }
        for (std::size_t j = 0; j < conditions_.dropped.size(); ++j) {
            matrix(i, j) = values.of(conditions_.integrals[i].gradient[conditions_.dropped[j]]);
        }
    }
    return inverse(matrix).has_value();
}

bool orbit_map::is_shortest_period(const std::vector<ball>& x, long bits) const {
    const precision_scope scope(decimal_digits(bits));
    const auto start = start_at(x);
    const ball period = period_at(x);
    try {
        const run_bits of_run{bits, run_bits::usual_error_bits};
        const ball origin = constant_value<ball>::of(system_.point());
        integration along({origin, box_around(start, bits)}, rule_for(system_, of_run, route_), origin + period, bits);
        const ball away = time_away(along, start, period);
        if (contains_zero(away)) {
            return false;
        }
        const double most_parts = std::floor(as_double(upper_bound(period / away))) + 1;
        if (!(most_parts < most_parts_of_period)) {
            return false;
        }
        const long parts = static_cast<long>(most_parts);
        proved_march march(system_, start, bits, run_bits::usual_error_bits, watch_, route_);
        for (long p = parts; p > 1; --p) {
            if (!is_prime(p)) {
                continue;
            }
            const auto state = march.at(ball(origin + period / p));
            const bool apart = state && are_apart(*state, start);
            if (!apart) {
                return false;
            }
        }
        return true;
    } catch (const precision_exhausted&) {
        return false;
    }
}

}  // namespace libration::ode
