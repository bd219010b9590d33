#include "power_equation.hpp"

#include <algorithm>
#include <numeric>

#include "../../equation/power_sum.hpp"
#include "layer_text.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/identities.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long largest_root_of_time = 12;
constexpr long bits_of_power_equation = 192;

bool is_natural_power(const rational& q) { return q >= 0 && denominator(q) == 1; }

expression raised_to(const expression& base, const rational& exponent) {
    return exponent == 0 ? expression(1) : exponent == 1 ? base : pow(base, expression(exponent));
}

// What the objects of a product are.
struct named_leaves {
    expression value, slope;
};

// Multiplies a term by a power of an object; false if it is none of t, y, y' and constants.
bool multiply_by(power_term& term, const power_sums::base& base, const rational& exponent, const named_leaves& leaves) {
    if (base.as_sum && !base.typed.is_constant()) {
        return false;
    }
    if (same_form(base.typed, variable())) {
        term.time += exponent;
    } else if (same_form(base.typed, leaves.value)) {
        term.value += exponent;
    } else if (same_form(base.typed, leaves.slope)) {
        term.slope += exponent;
    } else {
        term.factor = term.factor * raised_to(base.typed, exponent);
        return !base.typed.has_variable() && is_identically_zero(partial(base.typed, leaves.value)) &&
               is_identically_zero(partial(base.typed, leaves.slope));
    }
    return true;
}

std::optional<std::vector<power_term>> power_terms_of(const expression& e, const named_leaves& leaves) {
    power_sums sums;
    std::vector<power_term> result;
    try {
        for (const auto& [product, factor] : sums.of(e)) {
            power_term term{expression(factor), 0, 0, 0};
            for (const auto& [base, exponent] : product) {
                if (!multiply_by(term, sums.bases()[base], exponent, leaves)) {
                    return std::nullopt;
                }
            }
            if (!is_natural_power(term.slope)) {
                return std::nullopt;
            }
            const auto same = std::ranges::find_if(result, [&](const power_term& each) {
                return each.time == term.time && each.value == term.value && each.slope == term.slope;
            });
            if (same != result.end()) {
                same->factor = same->factor + term.factor;
            } else {
                result.push_back(term);
            }
        }
    } catch (const no_power_sum&) {
        return std::nullopt;
    }
    return result;
}

bool is_limit_of_decay(const limit_condition& each) {
    return each.direction > 0 && !each.exponentially && !each.fast && each.of.derivative() <= 1 &&
           is_identically_zero(each.value);
}

// -m - m^2 + sum c (-m)^r of constant terms + limit (-m)^r = 0.
expression limit_for(const power_equation& of) {
    const expression rest(rational(-of.decay));
    expression sum(rational(of.decay * (of.decay + 1)));
    for (const power_term& each : of.terms) {
        if (each.is_constant()) {
            sum = sum - each.factor * raised_to(rest, each.slope);
        }
    }
    return sum / raised_to(rest, of.terms[of.leading].slope);
}

bool is_certainly_positive(const expression& e) {
    if (!e.is_constant() || e.has_parameters()) {
        return false;
    }
    const precision_scope scope(decimal_digits(bits_of_power_equation));
    return arb_is_positive(number_in(e).handle()) != 0;
}

// Whether c t^w y^q cannot have this limit, because y^q > 0.
bool has_other_sign(const power_term& term, const expression& limit) {
    const rational q = term.weight_of_value();
    const bool is_odd = denominator(q) == 1 && numerator(q) % 2 != 0;
    return !is_odd && is_certainly_positive(-term.factor * limit);
}

// Whether all other terms become small compared with this one, or stay in proportion by constant factors.
bool is_leading(power_equation& of, std::size_t i) {
    const power_term& first = of.terms[i];
    if (first.weight_of_value() == 0) {
        return false;
    }
    of.leading = i;
    of.decay = first.weight_of_time() / first.weight_of_value();
    if (!(of.decay > 0)) {
        return false;
    }
    for (std::size_t j = 0; j < of.terms.size(); ++j) {
        if (j != i && !of.terms[j].is_constant() &&
            !(of.terms[j].weight_of_time() < of.terms[j].weight_of_value() * of.decay)) {
            return false;
        }
    }
    of.limit = limit_for(of);
    return !is_identically_zero(of.limit) && !has_other_sign(first, of.limit);
}

}  // namespace

expression power_term::at(const expression& t, const expression& y) const {
    return factor * raised_to(t, weight_of_time()) * raised_to(y, weight_of_value());
}

bool power_equation::is_autonomous() const {
    return std::ranges::all_of(terms, [](const power_term& each) { return each.time == 0; });
}

long power_equation::root() const {
    long result = 1;
    for (const power_term& each : terms) {
        result = std::lcm(result, static_cast<long>(denominator(each.time)));
    }
    return result;
}

