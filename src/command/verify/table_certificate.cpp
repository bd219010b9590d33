#include "verify/table_certificate.hpp"

#include <algorithm>
#include <vector>

#include "libration/number/written_number.hpp"
#include "option/defaults.hpp"
#include "problem/certificate_file.hpp"
#include "problem/motion_cells.hpp"
#include "problem/solution_table.hpp"
#include "run/progress.hpp"
#include "text/column_file.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

std::vector<exact> times_in_file(const std::string& file, std::size_t column, bool as_doubles) {
    input_stream source("FILE", file);
    column_file records(source);
    std::vector<exact> times;
    for (auto record = records.next(); record; record = records.next()) {
        const auto cells = records.cells(*record);
        if (!cells || cells->size() <= column) {
            continue;
        }
        try {
            const exact typed = time_in(trimmed((*cells)[column]));
            const exact time = as_doubles && !typed.has_periods() ? nearest_double(typed) : typed;
            const auto same = [&](const exact& each) { return each.coefficient == time.coefficient; };
            if (!time.has_periods() && std::ranges::none_of(times, same)) {
                times.push_back(time);
            }
        } catch (const error&) {  // a row that is malformed in the comparison, too
        }
    }
    return times;
}

}  // namespace

void certify_times_of_table(const std::string& path, const problem_options& problem, const std::string& file,
                            const column_names& names, bool times_are_doubles) {
    const auto column = names.find("time");
    if (file == "-" || !column) {
        throw input_error("--certificate", path, "is of a file, which is read twice", "write the table to a file");
    }
    const std::vector<exact> times = times_in_file(file, *column, times_are_doubles);
    if (times.empty()) {
        throw input_error("--certificate", path, "is of values at times, and no row has one", "leave it out");
    }
    const request proved{.scalar = {scalar_kind::proved, defaults::digits_of_list}};
    const partial_table found = states_table(*problem.general_solution(), times, proved, {});
    require_complete(found);
    with_certificate_progress(proved.scalar.digits, [&](const request& how) {
        certify_states(path, problem.choose(), times, found.rows, how, notes_of(problem));
    });
}

}  // namespace libration
