#include "exact_zero.hpp"

#include <algorithm>
#include <iterator>

#include "libration/equation/constant_value.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int highest_order = 8;
constexpr long bits_of_neighbourhood = 16;

// The fraction with the least denominator between two numbers: their common integer part, and the inverse of the one
// between the inverses of what remains.
rational simplest_between(const rational& low, const rational& high) {
    integer whole;
    mpz_fdiv_q(whole.backend().data(), mpq_numref(low.backend().data()), mpq_denref(low.backend().data()));
    if (low == whole) {
        return low;
    }
    return high >= whole + 1
               ? rational(whole + 1)
               : rational(whole + 1 / simplest_between(rational(1 / (high - whole)), rational(1 / (low - whole))));
}

rational fraction_of(const ball& exact) {
    rational value;
    mpfr_get_q(value.backend().data(), handle(midpoint_of(exact)));
    return value;
}

}  // namespace

std::vector<number> simple_numbers_in(const ball& times) {
    std::vector<number> all;
    for (const unit measure : {unit::one, unit::pi}) {
        const ball within = times / constant_value<ball>::of(number(1, measure));
        all.emplace_back(simplest_between(fraction_of(lower_bound(within)), fraction_of(upper_bound(within))), measure);
    }
    return all;
}

bool is_exact_zero(const expression& g, const number& time) try {
    const expression here = replaced(g, [&](const expression&) { return std::optional(expression(time)); });
    return here.kind() == node_kind::constant && here.constant().sign() == 0;
} catch (const error&) {  // not decided, or outside the domain of a function
    return false;
}

std::optional<exact_zero> exact_zero_near(const expression& g, const ball& times) {
    if (g.has_unknowns() || !is_finite(times)) {
        return std::nullopt;
    }
    std::vector<number> candidates = simple_numbers_in(times);
    const ball around = widened(times, magnitude(times).shifted(-bits_of_neighbourhood));
    std::ranges::copy(simple_numbers_in(around), std::back_inserter(candidates));
    candidates.emplace_back();  // 0, which no ball next to it contains
    for (const number& each : candidates) {
        const ball both = hull(times, constant_value<ball>::of(each));
        const auto value = [&](const expression& e) { return expression_values<ball>({}, both).of(e); };
        expression derivative = g;
        int order = 0;
        while (order <= highest_order && is_exact_zero(derivative, each)) {
            derivative = partial(derivative, variable());
            ++order;
        }
        const bool higher = order > 1 && order <= highest_order && is_finite(value(g));
        if (const int sign = higher ? known_sign(value(derivative)) : 0; sign != 0) {
            return exact_zero{each, order, sign};
        }
    }
    return std::nullopt;
}

}  // namespace libration::ode
