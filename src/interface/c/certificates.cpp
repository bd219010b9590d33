#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "answers.hpp"
#include "guarded.hpp"
#include "libration/ode/parse.hpp"
#include "libration/problem/certificate.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/text/given_number.hpp"

namespace libration::c {

namespace {

// A certificate is of the equations themselves, not of a closed form.
std::unique_ptr<solution> solution_of(const libration_problem& p) {
    return solve(problem(p.equations), {.general = true});
}

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

// Beside the file, which it replaces when it is complete.
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

// Of one unknown and one condition. How many integrations there are is not known: the part that is done is always 0.
libration_table certified_root(const libration_problem& p, const std::string& unknown, const std::string& condition,
                               long digits, const std::string& file, const watcher& watch) {
    const problem of(p.equations);
    request how = proved_digits(given_digits(digits));
    how.reached = [watch](double /*time*/, long /*bits*/) { watch(0.0); };
    auto found = table_of_values(find_unknowns(of, {unknown}, {condition}, how));
    const std::string decimal = found.cells.back().number.decimal;
    write_file(file, certificate_of_root(of, unknown, condition, decimal, how));
    return found;
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
        write_file(file, certificate_of_states(p.system, at, decimals_of(found, 1, digits), how));
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
        write_file(file, certificate_of_events(p.system, ode::parse_condition(p.equations, text), 0, rows, how));
        return table;
    });
}

int libration_problem_find_certificate(const libration_problem* problem, const char* unknown, const char* condition,
                                       long digits, const char* path, libration_watch watch, void* context,
                                       libration_table** values) {
    return made(values, [&] {
        return certified_root(given(problem, "problem"), text_of(unknown, "unknown"), text_of(condition, "condition"),
                              digits, text_of(path, "path"), watcher(watch, context));
    });
}
