#include "names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "libration/equation/renamed_unknowns.hpp"
#include "libration/number/exact_real.hpp"
#include "written_function.hpp"

namespace libration::ode {

namespace {

constexpr std::array<std::string_view, 6> names_of_columns{"n", "time", "digits", "rigour", "time_typed", "count"};

bool is_name(const token& word) { return word.kind == token_kind::name; }

bool is_column(std::string_view name) { return std::ranges::find(names_of_columns, name) != names_of_columns.end(); }

bool is_definition_of(const statement& words, const std::string& name) {
    return is_name(words[0]) && words[0].primes == 0 && words[0].text == name && symbol_at(words, 1, '=');
}

// name(name), touching.
bool has_name_behind(const statement& words, std::size_t at) {
    return symbol_at(words, at + 1, '(') && words[at + 1].touches && at + 2 < words.size() && is_name(words[at + 2]) &&
           words[at + 2].primes == 0 && symbol_at(words, at + 3, ')');
}

// The largest number of primes of each name.
std::map<std::string, int> primes_of(const std::vector<statement>& all) {
    std::map<std::string, int> primes;
    for (const statement& words : all) {
        for (const token& word : words) {
            if (is_name(word) && word.primes > 0 && !is_function_name(word.text)) {
                int& most = primes[word.text];
                most = std::max(most, word.primes);
            }
        }
    }
    return primes;
}

bool occurs(const std::vector<statement>& all, const std::string& name) {
    return std::ranges::any_of(all, [&](const statement& words) {
        return std::ranges::any_of(words, [&](const token& word) { return is_name(word) && word.text == name; });
    });
}

// Whether the name is free to be the variable: neither defined nor reserved.
bool may_be_variable(const std::vector<statement>& all, const std::string& name) {
    return !is_function_name(name) && name != "pi" && name != "inf" &&
           std::ranges::none_of(all, [&](const statement& words) { return is_definition_of(words, name); });
}

// Whether a name does not denote a parameter whose value is open.
bool has_meaning(const std::string& name, const known_names& known) {
    constexpr std::array<std::string_view, 10> reserved{"pi", "inf",  "deg",   "e",    "i",
                                                        "t",  "true", "false", "True", "False"};
    return is_function_name(name) || name == known.variable || known.unknowns.contains(name) ||
           known.parameters.contains(name) || std::ranges::find(reserved, name) != reserved.end();
}

}  // namespace

known_names names_of(const equation_system& system) {
    known_names names;
    names.variable = system.variable;
    const auto unknowns = system.unknowns();
    names.unknowns.insert(unknowns.begin(), unknowns.end());
    for (const definition& each : system.parameters) {
        names.parameters.insert(each.name);
    }
    for (const number_set& each : system.sets) {
        names.parameters.insert(each.name);
    }
    for (const open_parameter& each : system.open) {
        names.parameters.insert(each.name);
    }
    return names;
}

bool is_function_name(std::string_view name) { return function_named(name).has_value(); }

void require_free_name(const token& name, const std::string& variable) {
    if (name.text == variable) {
        const std::string other = variable == "x" ? "t" : "x";
        refuse(name.text, name.at, "is the independent variable: choose another name, or `variable " + other + "`");
    }
    if (is_function_name(name.text) || name.text == "pi" || name.text == "inf") {
        refuse(name.text, name.at, "is a reserved name: choose another, as " + name.text + "_");
    }
}

std::optional<std::string> declared_variable(const std::vector<statement>& all) {
    std::optional<std::string> found;
    for (const statement& words : all) {
        if (!is_keyword(words, "variable")) {
            continue;
        }
        if (words.size() > 2 || !is_name(words[1]) || words[1].primes > 0) {
            refuse(whole(words), words[0].at, "does not name a variable: write variable x");
        }
        if (found) {
            refuse(whole(words), words[0].at, "is a second independent variable: leave one out");
        }
        require_free_name(words[1], "");
        found = words[1].text;
    }
    return found;
}

std::string inferred_variable(const std::vector<statement>& all) {
    const auto primes = primes_of(all);
    std::optional<std::string> found;
    for (const statement& words : all) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const auto unknown = is_name(words[i]) ? primes.find(words[i].text) : primes.end();
            const bool names_variable = has_name_behind(words, i) || (i == 0 && is_history(words));
            if (unknown == primes.end() || !names_variable || primes.contains(words[i + 2].text) ||
                !may_be_variable(all, words[i + 2].text)) {
                continue;
            }
            // y(a) = 1 and y'(a) = 0 are initial values if y'' occurs.
            if (i == 0 && symbol_at(words, 4, '=') && words[0].primes < unknown->second) {
                continue;
            }
            const std::string& name = words[i + 2].text;
            if (found && *found != name) {
                refuse(text_of(words, i, i + 4), words[i].at,
                       "has another independent variable than " + *found + ": write " +
                           corrected(words, i + 2, i + 3, *found) + ", or `variable " + name + "`");
            }
            found = name;
        }
    }
    if (found) {
        return *found;
    }
    const bool by_x = !primes.contains("x") && !occurs(all, "t") && occurs(all, "x") && may_be_variable(all, "x");
    return by_x ? "x" : "t";
}

