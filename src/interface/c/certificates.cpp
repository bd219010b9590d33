#include "find_arguments.hpp"
#include "guarded.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/solution.hpp"
#include "solution_answers.hpp"

namespace libration::c {

namespace {

std::unique_ptr<solution> solution_of(const libration_problem& p) { return solve(problem(p.equations)); }

// The last column.
std::vector<std::string> values_of(const libration_table& found) {
    std::vector<std::string> values;
    for (std::size_t k = found.names.size() - 1; k < found.cells.size(); k += found.names.size()) {
        values.push_back(found.cells[k].number.decimal);
    }
    return values;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_problem_certificate(const libration_problem* problem, const char* times, long digits, const char* path,
                                  libration_watch watch, void* context, libration_table** states) {
    return made(states, [&] {
        const libration_problem& p = given(problem, "problem");
        return certified_states(p, *solution_of(p), times, digits, path, watcher(watch, context));
    });
}

int libration_problem_event_certificate(const libration_problem* problem, const char* condition, long count,
                                        long digits, const char* path, libration_watch watch, void* context,
                                        libration_table** events) {
    return made(events, [&] {
        const libration_problem& p = given(problem, "problem");
        return certified_events(p, *solution_of(p), condition, count, digits, path, watcher(watch, context));
    });
}

int libration_problem_find_certificate(const libration_problem* problem, const char* unknowns, const char* conditions,
                                       long digits, const char* path, libration_watch watch, void* context,
                                       libration_table** values) {
    return made(values, [&] {
        const libration::problem of(given(problem, "problem").equations);
        const auto names = items_of(text_of(unknowns, "unknowns"), "unknowns");
        const auto equations = conditions_of(text_of(conditions, "conditions"));
        const std::string file = text_of(path, "path");
        const request how = watched_digits(digits, watcher(watch, context));
        auto found = table_of_values(find_unknowns(of, names, equations, how));
        write_file(file, certificate_of_root(of, names, equations, values_of(found), how));
        return found;
    });
}

int libration_problem_orbit_certificate(const libration_problem* problem, long digits, const char* path,
                                        libration_watch watch, void* context, libration_table** orbit) {
    return made(orbit, [&] {
        const libration::problem of(given(problem, "problem").equations);
        const std::string file = text_of(path, "path");
        const request how = watched_digits(digits, watcher(watch, context));
        auto found = table_of_values(find_periodic_orbit(of, how));
        write_file(file, certificate_of_orbit(of, values_of(found), how));
        return found;
    });
}
