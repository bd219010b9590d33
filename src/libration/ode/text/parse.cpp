#include "libration/ode/parse.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "formula_parser.hpp"
#include "libration/ode/unused_parameters.hpp"
#include "libration/scalar/text/near_word.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

bool is_symbol(const token& word, char c) { return word.kind == token_kind::symbol && word.symbol == c; }

std::string whole(const statement& words) { return text_of(words, 0, words.size()); }

// The index of the only = of a statement.
std::size_t equals_of(const statement& words) {
    const auto is_equals = [](const token& word) { return is_symbol(word, '='); };
    const auto found = std::ranges::find_if(words, is_equals);
    if (found == words.end()) {
        refuse(whole(words), words.front().at, "is not an equation: write one with =");
    }
    if (std::ranges::count_if(words, is_equals) > 1) {
        refuse(whole(words), words.front().at, "has more than one =: write separate statements");
    }
    const auto place = static_cast<std::size_t>(found - words.begin());
    if (place == 0 || place + 1 == words.size()) {
        refuse(whole(words), found->at, "has nothing on one side of =: write both sides");
    }
    return place;
}

bool is_keyword(const statement& words, std::string_view name) {
    return words.size() > 1 && words[0].kind == token_kind::name && words[0].primes == 0 && words[0].text == name &&
           words[1].kind != token_kind::symbol;
}

// invariant y^2 + x; also invariant (x + y)/2, but neither invariant = 3 nor invariant(0) = 1.
bool is_invariant(const statement& words) {
    const bool named =
        words.size() > 1 && words[0].kind == token_kind::name && words[0].primes == 0 && words[0].text == "invariant";
    return named && std::ranges::none_of(words, [](const token& word) { return is_symbol(word, '='); });
}

// name(...) = ...
bool is_start(const statement& words) {
    if (words.size() < 5 || words[0].kind != token_kind::name || is_function_name(words[0].text) ||
        !is_symbol(words[1], '(')) {
        return false;
    }
    int open = 0;
    for (std::size_t i = 1; i < words.size(); ++i) {
        open += is_symbol(words[i], '(') ? 1 : is_symbol(words[i], ')') ? -1 : 0;
        if (open == 0) {
            return i + 1 < words.size() && is_symbol(words[i + 1], '=');
        }
    }
    return false;
}

// The statements of one problem, read in two passes: names first.
class problem_reader {
public:
    explicit problem_reader(std::string_view text) : all_(statements_of(text)) {
        find_variable();
        find_names();
    }
    /// Statements that change a system.
    problem_reader(std::string_view text, const equation_system& of) : all_(statements_of(text)) {
        names_.variable = of.variable;
        const auto unknowns = of.unknowns();
        names_.unknowns.insert(unknowns.begin(), unknowns.end());
        for (const definition& each : of.parameters) {
            names_.parameters.insert(each.name);
        }
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
        if (is_start(words)) {
            read_start(words, equals);
        } else if (is_definition(words)) {
            read_parameter(words);
        } else {
            result_.equations.push_back(
                {formula(words, 0, equals), formula(words, equals + 1, words.size()), words[0].at});
        }
    }

    equation_system& result() { return result_; }

    // The parameters that occur only in their definition.
    std::vector<std::string> unused() const {
        std::map<std::string_view, int> times;
        for (const statement& words : all_) {
            for (const token& word : words) {
                times[word.text] += word.kind == token_kind::name ? 1 : 0;
            }
        }
        std::vector<std::string> found;
        std::ranges::copy_if(names_.parameters, std::back_inserter(found),
                             [&](const std::string& name) { return times[name] == 1; });
        return found;
    }

private:
    bool is_definition(const statement& words) const {
        return words[0].kind == token_kind::name && words[0].primes == 0 && is_symbol(words[1], '=') &&
               !names_.unknowns.contains(words[0].text);
    }

    void find_variable() {
        bool found = false;
        for (const statement& words : all_) {
            if (is_keyword(words, "variable")) {
                if (words.size() > 2 || words[1].kind != token_kind::name || words[1].primes > 0) {
                    refuse(whole(words), words[0].at, "does not name a variable: write variable x");
                }
                if (found) {
                    refuse(whole(words), words[0].at, "is a second independent variable: leave one out");
                }
                require_free_name(words[1], "");
                names_.variable = words[1].text;
                found = true;
            }
        }
    }

