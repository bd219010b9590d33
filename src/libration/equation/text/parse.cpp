#include "libration/equation/text/parse.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "formula_parser.hpp"
#include "libration/equation/renamed_unknowns.hpp"
#include "libration/equation/unused_parameters.hpp"
#include "libration/scalar/near_word.hpp"
#include "names.hpp"
#include "problem_reader.hpp"
#include "shorthand.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

// Whether a set is a parameter instead of an initial value, x(0).
bool is_name_of_parameter(const std::string& name) { return name.find('(') == std::string::npos; }

// Reports a parameter that is not in the problem.
[[noreturn]] void refuse_parameter(const definition& of, const equation_system& system) {
    std::vector<std::string> own;
    std::ranges::transform(system.parameters, std::back_inserter(own), &definition::name);
    for (const number_set& each : system.sets) {
        if (is_name_of_parameter(each.name)) {
            own.push_back(each.name);
        }
    }
    std::ranges::transform(system.open, std::back_inserter(own), &open_parameter::name);
    std::string list;
    for (const std::string& name : own) {
        list += ", " + name;
    }
    refuse(of.name, of.at,
           "is not a parameter of this problem" + suggestion(of.name, own) +
               (own.empty() ? ", which has none: leave it out" : ": choose one of its own" + list));
}

// Reports k = 1 if k has another meaning than that of a parameter.
void require_no_other_meaning(const statement& words, const equation_system& system) {
    const token& name = words[0];
    if (name.kind != token_kind::name || name.primes > 0 || !symbol_at(words, 1, '=') ||
        system.has_parameter(name.text)) {
        return;
    }
    const auto unknowns = system.unknowns();
    if (std::ranges::find(unknowns, name.text) != unknowns.end()) {
        refuse(name.text, name.at,
               "is an unknown: write " + corrected(words, 0, 1, name.text + "(0)") + " for its initial value");
    }
    if (name.text == system.variable) {
        refuse(name.text, name.at, "is the independent variable, which has no value: leave it out");
    }
    if (name.text == "e") {
        refuse(name.text, name.at, "is Euler's number: write `" + whole(words) + "` in the problem for a parameter");
    }
}

}  // namespace

equation_system parse(std::string_view text) { return problem_reader(text).read(); }

std::vector<std::string> unused_parameters(std::string_view text) { return problem_reader(text).unused(); }

std::map<std::string, std::string> renamed_unknowns(std::string_view text) { return problem_reader(text).renamed(); }

equation_system changed(equation_system system, std::string_view text) {
    problem_reader reader(text, system);
    for (const statement& words : reader.statements()) {
        require_no_other_meaning(words, system);
        reader.read_equality(words);
    }
    const equation_system& more = reader.result();
    if (!more.equations.empty()) {
        refuse(std::string(text), more.equations.front().at,
               "is neither a parameter nor an initial value: write k = 1 or f(0) = 1");
    }
    const auto shorthands = shorthands_of(system);
    for (const definition& each : more.parameters) {
        if (!system.has_parameter(each.name)) {
            refuse_parameter(each, system);
        }
        if (shorthands.contains(each.name)) {
            refuse(each.name, each.at, "is a name for an expression in unknowns or time: change it in the problem");
        }
        system.set(each.name, each.value);
        if (shorthands_of(system).contains(each.name)) {
            refuse(each.name, each.at, "has a value that is not constant: give a number or parameters");
        }
    }
    for (const history& each : more.histories) {
        const auto found = std::ranges::find(system.histories, each.unknown, &history::unknown);
        if (found == system.histories.end()) {
            refuse(each.unknown, each.at, "has no history in this problem: choose an unknown that has one");
        }
        *found = each;
    }
    for (const start& each : more.starts) {
        const auto found =
            std::ranges::find_if(system.starts, [&](const start& s) { return same_form(s.of, each.of); });
        if (found != system.starts.end()) {
            const std::string before = name_of_start(found->of, found->point);
            std::erase_if(system.sets, [&](const number_set& set) { return set.name == before; });
            *found = each;
        } else if (each.of.derivative() < system.order_of(each.of.name())) {
            system.starts.push_back(each);
        } else {
            refuse(primed(each.of.name(), each.of.derivative()), each.at,
                   "has no initial value in this problem: choose one that has");
        }
    }
    for (const number_set& each : more.sets) {
        if (is_name_of_parameter(each.name) && !system.has_parameter(each.name)) {
            refuse_parameter({each.name, {}, each.at}, system);
        }
        system.set_between(each.name, each.lower, each.upper);
        system.sets.back().at = each.at;
    }
    return system;
}

expression parse_condition(const equation_system& of, std::string_view text) {
    const problem_reader reader(text, of);
    if (reader.statements().size() != 1) {
        refuse(std::string(text), {}, "is not a condition: write one equation, as x' = 0");
    }
    return with_values(reader.difference(reader.statements().front()), of);
}

start parse_value_at_time(const equation_system& of, std::string_view text) {
    const std::string equation = std::string(text) + " = 0";
    problem_reader reader(equation, of);
    const auto& all = reader.statements();
    if (all.size() == 1) {
        reader.read_equality(all.front());
    }
    if (reader.result().starts.size() != 1) {
        refuse(std::string(text), {}, "is not a value at a time: write one, as x'(0)");
    }
    start result = reader.result().starts.front();
    result.point = with_values(result.point, of);
    return result;
}

namespace {

expression constant_in(std::string_view text, const known_names& names, formula_role role) {
    const auto all = statements_of(text);
    if (all.size() != 1) {
        refuse(std::string(text), {}, "is not a number: write one");
    }
    return read_formula(all[0], 0, all[0].size(), names, role);
}

}  // namespace

expression parse_constant(std::string_view text) {
    return constant_in(text, {.variable = "", .unknowns = {}, .parameters = {}}, formula_role::value);
}

complex_constant parse_complex_constant(std::string_view text) {
    const known_names names{.variable = "", .unknowns = {}, .parameters = {"i"}};
    const expression value = constant_in(text, names, formula_role::point);
    const expression imaginary = partial(value, parameter("i"));
    if (imaginary.kind() != node_kind::constant) {
        refuse(std::string(text), {}, "has i in a power, a denominator or a function: write a+bi");
    }
    const expression real = replaced(value, [](const expression&) { return std::optional(expression()); });
    return {real.constant(), imaginary.constant()};
}

}  // namespace libration::ode
