#include "problem_reader.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "condition.hpp"
#include "event_condition.hpp"
#include "formula_parser.hpp"
#include "interval_value.hpp"
#include "piecewise.hpp"
#include "shorthand.hpp"

namespace libration::ode {

problem_reader::problem_reader(std::string_view text) : all_(statements_of(text)) {
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
    rename_columns(with_names);
}

problem_reader::problem_reader(std::string_view text, const equation_system& of)
    : all_(statements_of(text)), names_(names_of(of)) {
    with_primes(all_, of.variable, names_);
    for (statement& words : all_) {
        rename(words, renamed_columns(names_));
    }
}

equation_system problem_reader::read() {
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
    if (result_.equations.size() > names_.unknowns.size()) {
        refuse_second_equation();
    }
    for (const event_statement& each : events_) {
        read_event(each);
    }
    replace_shorthands(result_);
    return std::move(result_);
}

expression problem_reader::difference(const statement& words) const {
    const std::size_t equals = equals_of(words);
    return formula(words, 0, equals) - formula(words, equals + 1, words.size());
}

void problem_reader::read_equality(const statement& words) {
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

std::vector<std::string> problem_reader::unused() const {
    std::map<std::string_view, int> times;
    const auto count = [&](const statement& words) {
        for (const token& word : words) {
            times[word.text] += word.kind == token_kind::name ? 1 : 0;
        }
    };
    const auto of_events = statements_in(events_);
    std::ranges::for_each(all_, count);
    std::ranges::for_each(of_events, count);
    // A name for an expression, also in terms of other such names, may be a quantity to print.
    std::set<std::string_view> expressions;
    const auto is_expression = [&](const statement& words) {
        return !expressions.contains(words.front().text) && is_definition(words, names_) &&
               (depends_on_solution(words) || std::ranges::any_of(words, [&](const token& word) {
                    return word.kind == token_kind::name && expressions.contains(word.text);
                }));
    };
    for (auto next = all_.begin(); (next = std::ranges::find_if(all_, is_expression)) != all_.end();) {
        expressions.insert(next->front().text);
    }
    std::vector<std::string> found;
    std::ranges::copy_if(names_.parameters, std::back_inserter(found), [&](const std::string& name) {
        return times[name] == 1 && !expressions.contains(name) &&
               std::ranges::find(result_.open, name, &open_parameter::name) == result_.open.end();
    });
    return found;
}

void problem_reader::rename_columns(const std::vector<statement>& all) {
    renamed_ = renamed_columns(all, names_);
    for (const auto& [name, free] : renamed_) {
        names_.unknowns.erase(name);
        names_.unknowns.insert(free);
    }
    const auto in_each = [&](statement& words) { rename(words, renamed_); };
    std::ranges::for_each(all_, in_each);
    for (event_statement& each : events_) {
        rename(each.condition, renamed_);
        std::ranges::for_each(each.resets, in_each);
    }
}

expression problem_reader::formula(const statement& words, std::size_t first, std::size_t last) const {
    return read_formula(words, first, last, names_, formula_role::equation);
}

expression problem_reader::side(const statement& words, std::size_t first, std::size_t last) {
    return read_formula(words, first, last, names_, formula_role::equation, nullptr, &result_);
}

expression problem_reader::constant(const statement& words, std::size_t first, std::size_t last,
                                    const std::string& what) const {
    expression value = read_formula(words, first, last, names_, formula_role::value);
    if (!value.is_constant()) {
        refuse(whole(words), words[first].at, "has a " + what + " that is not constant: give a number or parameters");
    }
    return value;
}

void problem_reader::read_start(const statement& words, std::size_t equals) {
    const token& name = words[0];
    const std::string of = primed(name.text, name.primes);
    if (!names_.unknowns.contains(name.text)) {
        refuse(whole(words), name.at, "is not an initial value of an unknown: add an equation with " + name.text + "'");
    }
    const expression point = constant(words, 2, equals - 1, "point");
    const expression started = unknown(name.text, name.primes);
    const std::string set_name = name_of_start(started, point);
    const bool is_set = read_set(words, equals + 1, set_name);
    const expression value = is_set ? parameter(set_name) : constant(words, equals + 1, words.size(), "value");
    result_.starts.push_back({started, point, value, name.at});
}

void problem_reader::refuse_second_equation() const {
    for (const std::string& name : names_.unknowns) {
        std::vector<const statement*> equations;
        const statement* assigned = nullptr;
        for (const statement& words : all_) {
            if (words.size() > 2 && words[0].kind == token_kind::name && words[0].text == name &&
                is_symbol(words[1], '=')) {
                if (words[0].primes > 0) {
                    equations.push_back(&words);
                } else {
                    assigned = assigned == nullptr ? &words : assigned;
                }
            }
        }
        const statement* const second = assigned != nullptr ? assigned : equations.size() > 1 ? equations[1] : nullptr;
        if (!equations.empty() && second != nullptr) {
            refuse(whole(*second), second->front().at,
                   "is a second equation for " + name + ", in addition to `" + whole(*equations[0]) + "` at line " +
                       std::to_string(equations[0]->front().at.line) + ": give it only one");
        }
    }
}

bool problem_reader::read_set(const statement& words, std::size_t begin, const std::string& name) {
    auto found = set_in(words, begin, name, names_);
    if (found) {
        result_.sets.push_back(std::move(*found));
    }
    return found.has_value();
}

void problem_reader::read_history(const statement& words, std::size_t equals) {
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
        refuse(whole(words), name.at, "has an unknown on its right-hand side: write it in the variable and parameters");
    }
    if (std::ranges::find(result_.histories, name.text, &history::unknown) != result_.histories.end()) {
        refuse(whole(words), name.at, "gives " + name.text + " a second history: give it only one");
    }
    result_.histories.push_back({name.text, point, value, name.at});
}

bool problem_reader::depends_on_solution(const statement& words) const {
    return std::any_of(words.begin() + 2, words.end(), [&](const token& word) {
        return word.kind == token_kind::name && (word.text == names_.variable || names_.unknowns.contains(word.text));
    });
}

void problem_reader::read_parameter(const statement& words) {
    const std::string& name = words[0].text;
    if (const auto [before, first] = defined_.emplace(name, &words); !first) {
        refuse(whole(words), words[0].at,
               "gives " + name + " a second value, after `" + whole(*before->second) + "` at line " +
                   std::to_string(before->second->front().at.line) + ": give it only one");
    }
    if (read_set(words, 2, name)) {
        return;
    }
    expression value =
        depends_on_solution(words) ? side(words, 2, words.size()) : constant(words, 2, words.size(), "value");
    result_.parameters.push_back({name, std::move(value), words[0].at});
}

void problem_reader::read_exact_solution(const statement& words) {
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

condition problem_reader::condition_of(const event_statement& event) {
    const bool compared = std::ranges::any_of(
        event.condition, [](const token& word) { return is_comparison(word) || is_connective(word); });
    if (!compared) {
        const statement& words = event.condition;
        const std::size_t equals = equals_of(words);
        const expression left = side(words, 0, equals);
        return {.kind = condition_kind::equal, .difference = left - side(words, equals + 1, words.size())};
    }
    statement words = event.condition;
    for (token& word : words) {
        word.symbol = is_symbol(word, '=') ? equal_sign : word.symbol;
    }
    std::size_t next = 0;
    int depth = 0;
    condition holds = read_condition({.words = words, .next = next, .last = words.size(), .depth = depth, .sum = [&] {
                                          return read_sum(words, next, words.size(), names_, &result_);
                                      }});
    if (next < words.size()) {
        refuse(words[next].text, words[next].at,
               "is not expected in a condition: write when x > 1 and y < 2, or when x = 1");
    }
    return holds;
}

void problem_reader::read_event(const event_statement& words) {
    state_event made{.way = words.way, .stop = words.stop, .text = words.text, .at = words.at};
    for (const statement& each : words.resets) {
        const token& name = each[0];
        made.resets.push_back(
            {unknown(name.text, name.primes), formula(each, equals_of(each) + 1, each.size()), name.at});
    }
    std::ranges::move(events_when(condition_of(words), made, result_), std::back_inserter(result_.events));
}

}  // namespace libration::ode
