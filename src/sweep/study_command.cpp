// libration study NAME: runs one study with any parameters; to stdout, or to files with figures under --out.
#include "sweep/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct study_options {
    std::string name;
    std::map<std::string, std::optional<std::string>> words;  // by option
    std::optional<std::string> columns, out, jobs;

    study_words said() const {
        study_words result;
        for (const auto& [option, value] : words) {
            if (value) {
                result[option] = *value;
            }
        }
        return result;
    }
};

bool same_columns(const table& a, const table& b) {
    return std::equal(a.columns().begin(), a.columns().end(), b.columns().begin(), b.columns().end(),
                      [](const column& x, const column& y) { return x.name == y.name; });
}

// What goes to stdout under one header: the first table and those with its columns. The others are named.
table under_one_header(const std::vector<study_table>& parts, std::string& left_out) {
    table all(parts.front().data.columns());
    for (const study_table& part : parts) {
        if (same_columns(part.data, all)) {
            all.append(part.data);
        } else {
            left_out += (left_out.empty() ? "" : ", ") + part.suffix;
        }
    }
    return all;
}

void print_tables(const study_order& order) {
    std::string left_out;
    const table all = under_one_header(tables_of(order), left_out);
    write_to_stdout(to_csv(order.columns ? with_named_columns(all, *order.columns) : all));
    if (!left_out.empty()) {
        fmt::print(stderr, "libration: {} makes more tables ({}): see them with --out DIR\n", order.what->name,
                   left_out);
    }
}

int run_study(const study_options& options) {
    const study& what = study_named("study", options.name);
    try {
        study_order order = order_of(what, options.said(), jobs_of(options.jobs));
        if (!order.left_out.empty()) {
            fmt::print(stderr, "libration: left out {}\n", order.left_out);
        }
        order.columns = options.columns;
        if (options.out) {
            make_study(order, *options.out);
            fmt::print(stderr, "libration: wrote {}/{}\n", *options.out, what.name);
        } else {
            print_tables(order);
        }
        return 0;
    } catch (const error& problem) {
        if (problem.kind() == error_kind::undecided) {
            throw;
        }
        if (problem.kind() == error_kind::range) {
            throw input_error("--scalar", options.words.at("--scalar").value_or("double"),
                              std::string("cannot hold an energy of the list (") + problem.what() + ")",
                              "use --scalar mpfr:DIGITS");
        }
        const std::string reason = problem.value().empty() ? problem.reason() : std::string("finds: ") + problem.what();
        const bool names_option = problem.subject().starts_with("--");
        throw input_error("study", what.name, reason,
                          "leave that value out" + (names_option ? " of " + problem.subject() : ""));
    }
}

}  // namespace

subcommand study_command(CLI::App& program) {
    const auto options = std::make_shared<study_options>();
    CLI::App* command = program.add_subcommand("study", "run one study; 'libration studies' lists them");
    command->add_option("NAME", options->name, "which study")->required();
    for (const study_option& each : options_of(all_studies())) {
        command->add_option(each.option, options->words[each.option], each.help)->type_name(each.type_name);
    }
    command
        ->add_option("--columns", options->columns,
                     "of the tables for LaTeX, and of the CSV on stdout, these columns alone: NAME,NAME,...")
        ->type_name("NAMES");
    command->add_option("--out", options->out, "write DIR/NAME/: tables, figures, provenance; without it CSV to stdout")
        ->type_name("DIR");
    command->add_option("--jobs", options->jobs, "threads; all cores without it")->type_name("J");
    return {command, [options] { return run_study(*options); }};
}

}  // namespace libration
