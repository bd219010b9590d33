#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "answers.hpp"
#include "find_arguments.hpp"
#include "guarded.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/given_number.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/solution.hpp"

namespace libration::c {

namespace {

std::unique_ptr<solution> solution_of(const libration_problem& p) { return solve(problem(p.equations)); }

request watched(long digits, const watcher& watch) {
    request how = proved_digits(given_digits(digits));
    how.progress = [watch](double part) { watch(part); };
    return how;
}

// The decimals of a table of which every cell is a number, from a column on.
printed_rows decimals_of(const libration_table& of, std::size_t first, long digits) {
    printed_rows rows{{}, digits};
    for (std::size_t k = 0; k < of.cells.size(); ++k) {
        if (k % of.names.size() == 0) {
            rows.of.emplace_back();
        }
        if (k % of.names.size() >= first) {
            rows.of.back().push_back(of.cells[k].number.decimal);
        }
    }
    return rows;
}

// Next to the file, which it replaces when it is complete.
void write_file(const std::string& path, const std::string& content) {
    const std::string beside = path + ".new";
    std::ofstream file(beside, std::ios::binary);
    file << content;
    file.close();
    std::error_code failure;
    if (file) {
        std::filesystem::rename(beside, path, failure);
    }
    if (!file || failure) {
        std::error_code none_to_remove;
        std::filesystem::remove(beside, none_to_remove);
        throw error(error_kind::argument, "path", path,
                    "cannot be written: choose a file in a folder that exists and that you may write in");
    }
}

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
        const std::string file = text_of(path, "path");
        const request how = watched(digits, watcher(watch, context));
        const std::string list = text_of(times, "times");
        auto found = states_of(*solution_of(p), list, how, watcher(watch, context)).complete();
        std::vector<exact> at;
        std::ranges::transform(items_of(list, "times"), std::back_inserter(at),
                               [](const std::string& item) { return given_time("time", item); });
        write_file(file, certificate_of_states(p.system(), at, decimals_of(found, 1, digits), how));
        return found;
    });
}

int libration_problem_event_certificate(const libration_problem* problem, const char* condition, long count,
                                        long digits, const char* path, libration_watch watch, void* context,
                                        libration_table** events) {
    return made(events, [&] {
        const libration_problem& p = given(problem, "problem");
        const std::string file = text_of(path, "path");
        const request how = watched(digits, watcher(watch, context));
        const std::string text = text_of(condition, "condition");
        if (count < 1) {
            throw error(error_kind::argument, "number of events", std::to_string(count), "is less than 1");
        }
        const answer found = solution_of(p)->events(text, count, how);
        if (found.missing) {
            throw error(*found.missing);
        }
        auto table = table_of_numbers(found);
        const auto rows = decimals_of(table, 0, digits);
        write_file(file, certificate_of_events(p.system(), ode::parse_condition(p.equations, text), 0, rows, how));
        return table;
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
