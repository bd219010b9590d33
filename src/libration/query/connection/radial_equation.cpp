#include "radial_equation.hpp"

#include <algorithm>
#include <cmath>

#include "../../algebra/dense_matrix.hpp"
#include "layer_text.hpp"
#include "libration/equation/identities.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long highest_exponent_of_field = 9;
constexpr int log2_of_rough_start = 10;

bool is_small_natural(const rational& q) { return q >= 0 && q <= highest_exponent_of_field && denominator(q) == 1; }

unsigned natural(const rational& q) { return static_cast<unsigned>(static_cast<long>(numerator(q))); }

expression natural_power(const expression& base, const rational& exponent) {
    return exponent == 0 ? expression(1) : exponent == 1 ? base : pow(base, expression(exponent));
}

bool is_typed_limit(const limit_condition& each) {
    return each.direction > 0 && !each.exponentially && !each.fast &&
           (each.of.derivative() == 0 || (each.of.derivative() == 1 && is_identically_zero(each.value)));
}

[[noreturn]] void refuse_radial_start(const std::string& reason) {
    throw error(error_kind::undecided, error_subject::problem, "", reason);
}

// -k of u'/t, or l of u/t^2.
expression factor_in(const radial_equation& of, long time, long value, long slope) {
    for (const power_term& each : of.text.terms) {
        if (each.time == time && each.value == value && each.slope == slope) {
            return each.factor;
        }
    }
    return expression(0);
}

void require_regular(radial_equation& of) {
    const expression k = -factor_in(of, -1, 0, 1);
    const expression l = factor_in(of, -2, 1, 0);
    for (const power_term& each : of.text.terms) {
        const bool is_linear = (each.time == -1 && each.value == 0 && each.slope == 1) ||
                               (each.time == -2 && each.value == 1 && each.slope == 0);
        if (!is_linear && each.time != 0) {
            refuse_radial_start(
                "has other terms at t = 0 than multiples of u'/t and u/t^2 that are not regular there: choose a later "
                "initial point");
        }
    }
    of.power = l.is(0) ? 0 : 1;
    const auto& starts = of.text.open.starts;
    const std::size_t given = of.power == 0 ? 1 : 0;
    const auto spread = k.fraction();
    if ((of.power == 1 && !is_identically_zero(k - l)) || !spread || !(*spread + 2 * of.power - 1 >= 0)) {
        refuse_radial_start(
            "has terms u'/t and u/t^2 whose solutions at t = 0 are not supported for limits at infinity: choose a "
            "later initial point");
    }
    if (!starts[given].is(0) || !same_form(starts[1 - given], of.text.open.leaves.front())) {
        refuse_radial_start(
            "has initial values at t = 0 of which one is not the unknown and the other one 0: give " +
            std::string(of.power == 0 ? "u'(0) = 0 and --unknown u(0)" : "u(0) = 0 and --unknown u'(0)") +
            " for its u");
    }
    for (const power_term& each : of.text.terms) {
        if (each.time == 0 && of.power == 0 && each.slope > 1) {
            refuse_radial_start("has a power of u' at t = 0 that is not supported there: choose a later initial point");
        }
    }
}

}  // namespace

saddle_equation radial_equation::at_infinity() const {
    saddle_equation result{{}, number_in(limit)};
    for (const power_term& each : text.terms) {
        result.terms.push_back({number_in(each.factor), natural(-each.time), natural(each.value), natural(each.slope)});
    }
    return result;
}

