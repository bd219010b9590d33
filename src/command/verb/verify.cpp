// libration verify: other people's theta and omega, or elliptic functions, row by row, against proved values.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <iterator>
#include <memory>

#include "option/options.hpp"
#include "option/output_place.hpp"
#include "option/subcommand.hpp"
#include "problem/list_audit.hpp"
#include "problem/motion_options.hpp"
#include "problem/problem_options.hpp"
#include "run/ending_signal.hpp"
#include "run/parallel.hpp"
#include "sweep/study_order.hpp"
#include "text/column_file.hpp"
#include "text/input_error.hpp"
#include "verify/double_columns.hpp"
#include "verify/row_target.hpp"
#include "verify/table_certificate.hpp"
#include "verify/verify_layout.hpp"
#include "verify/verify_summary.hpp"

namespace libration {

namespace {

struct verify_options {
    motion_options motion;
    problem_options problem;
    std::string file;
    std::optional<std::string> coefficients, certificate;
    std::optional<std::string> tolerance, relative, ulps, columns;
    bool modulo_turn = false, rounding = false;
    std::optional<std::string> inputs;
    std::string format = defaults::format_of_table;
    std::optional<std::string> out;
    std::optional<std::string> jobs;
};

constexpr std::size_t batch_rows = 256;
constexpr std::size_t batches_per_job = 16;

using row_batch = std::vector<csv_record>;

std::vector<row_batch> read_batches(column_file& records, std::size_t most) {
    std::vector<row_batch> batches;
    batches.reserve(most);
    for (std::optional<csv_record> record = records.next(); record; record = records.next()) {
        if (batches.empty() || batches.back().size() == batch_rows) {
            batches.emplace_back().reserve(batch_rows);
        }
        batches.back().push_back(std::move(*record));
        if (batches.size() == most && batches.back().size() == batch_rows) {
            break;
        }
    }
    return batches;
}

void show_progress(long count) {
    if (::isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "\r\033[K{}", count > 0 ? fmt::format("{} rows compared", count) : "");
        std::fflush(stderr);
    }
}

// What every row of a file shares.
struct comparison_run {
    const column_names& names;
    compare_rules& rules;
    const row_writer& writer;
    const row_subject& subject;
    bool finds_inputs;  // whether times and arguments are doubles, which --inputs does not tell
    int jobs;
};

// Columns are recognised by these: the same ones whatever the number of threads.
row_batch first_rows(const std::vector<row_batch>& batches) {
    row_batch first;
    for (std::size_t i = 0; i < std::min(batches.size(), batches_per_job); ++i) {
        first.insert(first.end(), batches[i].begin(), batches[i].end());
    }
    return first;
}

// The compared columns that hold doubles.
std::vector<bool> columns_of_doubles(const row_batch& first, const comparison_run& run) {
    const auto& compared = run.subject.compared();
    if (!run.rules.by_last_digit() || run.rules.rounded) {
        return std::vector<bool>(compared.size());
    }
    return double_columns(first, run.writer.between(), compared);
}

// The columns of times and arguments. Two columns of the same quantity are none: the subject does not read them.
std::vector<std::size_t> input_columns(const comparison_run& run) {
    std::vector<std::size_t> places;
    for (const known_column& each : run.subject.known()) {
        std::optional<std::size_t> at;
        try {
            at = run.names.find(each.name);
        } catch (const input_error&) {
            continue;
        }
        if (at && std::ranges::none_of(run.subject.compared(), [&](const auto& column) { return column.at == *at; })) {
            places.push_back(*at);
        }
    }
    return places;
}

std::vector<std::string> own_names(const comparison_run& run, const std::vector<bool>& chosen) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (chosen[i]) {
            names.push_back(run.names.own(run.subject.compared()[i].at));
        }
    }
    return names;
}

// Batches are compared in parallel and written in their order; a set of batches at a time is in memory.
void compare_all(column_file& records, const comparison_run& run, row_target& target, verify_summary& summary) {
    const std::size_t most = batches_per_job * static_cast<std::size_t>(run.jobs);
    std::atomic<long> finished = 0;
    const status_source status([&] { return fmt::format("row {}", finished.load()); });
    auto batches = read_batches(records, most);
    const row_batch first = first_rows(batches);
    const auto of_doubles = columns_of_doubles(first, run);
    summary.name_doubles(own_names(run, of_doubles));
    if (const auto inputs = input_columns(run);
        run.finds_inputs && are_double_columns(first, run.writer.between(), inputs)) {
        run.rules.inputs_are_doubles = true;
        std::vector<std::string> own;
        std::ranges::transform(inputs, std::back_inserter(own), [&](std::size_t at) { return run.names.own(at); });
        summary.name_inputs(std::move(own));
    }
    for (; !batches.empty(); batches = read_batches(records, most)) {
        std::vector<std::vector<compared_row>> compared(batches.size());
        on_threads(batches.size(), run.jobs, [&](std::size_t i) {
            row_comparer compare(run.subject.reader(), run.rules, run.names, run.writer, of_doubles);
            compared[i].reserve(batches[i].size());
            for (const csv_record& record : batches[i]) {
                compared[i].push_back(compare(record));
            }
        });
        show_progress(0);
        for (const auto& batch : compared) {
            for (const compared_row& row : batch) {
                target.write((summary.rows() > 0 ? run.writer.joint() : "") + row.text);
                summary.add(row);
            }
        }
        show_progress(summary.rows());
        finished = summary.rows();
    }
    show_progress(0);
}