bool power_equation::is_monotone() const {
    const bool start_is_given = open.starts[0].is_constant() && is_certainly_positive(open.starts[0]);
    return start_is_given && std::ranges::all_of(terms, [](const power_term& each) {
               if (each.slope == 1) {
                   return each.value == 0 && each.time == -1 && each.factor.is_constant();
               }
               return each.slope == 0 && each.value > 0 && is_certainly_positive(each.factor);
           });
}

std::optional<power_terms> power_terms_in(const connection_question& question, const std::string& name) {
    power_terms result{opened(question.system, question.unknowns), {}};
    const first_order_form form(result.open.system);
    const auto constant = [&](std::size_t k) { return form.slopes[k].is(0); };
    if (form.names.size() < 2 || form.names[0] != name || form.names[1] != primed(name, 1) ||
        !same_form(form.slopes[0], form.leaves[1])) {
        return std::nullopt;
    }
    for (std::size_t k = 2; k < form.leaves.size(); ++k) {
        if (!constant(k)) {
            return std::nullopt;
        }
    }
    const auto in_numbers = replaced(form.slopes[1], [&](const expression& leaf) -> std::optional<expression> {
        for (std::size_t k = 2; k < form.leaves.size(); ++k) {
            if (same_form(leaf, form.leaves[k])) {
                return parameter(form.names[k]);
            }
        }
        return std::nullopt;
    });
    auto terms = power_terms_of(in_numbers, {form.leaves[0], form.leaves[1]});
    if (!terms) {
        return std::nullopt;
    }
    for (power_term& each : *terms) {
        each.factor = replaced(each.factor, [&](const expression& leaf) -> std::optional<expression> {
            for (std::size_t k = 2; k < form.leaves.size(); ++k) {
                if (same_form(leaf, parameter(form.names[k]))) {
                    return result.open.starts[k];
                }
            }
            return std::nullopt;
        });
    }
    result.terms = *std::move(terms);
    return result;
}

std::optional<power_equation> power_equation_in(const connection_question& question) {
    const auto& limits = question.limits;
    if (limits.empty() || !std::ranges::all_of(limits, is_limit_of_decay) ||
        std::ranges::none_of(limits, [](const auto& each) { return each.of.derivative() == 0; })) {
        return std::nullopt;
    }
    const std::string name = limits.front().of.name();
    auto read = power_terms_in(question, name);
    if (!read) {
        return std::nullopt;
    }
    power_equation result{std::move(read->open), name, std::move(read->terms), 0, {}, {}};
    // A decay that the equation itself determines rather than one that a given function of the time causes.
    for (const bool is_given : {false, true}) {
        for (std::size_t i = 0; i < result.terms.size(); ++i) {
            const power_term& each = result.terms[i];
            if ((each.value == 0 && each.slope == 0) == is_given && is_leading(result, i)) {
                return result.root() <= largest_root_of_time ? std::optional(result) : std::nullopt;
            }
        }
    }
    return std::nullopt;
}

std::vector<expression> logarithmic_state(const power_equation& of, const expression& time, const expression& value,
                                          const expression& slope) {
    std::vector<expression> result{time * slope / value};
    for (const power_term& each : of.terms) {
        if (!each.is_constant()) {
            result.push_back(each.at(time, value));
        }
    }
    return result;
}

connection_question logarithmic_question(const power_equation& of, const std::vector<std::string>& names,
                                         const expression& time, const expression& value, const expression& slope) {
    const auto in_parameters = [&](const expression& e) {
        return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
            for (std::size_t i = 0; i < names.size(); ++i) {
                if (same_form(leaf, of.open.leaves[i])) {
                    return parameter(names[i]);
                }
            }
            return std::nullopt;
        });
    };
    connection_question result{{}, names, {}, {}, 0};
    result.system.variable = "s";
    const expression z = unknown("z of log t");  // no name of a problem has blanks
    const auto limited = [&](const expression& leaf, const expression& limit) {
        result.limits.push_back({.of = leaf, .value = in_parameters(limit), .text = leaf.name() + "(inf)"});
    };
    expression slope_of_z = z - z * z;
    std::vector<expression> leaves{z};
    std::vector<expression> slopes{z};  // of z at last
    limited(z, expression(rational(-of.decay)));
    for (std::size_t i = 0; i < of.terms.size(); ++i) {
        const power_term& each = of.terms[i];
        if (each.is_constant()) {
            slope_of_z = slope_of_z + in_parameters(each.factor) * raised_to(z, each.slope);
            continue;
        }
        leaves.push_back(unknown("v" + std::to_string(i) + " of log t"));
        const expression& v = leaves.back();
        slope_of_z = slope_of_z + v * raised_to(z, each.slope);
        slopes.push_back((expression(each.weight_of_time()) + expression(each.weight_of_value()) * z) * v);
        limited(v, i == of.leading ? of.limit : expression(0));
    }
    slopes.front() = slope_of_z;
    const auto starts = logarithmic_state(of, time, value, slope);
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        result.system.add(derivative(leaves[k]), slopes[k]);
        result.system.begin(leaves[k], in_parameters(starts[k]));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        result.system.set(names[i], expression(of.open.values[i]));
    }
    return result;
}

}  // namespace libration::ode
