#include "certificate_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "run/child_program.hpp"
#include "run/program_files.hpp"
#include "run/progress.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr const char* certificate_option = "--certificate";

// The decimals of some columns.
printed_rows decimals_of(const table& of, const std::vector<std::string>& columns, long digits) {
    printed_rows rows{{}, digits};
    for (const table_row_cells& row : of.rows()) {
        rows.of.emplace_back();
        for (const std::string& name : columns) {
            const auto found = std::ranges::find(of.columns(), name, &column::name);
            rows.of.back().push_back(row[static_cast<std::size_t>(found - of.columns().begin())].text());
        }
    }
    return rows;
}

// The column "value".
std::vector<std::string> values_of(const answer& found) {
    std::vector<std::string> values;
    for (std::size_t k = 0; k < found.rows.size(); ++k) {
        values.push_back(found.at(k, "value"));
    }
    return values;
}

// Errors of the argument name the option.
template <class Make>
void write_certificate(const std::string& path, const Make& make) {
    const std::string content = [&] {
        try {
            return make();
        } catch (const error& problem) {
            if (!problem.is_about(error_subject::certificate) || problem.kind() != error_kind::argument) {
                throw;
            }
            throw input_error(std::string(certificate_option) + " '" + path + "' " + problem.reason());
        }
    }();
    try {
        write_whole_file(path, content);
    } catch (const std::runtime_error& problem) {
        throw input_error(certificate_option, path, std::string("cannot be written (") + problem.what() + ")",
                          "choose a file in a folder that exists and that you may write in");
    }
}

}  // namespace

certificate_notes notes_of(const problem_options& problem) {
    certificate_notes notes;
    std::string text = problem_named(*problem.problem()).text;
    const bool has_lines = text.find('\n') != std::string::npos;
    std::ranges::replace(text, has_lines ? '\r' : ';', '\n');
    std::istringstream lines(text);
    for (std::string each; std::getline(lines, each);) {
        notes.push_back(trimmed(each));
    }
    for (const std::string& change : problem.changes()) {
        notes.push_back("--set " + change);
    }
    std::erase(notes, "");
    return notes;
}

void certify_states(const std::string& path, const ode::explicit_system& system, const std::vector<exact>& times,
                    const table& states, const request& how, const certificate_notes& notes) {
    write_certificate(path, [&] {
        const auto rows = decimals_of(states, ode::names_of_state(system), how.printed_digits());
        return certificate_of_states(system, times, rows, how, notes);
    });
}

void certify_events(const std::string& path, const ode::explicit_system& system, const ode::event_request& request,
                    const table& events, const libration::request& how, const certificate_notes& notes) {
    write_certificate(path, [&] {
        std::vector<std::string> columns = ode::names_of_state(system);
        columns.insert(columns.begin(), events.columns().front().name);
        const auto rows = decimals_of(events, columns, how.printed_digits());
        const int way = request.way == ode::crossing::any ? 0 : request.way == ode::crossing::up ? 1 : -1;
        return certificate_of_events(system, request.g, way, rows, how, notes);
    });
}

void certify_root(const std::string& path, const problem& of, const std::vector<std::string>& unknowns,
                  const std::vector<std::string>& conditions, const answer& found, const request& how,
                  const certificate_notes& notes) {
    write_certificate(path,
                      [&] { return certificate_of_root(of, unknowns, conditions, values_of(found), how, notes); });
}

void certify_orbit(const std::string& path, const problem& of, const answer& found, const request& how,
                   const certificate_notes& notes) {
    write_certificate(path, [&] { return certificate_of_orbit(of, values_of(found), how, notes); });
}

void with_certificate_progress(long digits, const std::function<void(const request&)>& write) {
    progress shown("certificate", progress_of_part::steps);
    progress_of_part to(shown);
    write(request{.scalar = {scalar_kind::proved, digits},
                  .progress = [&](double part) { to(part); },
                  .reached = [&](double time, long bits) { to.reached(time, bits); }});
    to(1);
}

void check_certificate(const std::string& path) {
    constexpr int not_found = 127;
    const std::string checker = peer_program("libration-check");
    const program_result done = result_of_program({checker, path});
    if (done.exit_code == not_found) {
        throw error(error_kind::undecided, error_subject::certificate, path,
                    "is not checked, because there is no program " + checker +
                        ": build it, or check the file by check/libration_check.py");
    }
    if (done.exit_code != 0) {
        throw error(error_kind::undecided, error_subject::certificate, path,
                    "is rejected by libration-check: " + done.out.substr(0, done.out.find('\n')));
    }
    fmt::print(stderr, "libration: libration-check proves the certificate '{}', in integers\n", path);
}

}  // namespace libration
