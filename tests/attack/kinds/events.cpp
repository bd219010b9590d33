// Times of events, and their number before a time, also for initial points on and near the section.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "attack/facts.hpp"
#include "attack/kinds/event_problems.hpp"
#include "attack/question.hpp"
#include "libration/query/proved_events.hpp"
#include "libration/scalar/error.hpp"

namespace libration::attack {

namespace {

// A question about events.
struct event_question {
    asked_events asked;
    ode::event_request request;
    std::string options;
    std::optional<rational> before;  ///< since the initial time
    int way = 0;
    long digits = 0;

    // The events that count, up to `before` and including it.
    std::vector<known_event> wanted() const {
        std::vector<known_event> all = asked.events;
        std::erase_if(all, [&](const known_event& each) {
            const bool late = before && sign_of([&] { return mpfr(each.since() - real(*before)); }) > 0;
            return late || each.way == 0 || (way != 0 && each.way != way);
        });
        return all;
    }
    bool touched() const {
        return std::ranges::any_of(asked.events, [](const known_event& each) { return each.way == 0; });
    }
    // Whether an event is at `before` exactly, or may be.
    bool at_end() const {
        return before && std::ranges::any_of(asked.events, [&](const known_event& each) {
                   return sign_of([&] { return mpfr(each.since() - real(*before)); }) == 0;
               });
    }
};

std::string command_of(const event_question& question) {
    return fmt::format("libration reference --problem \"{}\" --until \"{}\"{} --digits {}", question.asked.problem.text,
                       question.asked.condition, question.options, question.digits);
}

void judge_events(const event_question& question, const std::vector<ode::known_event>& events, outcome& result) {
    const auto wanted = question.wanted();
    const auto& problem = question.asked.problem;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::string event = fmt::format("event {}, ", i + 1);
        if (i >= wanted.size()) {
            const bool none = question.asked.all || question.before;
            result.add(none ? verdict::wrong : verdict::undecided, event + "which is not one");
            continue;
        }
        const truth since = wanted[i].since;
        const rational origin = problem.origin;
        const truth time = [=] { return mpfr(real(origin) + since()); };
        add_number(result, events[i].time, question.digits, time, event + "time");
        const std::size_t slope = problem.columns.size() - 1;
        if (problem.columns.size() > 1) {
            const truth value = [&] { return problem.values[slope](since()); };
            add_number(result, events[i].values[slope], question.digits, value, event + problem.columns[slope]);
        }
    }
}

// Checks the facts in a message about the event after those that were found.
verdict judged_next_event(const event_question& question, std::size_t found, const std::string& message) {
    const auto facts = facts_of(message);
    std::vector<known_event> all = question.asked.events;
    std::erase_if(
        all, [&](const known_event& each) { return each.way == 0 || (question.way != 0 && each.way != question.way); });
    if (found >= all.size()) {
        return facts.lies_above && question.asked.all ? verdict::wrong : verdict::refused;
    }
    const truth time = [&] { return mpfr(real(question.asked.problem.origin) + all[found].since()); };
    const std::string none;
    const bool late = !facts.none_up_to || judged_bounds(*facts.none_up_to, none, time) == verdict::right;
    const bool above = !facts.lies_above || judged_bounds(*facts.lies_above, none, time) == verdict::right;
    const bool below = !facts.lies_below || judged_bounds(none, *facts.lies_below, time) == verdict::right;
    return late && above && below ? verdict::refused : verdict::wrong;
}

verdict judged_event_refusal(const event_question& question, std::size_t events, const std::string& message) {
    const auto facts = facts_of(message);
    if (judged_next_event(question, events, message) == verdict::wrong) {
        return verdict::wrong;
    }
    if (facts.touches && !question.touched()) {
        return verdict::wrong;
    }
    if (facts.found && question.before) {
        const auto all = static_cast<long>(question.wanted().size());
        const bool known = question.asked.all || question.before;
        const bool fits = *facts.found == all || (question.at_end() && *facts.found == all - 1);
        return !known || fits ? verdict::right : verdict::wrong;
    }
    return judged_existence(message, 0, question.asked.problem.forward);
}

outcome judged_question(event_question question) {
    outcome result;
    result.command = announce(command_of(question));
    auto& asked = question.asked;
    try {
        const auto given = ode::parse(asked.problem.text);
        question.request.g = ode::parse_condition(given, asked.condition);
        if (question.request.g.is_constant()) {
            return result;
        }
        const auto report =
            ode::searched_events(ode::explicit_system(given), question.request, question.digits, {},
                                 [](const ball&, long, const std::vector<ode::known_event>&) { require_time_left(); });
        judge_events(question, report.events, result);
        if (report.missing) {
            const std::string message = report.missing->what();
            result.add(judged_event_refusal(question, report.events.size(), message), message);
        }
    } catch (const error& refusal) {
        result.add(verdict::refused, refusal.what());
    } catch (const no_answer& late) {
        result.add(verdict::undecided, late.what());
    }
    return result;
}

void end_before(event_question& question, const rational& since) {
    const std::string text = question.asked.problem.typed_time(since);
    question.before = since;
    question.request.before = time_number(text);
    question.options += " --before=" + text;
}

// A time slightly before or after one of the events, or at it, or anywhere.
rational end_of_search(const asked_events& asked, choices& next) {
    if (asked.events.empty() || next.one_in(4)) {
        return decimal_fraction(next.between(1, 4000), 3);
    }
    const double at = rough(asked.events[next.below(std::min<std::size_t>(asked.events.size(), 4))].since);
    const rational near = decimal_fraction(integer(std::round(at * 1000)) + next.between(-2, 2), 3);
    return near <= 0 ? rational(1, 1000) : near;
}

}  // namespace

outcome ask_event(choices& next) {
    event_question question{any_events(next), {}, {}, {}, 0, next.between(1, 40)};
    question.request.count = next.between(1, 3);
    if (next.one_in(3)) {
        question.way = next.one_in(2) ? 1 : -1;
        question.request.way = question.way > 0 ? ode::crossing::up : ode::crossing::down;
        question.options = question.way > 0 ? " --crossing up" : " --crossing down";
    }
    const auto wanted = static_cast<long>(question.wanted().size());
    if (wanted < question.request.count && question.asked.all) {
        end_before(question, end_of_search(question.asked, next));  // otherwise the search would not end
    }
    question.options += fmt::format(" --count {}", question.request.count);
    return judged_question(std::move(question));
}

outcome ask_count(choices& next) {
    event_question question{any_events(next), {}, {}, {}, 0, next.between(1, 20)};
    question.request.count = next.between(1, 2 * most_events);
    end_before(question, end_of_search(question.asked, next));
    question.options += fmt::format(" --count {}", question.request.count);
    return judged_question(std::move(question));
}

}  // namespace libration::attack
