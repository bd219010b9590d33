// Bounds of sets of solutions.
#include <string>
#include <utility>
#include <vector>

#include "answers.hpp"
#include "guarded.hpp"
#include "libration/number/given_number.hpp"
#include "libration/query/sets/set_events.hpp"
#include "libration/query/sets/solution_sets.hpp"
#include "libration/scalar/ball/outward_decimals.hpp"

namespace libration::c {

namespace {

constexpr long most_parts_of_set = 1'000'000;

// "1/2", or all times of "0:10".
std::pair<exact, exact> span_of(const std::string& item) {
    const auto colon = item.find(':');
    const auto time = [](const std::string& text) { return given_time("times", trimmed(text)); };
    std::pair ends{time(item.substr(0, colon)), time(colon == std::string::npos ? item : item.substr(colon + 1))};
    for (const exact& each : {ends.first, ends.second}) {
        if (!each.is_number()) {
            throw error(error_kind::argument, "times", item, "is neither a time nor a span from one to another");
        }
    }
    if (sign_of_exact(ends.second - ends.first) < 0) {
        throw error(error_kind::argument, "times", item, "is a span that ends before it begins");
    }
    return ends;
}

long given_parts(long parts) {
    if (parts < 1 || parts > most_parts_of_set) {
        throw error(error_kind::argument, "number of parts", std::to_string(parts), "is not between 1 and 1000000");
    }
    return parts;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_problem_enclosures(const libration_problem* problem, const char* times, long most_parts, long digits,
                                 libration_watch watch, void* context, libration_table** bounds) {
    return partly_made(bounds, [&] {
        const watcher watched(watch, context);
        ode::set_request request{.spans = {},
                                 .most_parts = static_cast<std::size_t>(given_parts(most_parts)),
                                 .digits = given_digits(digits)};
        std::vector<std::pair<exact, exact>> typed;
        for (const std::string& each : items_of(text_of(times, "times"), "times")) {
            typed.push_back(span_of(each));
            request.spans.push_back({as_exact_real(typed.back().first), as_exact_real(typed.back().second)});
        }
        const auto found = ode::enclosed_solutions(given(problem, "problem").equations, request,
                                                   [&](const ball&, long) { watched(0); });
        known_states result{{{"from", "to", "unknown", "lower", "upper"}, {}}, found.missing};
        for (std::size_t i = 0; i < typed.size(); ++i) {
            for (std::size_t k = 0; k < found.values[i].size(); ++k) {
                const auto& [lower, upper] = found.values[i][k];
                const auto decimals = outward_decimals(lower, upper, digits);
                result.table.add(typed_number(typed[i].first.text));
                result.table.add(typed_number(typed[i].second.text));
                result.table.add(found.names[k]);
                result.table.add(typed_number(decimals.first));
                result.table.add(typed_number(decimals.second));
            }
        }
        return result;
    });
}

int libration_problem_enclosed_events(const libration_problem* problem, const char* condition, long count,
                                      long most_parts, long digits, libration_watch watch, void* context,
                                      libration_table** bounds) {
    return partly_made(bounds, [&] {
        if (count < 1) {
            throw error(error_kind::argument, "number of events", std::to_string(count), "is less than 1");
        }
        const watcher watched(watch, context);
        const ode::set_event_request request{.condition = text_of(condition, "condition"),
                                             .count = count,
                                             .most_parts = static_cast<std::size_t>(given_parts(most_parts)),
                                             .digits = given_digits(digits)};
        const auto found =
            ode::enclosed_events(given(problem, "problem").equations, request, [&](const ball&, long) { watched(0); });
        known_states result{{{"event", "quantity", "lower", "upper"}, {}}, found.missing};
        for (std::size_t k = 0; k < found.events.size(); ++k) {
            const auto add = [&](const std::string& name, const ode::closed_interval& of) {
                const auto decimals = outward_decimals(of.lower, of.upper, digits);
                result.table.add(typed_number(std::to_string(k + 1)));
                result.table.add(name);
                result.table.add(typed_number(decimals.first));
                result.table.add(typed_number(decimals.second));
            };
            add("time", found.events[k].time);
            for (std::size_t i = 0; i < found.names.size(); ++i) {
                add(found.names[i], found.events[k].values[i]);
            }
        }
        return result;
    });
}