    void find_names() {
        for (const statement& words : all_) {
            for (const token& word : words) {
                if (word.kind == token_kind::name && word.primes > 0 && !is_function_name(word.text)) {
                    require_free_column(word, names_.variable);
                    names_.unknowns.emplace(word.text);
                }
            }
        }
        for (const statement& words : all_) {
            if (words.size() > 1 && is_definition(words)) {
                require_free_name(words[0], names_.variable);
                names_.parameters.emplace(words[0].text);
            }
        }
    }

    expression formula(const statement& words, std::size_t first, std::size_t last) const {
        return read_formula(words, first, last, names_, formula_role::equation);
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
        const std::string of = primed(std::string(name.text), name.primes);
        if (!names_.unknowns.contains(name.text)) {
            refuse(whole(words), name.at,
                   "is not an initial value of an unknown: add an equation with " + std::string(name.text) + "'");
        }
        if (equals == 4 && words[2].text == names_.variable) {
            refuse(of + "(" + names_.variable + ")", name.at, "has an argument: write " + of);
        }
        const expression point = constant(words, 2, equals - 1, "point");
        const expression value = constant(words, equals + 1, words.size(), "value");
        result_.starts.push_back({unknown(std::string(name.text), name.primes), point, value, name.at});
    }

    void read_parameter(const statement& words) {
        const std::string name(words[0].text);
        if (!defined_.insert(name).second) {
            refuse(whole(words), words[0].at, "gives " + name + " a second value: give it only one");
        }
        result_.parameters.push_back({name, constant(words, 2, words.size(), "value"), words[0].at});
    }

    void read_exact_solution(const statement& words) {
        const std::size_t equals = equals_of(words);
        if (equals != 2 || words[1].primes > 0 || !names_.unknowns.contains(words[1].text)) {
            refuse(whole(words), words[0].at,
                   "does not name an unknown: write exact f = ... in the variable and parameters");
        }
        expression value = formula(words, 3, words.size());
        if (value.has_unknowns()) {
            refuse(whole(words), words[0].at,
                   "has an unknown on its right-hand side: write it in the variable and parameters");
        }
        result_.exact.push_back({std::string(words[1].text), std::move(value), words[0].at});
    }

    std::vector<statement> all_;
    known_names names_;
    equation_system result_;
    std::set<std::string> defined_;
};

// Reports a parameter that is not in the problem.
[[noreturn]] void refuse_parameter(const definition& of, const equation_system& system) {
    std::vector<std::string> own;
    std::ranges::transform(system.parameters, std::back_inserter(own), &definition::name);
    std::string list;
    for (const std::string& name : own) {
        list += ", " + name;
    }
    refuse(of.name, of.at,
           "is not a parameter of this problem" + suggestion(of.name, own) +
               (own.empty() ? ", which has none: leave it out" : ": choose one of its own" + list));
}

}  // namespace

equation_system parse(std::string_view text) { return problem_reader(text).read(); }

std::vector<std::string> unused_parameters(std::string_view text) { return problem_reader(text).unused(); }

equation_system changed(equation_system system, std::string_view text) {
    problem_reader reader(text, system);
    for (const statement& words : reader.statements()) {
        reader.read_equality(words);
    }
    const equation_system& more = reader.result();
    if (!more.equations.empty()) {
        refuse(std::string(text), more.equations.front().at,
               "is neither a parameter nor an initial value: write k = 1 or f(0) = 1");
    }
    for (const definition& each : more.parameters) {
        if (system.parameter_of(each.name) == nullptr) {
            refuse_parameter(each, system);
        }
        system.set(each.name, each.value);
    }
    for (const start& each : more.starts) {
        const auto found =
            std::ranges::find_if(system.starts, [&](const start& s) { return same_form(s.of, each.of); });
        if (found == system.starts.end()) {
            refuse(primed(each.of.name(), each.of.derivative()), each.at,
                   "has no initial value in this problem: choose one that has");
        }
        *found = each;
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

start parse_point_condition(const equation_system& of, std::string_view text) {
    problem_reader reader(text, of);
    const auto& all = reader.statements();
    if (all.size() == 1) {
        reader.read_equality(all.front());
    }
    if (reader.result().starts.size() != 1) {
        refuse(std::string(text), {}, "is not a condition at a time: write one, as f'(5) = 1");
    }
    start result = reader.result().starts.front();
    result.point = with_values(result.point, of);
    result.value = with_values(result.value, of);
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