std::optional<radial_equation> radial_equation_in(const connection_question& question) {
    const auto& limits = question.limits;
    if (limits.empty() || question.unknowns.size() != 1 || !std::ranges::all_of(limits, is_typed_limit)) {
        return std::nullopt;
    }
    const auto limit = std::ranges::find_if(limits, [](const auto& each) { return each.of.derivative() == 0; });
    if (limit == limits.end()) {
        return std::nullopt;
    }
    const std::string name = limit->of.name();
    auto read = power_terms_in(question, name);
    if (!read) {
        return std::nullopt;
    }
    const auto is_number = [](const expression& e) { return e.is_constant() && !e.has_parameters(); };
    bool has_time = false;
    for (const power_term& each : read->terms) {
        if (!is_small_natural(-each.time) || !is_small_natural(each.value) || !is_small_natural(each.slope) ||
            !is_number(each.factor)) {
            return std::nullopt;
        }
        has_time = has_time || each.time != 0;
    }
    const auto values = opened(question.system, question.unknowns, {limit->value}).others;
    if (!has_time || !is_number(values.front()) || read->open.system.point().sign() < 0) {
        return std::nullopt;
    }
    radial_equation result{*std::move(read), name, values.front()};
    result.starts_at_zero = result.text.open.system.point().sign() == 0;
    if (result.starts_at_zero) {
        require_regular(result);
    }
    return result;
}

differentiable_start rough_start(const radial_equation& of, const ball& x) {
    const ball t = exactly(std::ldexp(1., -log2_of_rough_start));
    const ball w = ball(1) / t;
    ball bend(0);
    ball spread(1);
    for (const auto& each : of.at_infinity().terms) {
        if (each.w == 0 && each.v == 0) {
            bend += each.factor * pow(x, static_cast<long>(each.u));
        } else if (each.w == 1 && each.u == 0 && each.v == 1) {
            spread -= each.factor;
        }
    }
    const ball c = bend / (spread * 2);
    const ball_matrix none(3, std::vector<ball>{ball(0)});
    return of.power == 0 ? differentiable_start{{x + c * t * t, c * t * 2, w}, none}
                         : differentiable_start{{x * t, x, w}, none};
}

connection_question far_question(const radial_equation& of, const connection_question& typed) {
    const expression u = unknown("u");
    const expression v = unknown("v");
    const expression w = unknown("w");
    expression slope(0);
    for (const power_term& each : of.text.terms) {
        slope = slope + each.factor * natural_power(w, rational(-each.time)) * natural_power(u, each.value) *
                            natural_power(v, each.slope);
    }
    const auto in_x = [&](const expression& e) {
        return replaced(e, [&](const expression& leaf) {
            return same_form(leaf, of.text.open.leaves.front()) ? std::optional(parameter(radial_unknown))
                                                                : std::nullopt;
        });
    };
    connection_question result{{}, {radial_unknown}, {}, {}, typed.digits};
    result.system.add(derivative(u), v).add(derivative(v), slope).add(derivative(w), -w * w);
    result.system.begin(u, in_x(of.text.open.starts[0])).begin(v, in_x(of.text.open.starts[1]));
    result.system.begin(w, of.starts_at_zero ? expression(1) : 1 / expression(of.text.open.system.point()));
    result.system.set(radial_unknown, expression(of.text.open.values.front()));
    result.limits = {{u, of.limit}, {v, 0}, {w, 0}};
    return result;
}

connection_question regular_question(const radial_equation& of, const connection_question& typed) {
    const expression g = unknown("g");
    const expression h = unknown("h");
    const expression t = unknown("t");
    const rational n(of.power);
    expression slope = (factor_in(of, -1, 0, 1) - expression(rational(2 * n - 1))) * h;
    for (const power_term& each : of.text.terms) {
        if (each.time == 0) {
            slope = slope + each.factor * natural_power(t, rational(2 - n + n * each.value + (n - 1) * each.slope)) *
                                natural_power(g, each.value) * natural_power(expression(n) * g + h, each.slope);
        }
    }
    connection_question result{{}, {radial_unknown}, {}, {}, typed.digits};
    result.system.variable = "s";
    result.system.add(derivative(g), h).add(derivative(h), slope).add(derivative(t), t);
    result.system.begin(g, parameter(radial_unknown)).begin(h, 0).begin(t, 0);
    result.system.set(radial_unknown, expression(of.text.open.values.front()));
    result.limits = {{g, parameter(radial_unknown), -1}, {h, 0, -1}, {t, 0, -1}};
    return result;
}

}  // namespace libration::ode
