#include "event_statement.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace libration::ode {

namespace {

constexpr const char* form_of_event = "when y = 0 down: y' = -0.9*y'";

constexpr std::array<std::pair<std::string_view, crossing>, 3> directions{
    {{"up", crossing::up}, {"down", crossing::down}, {"both", crossing::any}}};

bool is_plain_name(const token& word) { return word.kind == token_kind::name && word.primes == 0; }

bool is_colon(const token& word) { return is_symbol(word, ':'); }

// The largest number of primes of each name.
std::map<std::string, int> highest_primes(const std::vector<statement>& all) {
    std::map<std::string, int> highest;
    for (const statement& words : all) {
        for (const token& word : words) {
            if (word.kind == token_kind::name) {
                int& most = highest[word.text];
                most = std::max(most, word.primes);
            }
        }
    }
    return highest;
}

bool is_stop(const statement& words) { return words.size() == 1 && is_plain_name(words[0]) && words[0].text == "stop"; }

bool is_reset(const statement& words, const std::map<std::string, int>& highest) {
    return words.size() > 2 && words[0].kind == token_kind::name && is_symbol(words[1], '=') &&
           words[0].primes < highest.at(words[0].text);
}

event_statement begun_by(const statement& words, const std::map<std::string, int>& highest) {
    const auto colon = std::ranges::find_if(words, is_colon);
    event_statement made;
    made.at = words[0].at;
    auto end = colon;
    const auto last = static_cast<std::size_t>(colon - words.begin()) - 1;
    if (is_direction(words, last)) {
        made.way = std::ranges::find(directions, words[last].text, &decltype(directions)::value_type::first)->second;
        --end;
    }
    made.condition.assign(words.begin() + 1, end);
    made.text = text_of(words, 0, last + 1);
    if (made.condition.empty()) {
        refuse(whole(words), made.at, std::string("has no condition: write one, as ") + form_of_event);
    }
    const statement action(colon + 1, words.end());
    if (is_stop(action)) {
        made.stop = true;
    } else if (!action.empty() && is_reset(action, highest)) {
        made.resets.push_back(action);
    } else if (action.size() > 2 && is_plain_name(action[0]) && is_symbol(action[1], '=')) {
        const std::string& name = action[0].text;
        refuse(whole(words), colon->at,
               "gives " + name + " a new value, which is not an unknown: write " + name + "' = 0; " + name +
                   "(0) = ... instead of " + name + " = ... for a value that resets alone change");
    } else {
        refuse(whole(words), colon->at,
               std::string("is not followed by a new value of an unknown or of a lower derivative: write one, as ") +
                   form_of_event + ", or stop");
    }
    return made;
}

void require_no_colon(const statement& words) {
    const auto colon = std::ranges::find_if(words, is_colon);
    if (colon != words.end()) {
        refuse(":", colon->at, std::string("is not expected here: write it after a condition, as ") + form_of_event);
    }
}

}  // namespace

bool is_event(const statement& words) {
    return words.size() > 1 && is_plain_name(words[0]) && words[0].text == "when" &&
           std::ranges::any_of(words, is_colon);
}

bool is_direction(const statement& words, std::size_t at) {
    return at > 1 && is_event(words) && symbol_at(words, at + 1, ':') && is_plain_name(words[at]) &&
           std::ranges::find(directions, words[at].text, &decltype(directions)::value_type::first) !=
               directions.end() &&
           (words[at - 1].kind != token_kind::symbol || is_symbol(words[at - 1], ')'));
}

std::vector<event_statement> take_events(std::vector<statement>& all) {
    const auto highest = highest_primes(all);
    std::vector<event_statement> events;
    std::vector<statement> others;
    bool in_event = false;
    for (statement& words : all) {
        if (is_event(words)) {
            events.push_back(begun_by(words, highest));
            in_event = true;
        } else if (in_event && is_stop(words)) {
            events.back().stop = true;
        } else if (in_event && is_reset(words, highest)) {
            events.back().resets.push_back(std::move(words));
        } else {
            if (is_keyword(words, "when")) {
                refuse(whole(words), words[0].at, std::string("has no colon: write ") + form_of_event);
            }
            require_no_colon(words);
            others.push_back(std::move(words));
            in_event = false;
        }
    }
    all = std::move(others);
    return events;
}

std::vector<statement> statements_in(const std::vector<event_statement>& events) {
    std::vector<statement> all;
    for (const event_statement& each : events) {
        all.push_back(each.condition);
        std::ranges::copy(each.resets, std::back_inserter(all));
    }
    return all;
}

}  // namespace libration::ode
