#include "libration/equation/text/parse.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "event_statement.hpp"
#include "formula_parser.hpp"
#include "interval_value.hpp"
#include "libration/equation/unused_parameters.hpp"
#include "libration/scalar/near_word.hpp"
#include "names.hpp"
#include "shorthand.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

// The statements of one problem, read in two passes: names first.
class problem_reader {
public:
    explicit problem_reader(std::string_view text) : all_(statements_of(text)) {
        const auto declared = declared_variable(all_);
        const auto of_quotients = with_primes(all_, declared);
        names_ = names_in(all_, declared ? *declared : of_quotients ? *of_quotients : inferred_variable(all_));
        events_ = take_events(all_);
        std::vector<statement> with_names = all_;
        std::ranges::move(statements_in(events_), std::back_inserter(with_names));
        result_.open = open_names(with_names, names_);
        add_algebraic_unknowns(all_, names_, result_.open);
        for (const open_parameter& each : result_.open) {
            names_.parameters.insert(each.name);
        }
    }
    /// Statements that change a system.
    problem_reader(std::string_view text, const equation_system& of) : all_(statements_of(text)), names_(names_of(of)) {
        with_primes(all_, of.variable, names_);
    }

    equation_system read() {
        result_.variable = names_.variable;
        for (const statement& words : all_) {
            if (is_keyword(words, "variable")) {
                continue;
            }
            if (is_invariant(words)) {
                result_.invariants.push_back({formula(words, 1, words.size()), 0, words[0].at});
            } else if (is_keyword(words, "exact")) {
                read_exact_solution(words);
            } else {
                read_equality(words);
            }
        }
        if (result_.equations.empty()) {
            refuse("", {}, "has no equation: write one, as y' = y");
        }
        for (const event_statement& each : events_) {
            read_event(each);
        }
        replace_shorthands(result_);
        return std::move(result_);
    }

    const std::vector<statement>& statements() const { return all_; }

    // left - right of an equation.
    expression difference(const statement& words) const {
        const std::size_t equals = equals_of(words);
        return formula(words, 0, equals) - formula(words, equals + 1, words.size());
    }

    void read_equality(const statement& words) {
        const std::size_t equals = equals_of(words);
        if (is_history(words)) {
            read_history(words, equals);
        } else if (is_start(words, names_.variable)) {
            read_start(words, equals);
        } else if (is_definition(words, names_)) {
            read_parameter(words);
        } else {
            expression left = side(words, 0, equals);
            result_.equations.push_back({std::move(left), side(words, equals + 1, words.size()), words[0].at});
        }
    }

    equation_system& result() { return result_; }

    // The parameters that occur only in their definition.
    std::vector<std::string> unused() const {
        std::map<std::string_view, int> times;
        const auto count = [&](const statement& words) {
            for (const token& word : words) {
                times[word.text] += word.kind == token_kind::name ? 1 : 0;
            }
        };
        std::ranges::for_each(all_, count);
        std::ranges::for_each(statements_in(events_), count);
        std::vector<std::string> found;
        std::ranges::copy_if(names_.parameters, std::back_inserter(found), [&](const std::string& name) {
            return times[name] == 1 &&
                   std::ranges::find(result_.open, name, &open_parameter::name) == result_.open.end();
        });
        return found;
    }

private:
    expression formula(const statement& words, std::size_t first, std::size_t last) const {
        return read_formula(words, first, last, names_, formula_role::equation);
    }

    // Of an equation.
    expression side(const statement& words, std::size_t first, std::size_t last) {
        return read_formula(words, first, last, names_, formula_role::equation, nullptr, &result_);
    }

    expression constant(const statement& words, std::size_t first, std::size_t last, const std::string& what) const {
        expression value = read_formula(words, first, last, names_, formula_role::value);
        if (!value.is_constant()) {
            refuse(whole(words), words[first].at,
                   "has a " + what + " that is not constant: give a number or parameters");
        }
        return value;
    }