// A tolerance is a decimal or a fraction, so that values are compared with it exactly.
std::optional<rational> tolerance_of(const char* option, const std::optional<std::string>& value) {
    if (!value) {
        return std::nullopt;
    }
    const exact tolerance = positive_number_of(option, *value);
    if (!tolerance.is_fraction()) {
        throw input_error(option, *value, "is not a decimal or a fraction", "write a number such as 1e-12 or 1/3");
    }
    return tolerance.coefficient;
}

compare_rules rules_of(const verify_options& options) {
    if (options.inputs && options.inputs != "decimal" && options.inputs != "double") {
        throw input_error("--inputs", *options.inputs, "is neither decimal nor double",
                          "write decimal for numbers as typed, double for their nearest doubles");
    }
    if (options.format != "csv" && options.format != "json") {
        throw input_error("--format", options.format, "is not a format", "write csv or json");
    }
    return {tolerance_of("--tolerance", options.tolerance),
            tolerance_of("--relative", options.relative),
            tolerance_of("--ulp", options.ulps),
            options.rounding,
            options.inputs == "double",
            options.modulo_turn};
}

// A list of coefficients has no rows to compare with a truth, but they have to agree with each other.
int verify_list(const verify_options& options) {
    const auto verdict = convergence::verdict_on(real_list_in(*options.coefficients, std::nullopt));
    const table data = table_of_suspect(verdict, defaults::digits);
    row_target target(options.out);
    target.write(options.format == "json" ? to_json(data) : to_csv(data));
    target.finish();
    fmt::print(stderr, "{}", text_of_suspect(verdict, data));
    return verdict.suspect ? 1 : 0;
}

int run_verify(const verify_options& options) {
    if (options.certificate) {
        require_output_place("--certificate", *options.certificate);
    }
    if (options.file.empty() && !options.coefficients) {
        throw input_error("no FILE is given: name a table, or a list by --coefficients LIST");
    }
    if (options.coefficients) {
        rules_of(options);
        return verify_list(options);
    }
    compare_rules rules = rules_of(options);
    const int jobs = jobs_of(options.jobs);  // complains before a file is read
    const auto subject = row_subject_of(options.problem, options.motion, rules);
    input_stream source("FILE", options.file);
    column_file records(source);
    const column_names names(source.name(), records.names(), records.count(), options.columns, subject->known());
    subject->read(names);
    const row_writer writer(options.format == "json", records.between(), names.own(),
                            added_columns(subject->compared()));
    if (!records.has_records()) {
        throw input_error(fmt::format("{} has no row to compare: write one below its names", source.name()));
    }
    row_target target(options.out);
    target.write(writer.head());
    const comparison_run run{names, rules, writer, *subject, !options.inputs, jobs};
    verify_summary summary(source.name(), own_names(run, std::vector<bool>(subject->compared().size(), true)));
    compare_all(records, run, target, summary);
    target.write(writer.tail());
    target.finish();
    summary.print();
    if (options.certificate) {
        certify_times_of_table(*options.certificate, options.problem, options.file, names, rules.inputs_are_doubles);
    }
    return summary.exit_code();
}

}  // namespace

subcommand verify_command(CLI::App& program) {
    const auto options = std::make_shared<verify_options>();
    CLI::App* command = program.add_subcommand(
        "verify",
        "compare a table of theta at times, of the unknowns of a problem or of elliptic functions with proved values");
    command->add_option(
        "FILE", options->file,
        "columns time and unknowns of --problem; or time, theta, optionally omega, and a motion: theta0 "
        "and omega0, gap "
        "or energy, optionally "
        "direction, length and gravity; or u (phi, x), m (m1, k) and am, sn, cn, dn, K, F, ..., complex u "
        "as 1+2i or in u_re and u_im with sn_re and sn_im, ...; - for stdin");
    command
        ->add_option("--coefficients", options->coefficients,
                     "a list of coefficients instead of a table: search for one that the others contradict; exit 1 if "
                     "there is one")
        ->type_name("LIST");
    options->motion.add_to(*command);
    options->problem.add_to(*command);
    command
        ->add_option(
            "--columns,--rename", options->columns,
            "the names of your columns: t=time,E=energy; NAME=- ignores a column; if the file has no header, name "
            "all columns in order")
        ->type_name("THEIRS=OURS,...");
    command
        ->add_option(
            "--tolerance", options->tolerance,
            "largest |error| (default: one unit of the last digit as written; for doubles in decimal half a unit in "
            "the last place)")
        ->type_name("X");
    command
        ->add_option("--relative", options->relative,
                     "largest |error/value|; if --tolerance is also given, meeting either is enough")
        ->type_name("X");
    command
        ->add_option("--ulp", options->ulps,
                     "tolerance in units in the last place of double precision, relative to max(1,|value|)")
        ->type_name("N");
    command->add_flag("--rounding", options->rounding,
                      "half a unit of the last digit as written: for printed tables, whose values are rounded");
    command->add_flag("--modulo-2pi", options->modulo_turn, "theta counts modulo 2 pi");
    command
        ->add_option("--inputs", options->inputs,
                     "decimal: times and arguments as typed; double: their nearest doubles "
                     "(default: double if they are doubles in decimal, such as those of numpy.savetxt)")
        ->type_name("decimal|double");
    command
        ->add_option(
            "--certificate", options->certificate,
            "with --problem: write a certificate of the solution at the times of FILE, with which check/compare.py "
            "compares FILE without this program")
        ->type_name("CERTIFICATE");
    command->add_option("--format", options->format, "csv or json")->type_name("FORMAT")->capture_default_str();
    command->add_option("--out", options->out, "write the rows to this file instead of stdout")->type_name("FILE");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    return {command, [options] { return run_verify(*options); }};
}

}  // namespace libration