known_names names_in(const std::vector<statement>& all, const std::string& variable) {
    known_names names;
    names.variable = variable;
    for (const statement& words : all) {
        for (const token& word : words) {
            if (is_name(word) && word.primes > 0 && !is_function_name(word.text)) {
                require_free_name(word, variable);
                names.unknowns.insert(word.text);
            }
        }
    }
    for (const statement& words : all) {
        if (words.size() > 1 && is_definition(words, names)) {
            require_free_name(words[0], variable);
            names.parameters.insert(words[0].text);
        }
    }
    return names;
}

std::vector<open_parameter> open_names(const std::vector<statement>& all, const known_names& known) {
    std::vector<open_parameter> open;
    std::set<std::string> found;
    for (const statement& words : all) {
        const bool keyword = is_keyword(words, "variable") || is_keyword(words, "exact") || is_invariant(words);
        const bool value = is_definition(words, known) || is_start(words, known.variable);
        for (std::size_t i = keyword ? 1 : 0; i < words.size(); ++i) {
            const token& word = words[i];
            const bool called = symbol_at(words, i + 1, '(') && (words[i + 1].touches || is_called_function(word.text));
            const bool period = value && word.text == "T" && i > 0 && words[i - 1].kind == token_kind::numeral;
            if (is_name(word) && word.primes == 0 && !called && !period && !has_meaning(word.text, known) &&
                found.insert(word.text).second) {
                open.push_back({word.text, word.at});
            }
        }
    }
    return open;
}

void add_algebraic_unknowns(const std::vector<statement>& all, known_names& names, std::vector<open_parameter>& open) {
    const auto is_equation = [&](const statement& words) {
        return !is_keyword(words, "variable") && !is_keyword(words, "exact") && !is_invariant(words) &&
               !is_start(words, names.variable) && !is_definition(words, names);
    };
    const auto equations = static_cast<std::size_t>(std::ranges::count_if(all, is_equation));
    if (equations <= names.unknowns.size()) {
        return;
    }
    const std::size_t missing = equations - names.unknowns.size();
    const auto has_start = [&](const open_parameter& each) {
        return std::ranges::any_of(all, [&](const statement& words) {
            return is_start(words, names.variable) && words[0].primes == 0 && words[0].text == each.name;
        });
    };
    const bool every_one = open.size() == missing;
    std::vector<open_parameter> rest;
    for (const open_parameter& each : open) {
        if (every_one || has_start(each)) {
            names.unknowns.insert(each.name);
        } else {
            rest.push_back(each);
        }
    }
    open = std::move(rest);
}

std::map<std::string, std::string> renamed_columns(const std::vector<statement>& all, const known_names& names) {
    std::map<std::string, std::string> renamed;
    for (const std::string& name : names.unknowns) {
        if (is_column(name)) {
            std::string free = name + "_";
            while (occurs(all, free)) {
                free += "_";
            }
            renamed.emplace(name, free);
        }
    }
    return renamed;
}

std::string_view name_before_renaming(std::string_view column) {
    const std::string_view name = column.substr(0, column.find_last_not_of('_') + 1);
    return is_column(name) ? name : column;
}

void rename(statement& words, const std::map<std::string, std::string>& names) {
    for (token& word : words) {
        const auto found = is_name(word) ? names.find(word.text) : names.end();
        word.text = found != names.end() ? found->second : word.text;
    }
}

std::map<std::string, std::string> renamed_columns(const known_names& names) {
    std::map<std::string, std::string> renamed;
    for (const std::string_view column : names_of_columns) {
        const std::string name(column);
        if (!names.unknowns.contains(name) && !names.parameters.contains(name) && name != names.variable &&
            names.unknowns.contains(name + "_")) {
            renamed.emplace(name, name + "_");
        }
    }
    return renamed;
}

bool is_definition(const statement& words, const known_names& names) {
    return is_name(words[0]) && words[0].primes == 0 && symbol_at(words, 1, '=') &&
           !names.unknowns.contains(words[0].text);
}

bool has_variable_behind(const statement& words, std::size_t name, const std::string& variable) {
    return has_name_behind(words, name) && words[name + 2].text == variable;
}

bool is_history(const statement& words) {
    return words.size() > 6 && is_name(words[0]) && !is_function_name(words[0].text) && is_symbol(words[1], '(') &&
           words[1].touches && is_name(words[2]) && words[2].primes == 0 &&
           (is_symbol(words[3], '<') || is_symbol(words[3], '>'));
}

bool is_start(const statement& words, const std::string& variable) {
    if (words.size() < 5 || !is_name(words[0]) || is_function_name(words[0].text) || !is_symbol(words[1], '(') ||
        has_variable_behind(words, 0, variable)) {
        return false;
    }
    int open = 0;
    for (std::size_t i = 1; i < words.size(); ++i) {
        open += is_symbol(words[i], '(') ? 1 : is_symbol(words[i], ')') ? -1 : 0;
        if (open == 0) {
            return symbol_at(words, i + 1, '=');
        }
    }
    return false;
}

}  // namespace libration::ode
