// libration verify: other people's theta and omega, row by row, against proved values.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "motion/motion_options.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "run/parallel.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"
#include "verify/verify_files.hpp"
#include "verify/verify_summary.hpp"

namespace libration {

using namespace pendulum;

namespace {

struct verify_options {
    motion_options motion;
    std::string file;
    std::optional<std::string> tolerance;
    std::optional<std::string> ulps;
    std::string inputs = "decimal";
    std::optional<std::string> out;
    std::optional<std::string> jobs;
};

constexpr std::size_t batch_rows = 256;
constexpr std::size_t batches_per_job = 16;

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "'" : ", '") + name + "'";
    }
    return text;
}

verify_columns columns_of(const std::string& file, const std::vector<std::string>& header, const verify_rules& rules) {
    verify_columns columns;
    columns.count = header.size();
    const auto find = [&](const char* name) -> std::optional<std::size_t> {
        const auto at = std::find(header.begin(), header.end(), name);
        if (at != header.end() && std::find(at + 1, header.end(), name) != header.end()) {
            throw input_error(fmt::format("{} has two columns '{}'", file, name));
        }
        return at == header.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - header.begin()));
    };
    std::vector<std::string> missing;
    for (const auto& [name, to] : {std::pair{"time", &columns.time}, std::pair{"theta", &columns.theta}}) {
        const auto at = find(name);
        *to = at.value_or(0);
        if (!at) {
            missing.emplace_back(name);
        }
    }
    columns.omega = find("omega");
    columns.theta0 = find("theta0");
    columns.omega0 = find("omega0");
    columns.gap = find("gap");
    columns.energy = find("energy");
    columns.direction = find("direction");
    columns.time_typed = find("time_typed");
    columns.theta0_typed = find("theta0_typed");
    columns.omega0_typed = find("omega0_typed");
    columns.gap_typed = find("gap_typed");
    columns.energy_typed = find("energy_typed");
    if (!missing.empty()) {
        throw input_error(
            fmt::format("{} has no column {}: its columns are {}", file, listed(missing), listed(header)));
    }
    if (!columns.names_a_motion() && !rules.usual.names_a_motion() &&
        !(columns.theta0 && !rules.usual.omega0.empty())) {
        throw input_error(
            fmt::format("{} has no motion: its columns are {}; it needs 'theta0' and 'omega0', 'gap' or "
                        "'energy', or the options --theta0 and --omega0, --gap or --energy",
                        file, listed(header)));
    }
    return columns;
}

// The input's columns and ours; where the input has one of the name, ours says where it is from.
std::string header_text(const std::vector<std::string>& header, const verify_columns& columns) {
    std::string text;
    for (const std::string& name : header) {
        text += (text.empty() ? "" : ",") + written_cell(name);
    }
    for (const std::string& name : added_columns(columns)) {
        const bool taken = std::find(header.begin(), header.end(), name) != header.end();
        text += (taken ? ",verify_" : ",") + name;
    }
    return text + '\n';
}

using row_batch = std::vector<csv_record>;

std::vector<row_batch> read_batches(csv_records& records, std::size_t most) {
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

void show_progress(long rows) {
    if (::isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "\r\033[K{}", rows > 0 ? fmt::format("{} rows judged", rows) : "");
        std::fflush(stderr);
    }
}

// Batches are judged in parallel and written in their order; a set of batches at a time is in memory.
void judge_all(csv_records& records, const verify_columns& columns, const verify_rules& rules, int jobs,
               row_target& target, verify_summary& summary) {
    const std::size_t most = batches_per_job * static_cast<std::size_t>(jobs);
    for (auto batches = read_batches(records, most); !batches.empty(); batches = read_batches(records, most)) {
        std::vector<std::vector<judged_row>> judged(batches.size());
        on_threads(batches.size(), jobs, [&](std::size_t i) {
            row_judge judge(columns, rules);
            judged[i].reserve(batches[i].size());
            for (const csv_record& record : batches[i]) {
                judged[i].push_back(judge(record));
            }
        });
        show_progress(0);
        for (const auto& batch : judged) {
            for (const judged_row& row : batch) {
                target.write(row.text + '\n');
                summary.add(row);
            }
        }
        show_progress(summary.rows());
    }
    show_progress(0);
}

