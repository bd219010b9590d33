#include "libration/equation/text/parse.hpp"

#include <algorithm>
#include <string>

#include "formula_parser.hpp"
#include "names.hpp"
#include "statement.hpp"

namespace libration::ode {

namespace {

// What is missing in a text that is not one equation.
[[noreturn]] void refuse_form(std::string_view text, const std::vector<statement>& all) {
    if (all.empty()) {
        refuse(std::string(text), {}, "is not a condition at a time: write one, as y(1) = 0");
    }
    refuse(std::string(text), all[1].front().at,
           "is more than one condition: give each one by itself, the first as " + whole(all.front()));
}

std::size_t equals_in(const statement& words) {
    const auto comparison = std::ranges::find_if(words, is_comparison);
    if (comparison != words.end()) {
        refuse(whole(words), comparison->at, "is not an equation: write =, as in y(1) = 0");
    }
    if (std::ranges::none_of(words, [](const token& word) { return is_symbol(word, '='); })) {
        refuse(whole(words), words.front().at, "is not an equation: write " + whole(words) + " = 0");
    }
    return equals_of(words);
}

}  // namespace

expression conditions_at_times::at(const expression& of, const expression& time) {
    const auto same = std::ranges::find_if(
        values_, [&](const value_at_time& each) { return same_form(each.of, of) && same_form(each.time, time); });
    if (same != values_.end()) {
        return leaves_[static_cast<std::size_t>(same - values_.begin())];
    }
    values_.push_back({of, time});
    leaves_.push_back(unknown("value " + std::to_string(leaves_.size())));  // not a name that can be typed
    return leaves_.back();
}

conditions_at_times& conditions_at_times::add(const expression& difference) {
    differences_.push_back(difference);
    return *this;
}

void add_condition(conditions_at_times& to, const equation_system& of, std::string_view text) {
    auto all = statements_of(text);
    if (all.size() != 1) {
        refuse_form(text, all);
    }
    const known_names names = names_of(of);
    with_primes(all, of.variable, names);
    rename(all.front(), renamed_columns(names));
    const statement& words = all.front();
    const std::size_t equals = equals_in(words);
    const auto side = [&](std::size_t first, std::size_t last) {
        return read_formula(words, first, last, names, formula_role::equation, &to);
    };
    const expression difference = side(0, equals) - side(equals + 1, words.size());
    if (difference.is_constant() && !difference.has_parameters()) {
        refuse(whole(words), words.front().at, "contains neither an unknown nor a parameter: write one, as y(1) = 0");
    }
    to.add(difference);
}

}  // namespace libration::ode
