#include "swept_problem.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "change_words.hpp"
#include "libration/equation/renamed_unknowns.hpp"
#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/limit_text.hpp"
#include "problem_options.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* set_remedy = "write values such as k=1/3, k=1,2,5 or k=0:1:11";
constexpr const char* set_times_remedy = "write times such as 0,1.5,sqrt(2) or a range 0:20:201";

// Not allowed in an equation: multiples of the period of a motion.
void require_no_period(const exact& value) {
    if (value.has_periods()) {
        throw error(error_kind::argument, "list", "", "has '" + value.text + "', and a problem has no period T");
    }
}

void require_time(const exact& value) {
    require_no_period(value);
    if (value.measure == unit::degree) {
        throw error(error_kind::argument, "list", "", "has the angle '" + value.text + "'");
    }
}

set_axis split_set(const std::string& words) {
    const auto equals = words.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == words.size()) {
        throw input_error("--set", words, "is not NAME=VALUES", set_remedy);
    }
    return {without_blanks(words.substr(0, equals)), words.substr(equals + 1)};
}

axis axis_of(const set_axis& each) {
    return {.name = each.axis(),
            .option = each.option(),
            .help = "",
            .form = axis_form::numbers,
            .remedy = set_remedy,
            .check = require_no_period,
            .coordinate = each.axis()};
}

problem_family axes_of(const swept_problem& of) {
    const auto names = of.system.unknowns();
    const auto require_unknown = [names](const exact& word) {
        if (std::ranges::find(names, word.text) == names.end() &&
            std::ranges::find(names, word.text, ode::name_before_renaming) == names.end()) {
            throw error(error_kind::argument, "list", "",
                        "has '" + word.text + "', which is not an unknown of the problem");
        }
    };
    std::string listed;
    for (const std::string& each : names) {
        listed += (listed.empty() ? "" : ",") + each;
    }
    problem_family result{of.name, {}};
    for (const set_axis& each : of.sets) {
        result.axes.push_back(axis_of(each));
    }
    result.axes.push_back({.name = "time",
                           .option = "--times",
                           .help = "",
                           .form = axis_form::numbers,
                           .remedy = set_times_remedy,
                           .check = require_time,
                           .coordinate = "time"});
    result.axes.push_back({.name = "unknown",
                           .option = "--unknowns",
                           .help = "unknowns of --problem; default all",
                           .forms = "a,b,c",
                           .form = axis_form::words,
                           .remedy = "write some of " + listed,
                           .check = require_unknown,
                           .coordinate = "unknown"});
    return result;
}

// Parameters in the order of the text, then initial values by name: the columns then depend only on what is varied.
void put_in_order(std::vector<set_axis>& sets, const ode::equation_system& system) {
    const auto place = [&](const set_axis& each) {
        const auto found =
            std::ranges::find_if(system.parameters, [&](const ode::definition& d) { return d.name == each.name; });
        return found - system.parameters.begin();
    };
    std::ranges::sort(sets, [&](const set_axis& a, const set_axis& b) {
        return std::pair(place(a), a.name) < std::pair(place(b), b.name);
    });
}

}  // namespace

std::string without_blanks(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

ode::explicit_system swept_problem::at(const std::vector<exact>& values) const {
    ode::equation_system changed = system;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        changed = ode::changed(std::move(changed), sets[i].name + " = " + values[i].text);
    }
    return ode::explicit_system(changed);
}

limit_problem swept_problem::at_infinity(const std::vector<exact>& values) const {
    std::vector<std::string> unknowns = determined;
    std::vector<std::string> changes;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const auto open = std::ranges::find(unknowns, sets[i].name);
        (open == unknowns.end() ? changes.emplace_back() : *open) = sets[i].name + " = " + values[i].text;
    }
    limit_problem result = limit_problem_of(text, unknowns);
    for (const std::string& each : changes) {
        result.of.set(each);
    }
    return result;
}

std::string swept_problem::command() const {
    std::string words = "--problem " + quoted_word(said);
    for (const set_axis& each : sets) {
        words += " --set " + quoted_word(each.name + "=" + each.words);
    }
    return words;
}

shared_problem sweep_problem(const std::string& said, const std::vector<std::string>& sets) {
    problem_source named = problem_named(said);
    auto result = std::make_shared<swept_problem>();
    result->said = said;
    naming_option("--problem", [&] {
        const auto separated = ode::with_limits_separated(named.text);
        result->system = ode::parse(with_starts_between(separated, {}));
        result->limits = separated.limits;
        if (!result->limits.empty()) {
            result->determined = open_numbers(result->system);
        }
    });
    result->name = std::move(named.name);
    result->text = std::move(named.text);
    std::set<std::string> names;
    for (const std::string& words : sets) {
        set_axis each = split_set(words);
        if (!names.insert(each.name).second) {
            throw input_error("--set", words, "is given twice", "write all values of " + each.name + " in one list");
        }
        require_changeable(result->system, each.name + "=1");
        naming_option("--set", [&] { return ode::changed(result->system, each.name + " = 1"); });
        result->sets.push_back(std::move(each));
    }
    put_in_order(result->sets, result->system);
    if (sets.empty() && result->limits.empty()) {
        naming_option("--problem", [&] { return ode::explicit_system(result->system); });
    }
    result->axes = axes_of(*result);
    return result;
}

std::string quoted_word(const std::string& word) {
    const bool plain = std::ranges::all_of(word, [](unsigned char c) {
        return std::isalnum(c) != 0 || std::string_view("_-+=.,:/@%^").find(static_cast<char>(c)) != std::string::npos;
    });
    return plain ? word : '"' + word + '"';
}

std::string unquoted_word(const std::string& word) {
    const bool quoted = word.size() > 1 && word.front() == '"' && word.back() == '"';
    return quoted ? word.substr(1, word.size() - 2) : word;
}

}  // namespace libration