// A tolerance is a decimal or a fraction, so that judging compares with it exactly.
rational tolerance_of(const std::string& option, const std::string& value) {
    const exact tolerance = positive_number_of(option, value);
    if (!tolerance.is_fraction()) {
        throw input_error(option, value, "is not a decimal or a fraction", "write a number such as 1e-12 or 1/3");
    }
    return tolerance.coefficient;
}

verify_rules rules_of(const verify_options& options) {
    verify_rules rules;
    if (options.tolerance && options.ulps) {
        throw input_error("--ulp", *options.ulps, "comes together with --tolerance '" + *options.tolerance + "'",
                          "give one of the two");
    }
    if (options.tolerance) {
        rules.tolerance = tolerance_of("--tolerance", *options.tolerance);
    }
    if (options.ulps) {
        rules.ulps = tolerance_of("--ulp", *options.ulps);
    }
    if (options.inputs != "decimal" && options.inputs != "double") {
        throw input_error("--inputs", options.inputs, "is neither decimal nor double",
                          "write decimal for numbers as typed, double for their nearest doubles");
    }
    rules.inputs_are_doubles = options.inputs == "double";
    const auto given = [&](const char* name) { return options.motion.given(name).value_or(""); };
    rules.usual = {given("--theta0"), given("--omega0"), given("--gap"), given("--energy"), given("--direction")};
    rules.squared_frequency = options.motion.squared_frequency();
    const bool by_energy = !rules.usual.gap.empty() || !rules.usual.energy.empty();
    if (by_energy || (!rules.usual.theta0.empty() && !rules.usual.omega0.empty())) {
        options.motion.choose_for({scalar_kind::proved, 50});  // complains as every command does
    }
    return rules;
}

int run_verify(const verify_options& options) {
    const verify_rules rules = rules_of(options);
    const int jobs = jobs_of(options.jobs);
    row_source source(options.file);
    const std::string name = options.file == "-" ? "stdin" : options.file;
    const auto first = source.records().next();
    const auto cells = first ? cells_of(first->text) : std::nullopt;
    if (!cells) {
        throw input_error(fmt::format("{} has no header: name the columns in its first line", name));
    }
    std::vector<std::string> header;
    std::transform(cells->begin(), cells->end(), std::back_inserter(header), trimmed);
    const verify_columns columns = columns_of(name, header, rules);
    row_target target(options.out);
    target.write(header_text(header, columns));
    verify_summary summary(name);
    judge_all(source.records(), columns, rules, jobs, target, summary);
    target.finish();
    if (summary.rows() == 0) {
        throw input_error(fmt::format("{} has no row to judge", name));
    }
    summary.print();
    return summary.exit_code();
}

}  // namespace

subcommand verify_command(CLI::App& program) {
    const auto options = std::make_shared<verify_options>();
    CLI::App* command = program.add_subcommand(
        "verify", "judge a CSV of time, theta[, omega] and motion, row by row, against proved values");
    command
        ->add_option("FILE", options->file,
                     "CSV with columns time, theta, optionally omega, and theta0 and omega0, "
                     "gap or energy, optionally direction; - for stdin")
        ->required();
    options->motion.add_to(*command);
    command
        ->add_option("--tolerance", options->tolerance, "largest |error|; one unit of the row's last digit without it")
        ->type_name("X");
    command
        ->add_option("--ulp", options->ulps, "the tolerance in units in the last place of a double of max(1,|value|)")
        ->type_name("N");
    command
        ->add_option("--inputs", options->inputs, "decimal: times and motions as typed; double: their nearest doubles")
        ->type_name("decimal|double")
        ->capture_default_str();
    command->add_option("--out", options->out, "write the CSV to this file instead of stdout")->type_name("FILE");
    command->add_option("--jobs", options->jobs, "threads; all cores without it")->type_name("J");
    return {command, [options] { return run_verify(*options); }};
}

}  // namespace libration
