#include "find_arguments.hpp"
#include "guarded.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/limit_text.hpp"
#include "problem_tables.hpp"
#include "solution_answers.hpp"

namespace libration::c {

namespace {

limit_problem problem_with_limits(const char* text, const char* unknowns) {
    return limit_problem_of(trimmed(text_of(text, "problem")),
                            is_given(unknowns) ? items_of(unknowns, "unknowns") : std::vector<std::string>());
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_find_at_infinity(const char* text, const char* unknowns, long digits, libration_watch watch,
                               void* context, libration_table** values) {
    return made(values, [&] {
        return table_of_values(limit_solution(problem_with_limits(text, unknowns))
                                   .unknowns(watched_digits(digits, watcher(watch, context))));
    });
}

int libration_states_at_infinity(const char* text, const char* unknowns, const char* times, long digits,
                                 libration_watch watch, void* context, libration_table** states) {
    return partly_made(states, [&] {
        const limit_solution of(problem_with_limits(text, unknowns));
        const auto items = items_of(text_of(times, "times"), "times");
        std::vector<exact> at;
        for (const std::string& each : items) {
            at.push_back(each == "inf" || each == "-inf" ? exact{0, unit::one, each} : given_time("time", each));
        }
        answer found = of.states(at, {}, watched_digits(digits, watcher(watch, context)));
        found.names.insert(found.names.begin(), "time");
        for (std::size_t i = 0; i < items.size(); ++i) {
            found.rows[i].resize(found.names.size() - 1);
            found.rows[i].insert(found.rows[i].begin(), text_value(items[i]));
        }
        return known_states{table_of_numbers(found), found.missing};
    });
}

int libration_eigenvalues(const char* text, const char* energy, long count, long digits, libration_watch watch,
                          void* context, libration_table** values) {
    return made(values, [&] {
        const std::string name = text_of(energy, "energy");
        if (count < 1) {
            throw error(error_kind::argument, "count", std::to_string(count), "is less than one");
        }
        const limit_problem of = eigenvalue_problem_of(trimmed(text_of(text, "problem")), name);
        const answer found =
            find_eigenvalues(of.of, name, of.conditions, count, watched_digits(digits, watcher(watch, context)));
        if (found.missing) {
            throw error(*found.missing);
        }
        return table_of_values(found);
    });
}
