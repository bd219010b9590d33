#include <cctype>
#include <string>
#include <utility>

#include "answers.hpp"
#include "find_arguments.hpp"
#include "libration/number/grid.hpp"
#include "libration/problem/find.hpp"

namespace libration::c {

namespace {

// "k = 0:3.5:36" or "k = 0, 1, 2".
branch_values values_along(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) {
        throw error(error_kind::argument, error_subject::along, text, "is not NAME = VALUES: write \"k = 0:1:11\"");
    }
    branch_values along{trimmed(text.substr(0, equals)), {}};
    try {
        std::string values = text.substr(equals + 1);
        std::erase_if(values, [](unsigned char c) { return std::isspace(c) != 0; });
        for (const exact& each : read_grid(values)) {
            along.values.push_back(each.text);
        }
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument) {
            throw;
        }
        throw error(error_kind::argument, error_subject::along, text, problem.reason());
    }
    return along;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_problem_branch(const libration_problem* problem, const char* unknowns, const char* conditions,
                             const char* along, long digits, libration_watch watch, void* context,
                             libration_table** points) {
    return partly_made(points, [&] {
        answer found = find_branch(
            libration::problem(given(problem, "problem").equations),
            items_of(text_of(unknowns, "unknowns"), "unknowns"), conditions_of(text_of(conditions, "conditions")),
            values_along(text_of(along, "along")), watched_digits(digits, watcher(watch, context)));
        return known_states{table_of_branch(found), std::move(found.missing)};
    });
}