    void read_start(const statement& words, std::size_t equals) {
        const token& name = words[0];
        const std::string of = primed(name.text, name.primes);
        if (!names_.unknowns.contains(name.text)) {
            refuse(whole(words), name.at,
                   "is not an initial value of an unknown: add an equation with " + name.text + "'");
        }
        const expression point = constant(words, 2, equals - 1, "point");
        const expression started = unknown(name.text, name.primes);
        const std::string set_name = name_of_start(started, point);
        const bool is_set = read_set(words, equals + 1, set_name);
        const expression value = is_set ? parameter(set_name) : constant(words, equals + 1, words.size(), "value");
        result_.starts.push_back({started, point, value, name.at});
    }

    // Whether the value from this token on is an interval.
    bool read_set(const statement& words, std::size_t begin, const std::string& name) {
        auto found = set_in(words, begin, name, names_);
        if (found) {
            result_.sets.push_back(std::move(*found));
        }
        return found.has_value();
    }

    // x(t <= 0) = 1 + t
    void read_history(const statement& words, std::size_t equals) {
        const token& name = words[0];
        const std::string form = name.text + "(" + names_.variable + " <= 0)";
        if (words[2].text != names_.variable || !is_symbol(words[3], '<') || words[3].source == "<" ||
            !is_symbol(words[equals - 1], ')') || name.primes > 0 || !names_.unknowns.contains(name.text)) {
            refuse(whole(words), name.at,
                   "is not the history of an unknown: write " + form + " = 1 for an unknown with an equation");
        }
        const expression point = constant(words, 4, equals - 1, "point");
        const expression value = formula(words, equals + 1, words.size());
        if (value.has_unknowns()) {
            refuse(whole(words), name.at,
                   "has an unknown on its right-hand side: write it in the variable and parameters");
        }
        if (std::ranges::find(result_.histories, name.text, &history::unknown) != result_.histories.end()) {
            refuse(whole(words), name.at, "gives " + name.text + " a second history: give it only one");
        }
        result_.histories.push_back({name.text, point, value, name.at});
    }

    void read_parameter(const statement& words) {
        const std::string& name = words[0].text;
        if (!defined_.insert(name).second) {
            refuse(whole(words), words[0].at, "gives " + name + " a second value: give it only one");
        }
        if (read_set(words, 2, name)) {
            return;
        }
        const bool depends_on_solution = std::any_of(words.begin() + 2, words.end(), [&](const token& word) {
            return word.kind == token_kind::name &&
                   (word.text == names_.variable || names_.unknowns.contains(word.text));
        });
        expression value =
            depends_on_solution ? side(words, 2, words.size()) : constant(words, 2, words.size(), "value");
        result_.parameters.push_back({name, std::move(value), words[0].at});
    }

    void read_exact_solution(const statement& words) {
        const std::size_t equals = equals_of(words);
        const bool named = equals == 2 || (equals == 5 && has_variable_behind(words, 1, names_.variable));
        if (!named || words[1].primes > 0 || !names_.unknowns.contains(words[1].text)) {
            refuse(whole(words), words[0].at,
                   "does not name an unknown: write exact f = ... in the variable and parameters");
        }
        expression value = formula(words, equals + 1, words.size());
        if (value.has_unknowns()) {
            refuse(whole(words), words[0].at,
                   "has an unknown on its right-hand side: write it in the variable and parameters");
        }
        result_.exact.push_back({words[1].text, std::move(value), words[0].at});
    }

    void read_event(const event_statement& words) {
        state_event made{.condition = difference(words.condition),
                         .way = words.way,
                         .stop = words.stop,
                         .text = words.text,
                         .at = words.at};
        for (const statement& each : words.resets) {
            const token& name = each[0];
            made.resets.push_back(
                {unknown(name.text, name.primes), formula(each, equals_of(each) + 1, each.size()), name.at});
        }
        result_.events.push_back(std::move(made));
    }

    std::vector<statement> all_;
    std::vector<event_statement> events_;
    known_names names_;
    equation_system result_;
    std::set<std::string> defined_;
};

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
