// Bounds of sets of solutions.
#include <string>
#include <utility>
#include <vector>

#include "answers.hpp"
#include "guarded.hpp"
#include "libration/ode/proved/solution_sets.hpp"
#include "libration/scalar/ball/outward_decimals.hpp"
#include "libration/scalar/text/given_number.hpp"

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

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_problem_enclosures(const libration_problem* problem, const char* times, long most_parts, long digits,
                                 libration_watch watch, void* context, libration_table** bounds) {
    return partly_made(bounds, [&] {
        if (most_parts < 1 || most_parts > most_parts_of_set) {
            throw error(error_kind::argument, "number of parts", std::to_string(most_parts),
                        "is not between 1 and 1000000");
        }
        const watcher watched(watch, context);
        ode::set_request request{
            .spans = {}, .most_parts = static_cast<std::size_t>(most_parts), .digits = given_digits(digits)};
        std::vector<std::pair<exact, exact>> typed;
        for (const std::string& each : items_of(text_of(times, "times"), "times")) {
            typed.push_back(span_of(each));
            request.spans.push_back({as_expression(typed.back().first), as_expression(typed.back().second)});
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
