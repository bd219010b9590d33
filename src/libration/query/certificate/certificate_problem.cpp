#include "certificate_problem.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "../../equation/formula_text.hpp"
#include "certificate_format.hpp"
#include "certificate_limits.hpp"
#include "libration/equation/node_values.hpp"

namespace libration::ode {

namespace {

constexpr int most_certified_power = 100;
constexpr unsigned most_exponent_bits = 1000;

// Formulas of expressions, with these names of the unknowns.
class certified_formula {
public:
    certified_formula(std::string variable, std::map<std::string, std::string> names)
        : variable_(std::move(variable)), names_(std::move(names)) {}

    std::string of(const expression& whole) const {
        node_values<formula_part> done;
        std::string text = done.of(whole, [&](const expression& e) { return limited(text_of(e, done)); }).text;
        require_certified_formula(text);
        return text;
    }

private:
    static formula_part limited(formula_part made) {
        if (made.text.size() > longest_certified_formula) {
            require_certified_formula(made.text);
        }
        return made;
    }

    formula_part text_of(const expression& e, const node_values<formula_part>& done) const {
        switch (e.kind()) {
            case node_kind::constant: return text_of_constant(e);
            case node_kind::variable: return {variable_};
            case node_kind::unknown:
            case node_kind::parameter: return {names_.at(primed(e.name(), e.derivative()))};
            case node_kind::sum:
            case node_kind::product:
            case node_kind::quotient: return text_of_arithmetic(e, done.at(e.left()), done.at(e.right()));
            case node_kind::power: return power(done.at(e.left()), e.right());
            case node_kind::function: break;
        }
        return function(e, done.at(e.left()));
    }

    static formula_part text_of_constant(const expression& e) {
        const auto q = e.fraction();
        if (!q) {
            refuse_certificate("contains only fractions as constants, and these equations have another one",
                               "replace it by a fraction, or leave the certificate out");
        }
        return text_of_fraction(*q);
    }

    static formula_part power(const formula_part& base, const expression& exponent) {
        const formula_part by = text_of_constant(exponent);
        const rational r = abs(*exponent.fraction());
        if ((denominator(r) == 1 && r > most_certified_power) ||
            msb(integer(numerator(r) * denominator(r) + 1)) >= most_exponent_bits) {
            refuse_certificate("contains whole powers up to " + std::to_string(most_certified_power) +
                                   ", and these equations have ^" + by.text.substr(0, 20),
                               "write it as a product of powers, or leave the certificate out");
        }
        return text_of_power(base, by);
    }

    static formula_part function(const expression& e, const formula_part& argument) {
        if (e.function() == function_kind::sqrt) {
            return {argument.within(binding::operand) + "^(1/2)", binding::power};
        }
        constexpr std::array contained{function_kind::exp, function_kind::log, function_kind::sin, function_kind::cos};
        if (std::ranges::find(contained, e.function()) != contained.end()) {
            return {std::string(name_of(e.function())) + "(" + argument.text + ")"};
        }
        const bool relative = e.function() == function_kind::cosrel || e.function() == function_kind::exprel;
        refuse_certificate("contains the functions exp, log, sin, cos, sqrt and powers, and these equations have " +
                               std::string(name_of(e.function())) +
                               (relative ? ", the form of quotients with a removable singularity, as sin(y)/y" : ""),
                           "leave it out");
    }

    std::string variable_;
    std::map<std::string, std::string> names_;
};

// A fraction, or a multiple of pi.
std::string start_text(const number& value, const std::string& name) {
    const auto plain = value.plain();
    if (plain && plain->measure == unit::one) {
        require_certified_formula(plain->coefficient.str());
        return plain->coefficient.str();
    }
    if (plain && plain->measure == unit::pi) {
        require_certified_formula(plain->coefficient.str());
        return plain->coefficient.str() + "*pi";
    }
    refuse_certificate(
        "contains fractions and multiples of pi as initial values, and that of " + name + " is another number",
        "replace it by a fraction, or leave the certificate out");
}

}  // namespace

std::vector<std::string> certified_names(const explicit_system& system, const certified_statement& statement) {
    auto names = names_of_state(system);
    const std::size_t own = statement.varied ? names.size() : 0;
    for (std::size_t k = 0; k < own; ++k) {
        names.push_back("d(" + names[k] + ")");
    }
    return names;
}

bool holds_at_start(const explicit_system& system, const expression& condition) {
    bool exact = true;
    const expression at_start = replaced(condition, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return expression(system.point());
        }
        const std::size_t i = places_of(system.unknowns()).at(leaf.name());
        const number& value = system.starts()[i][static_cast<std::size_t>(leaf.derivative())];
        exact = exact && value.fraction().has_value();
        return expression(value);
    });
    node_values<bool> seen;
    seen.of(condition, [&](const expression& e) {
        const auto exponent = e.kind() == node_kind::power ? e.right().fraction() : rational(1);
        exact = exact && e.kind() != node_kind::function && exponent && denominator(*exponent) == 1;
        return true;
    });
    if (at_start.is(0) && !exact) {
        refuse_certificate("contains conditions that hold at the initial point if its values are fractions there",
                           "choose another initial point");
    }
    return at_start.is(0);
}

std::string problem_of_certificate(const explicit_system& system, const polynomial_form& form,
                                   const certified_statement& statement) {
    const auto point = system.point().fraction();
    if (!point) {
        refuse_certificate("contains a fraction as initial time, and this one is another number",
                           "choose a fraction, or leave the certificate out");
    }
    require_certified_formula(point->str());
    require_certified_name(system.variable());
    for (const unknown_function& each : system.unknowns()) {
        require_certified_name(each.name);
    }
    const auto state = names_of_state(system);
    std::map<std::string, std::string> names;
    for (const std::string& each : state) {
        names.emplace(each, each);
    }
    const certified_formula in_state(system.variable(), names);
    std::string text = "variable " + system.variable() + "\nat " + point->str() + "\n";
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        const unknown_function& each = system.unknowns()[i];
        text += "equation " + primed(each.name, each.order) + " = " + in_state.of(system.right()[i]) + "\n";
    }
    std::size_t place = 0;
    for (const auto& values : system.starts()) {
        for (const number& each : values) {
            const auto open = std::ranges::find(statement.starts, place, &start_interval::place);
            text += "start " +
                    (open == statement.starts.end()
                         ? start_text(each, state[place])
                         : "[" + decimal_fraction(open->low) + ", " + decimal_fraction(open->high) + "]") +
                    "\n";
            ++place;
        }
    }
    text += statement.varied ? "vary " + state[*statement.varied] + "\n" : "";
    names.clear();
    const auto given = certified_names(system, statement);
    require_at_most(given.size() + form.added.size(), most_certified_unknowns,
                    "unknowns, with derivatives and functions");
    require_at_most(form.added.size(), most_certified_definitions, "functions, quotients and roots");
    require_at_most(statement.values.size(), most_certified_claims, "values");
    require_at_most(statement.zeros ? statement.zeros->times.size() : 0, most_certified_zeros, "zeros");
    for (std::size_t k = 0; k < form.leaves.size(); ++k) {
        names.emplace(form.leaves[k].name(), k < given.size() ? given[k] : "_" + std::to_string(k - form.given + 1));
    }
    const certified_formula in_form(system.variable(), names);
    for (std::size_t k = 0; k < form.added.size(); ++k) {
        text += "define _" + std::to_string(k + 1) + " = " + in_form.of(form.added[k]) + "\n";
    }
    return statement.zeros ? text + "condition " + in_state.of(statement.zeros->condition) + "\n" : text;
}

}  // namespace libration::ode
