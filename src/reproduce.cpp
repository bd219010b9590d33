// libration reproduce: every study with its own parameters, the claims, then the report.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "claims/claim.hpp"
#include "options.hpp"
#include "study_files.hpp"
#include "subcommand.hpp"
#include "sweep/input_error.hpp"
#include "sweep/study_order.hpp"

namespace libration {

namespace {

struct reproduce_options {
    std::string out = "results";
    std::optional<std::string> only, skip, jobs;
};

// The studies that a list of names means.
std::vector<const study*> named(const char* option, const std::string& list) {
    std::vector<const study*> studies;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        studies.push_back(&study_named(option, name));
    }
    if (studies.empty()) {
        throw input_error(option, list, "names no study", "write names with commas between them");
    }
    return studies;
}

std::vector<const study*> chosen(const reproduce_options& options) {
    auto studies = options.only ? named("--only", *options.only) : all_studies();
    if (options.skip) {
        for (const study* left_out : named("--skip", *options.skip)) {
            std::erase(studies, left_out);
        }
    }
    return studies;
}

// Their orders, each knowing its place in the whole work.
std::vector<study_order> orders_of(const std::vector<const study*>& studies, int jobs) {
    std::vector<study_order> orders;
    orders.reserve(studies.size());
    double seconds_after = 0;
    for (const study* each : studies) {
        seconds_after += each->seconds;
    }
    for (const study* each : studies) {
        orders.push_back(order_of(*each, {}, jobs));
        seconds_after -= each->seconds;
        orders.back().request.shown = {fmt::format("study {} of {}, ", orders.size(), studies.size()), seconds_after};
    }
    return orders;
}

// What is in the folder, for a reader who comes to it first.
std::string index_of(const std::vector<const study*>& studies) {
    std::string text =
        "# Results\n\n"
        "Made by `./run reproduce`; do not edit. Each folder holds the tables of one study (CSV: one header line, one\n"
        "observation a row), NAME.json with the command, the columns and their units and what it was made with, and "
        "the\n"
        "figures drawn from the tables.\n\n"
        "| study | question | command |\n| --- | --- | --- |\n";
    for (const study* each : studies) {
        text += fmt::format("| [{0}]({0}) | {1} | `./run study {0}` |\n", each->name, each->question);
    }
    return text;
}

int run_reproduce(const reproduce_options& options) {
    const auto studies = chosen(options);
    const auto orders = orders_of(studies, jobs_of(options.jobs));
    output_folder into("--out", options.out);
    std::vector<std::string> failures;
    for (const study_order& order : orders) {
        const study* each = order.what;
        fmt::print(stderr, "libration: {}{} (about {:.1f} s)\n", order.request.shown.before, each->name, each->seconds);
        try {
            write_study(order, options.out);
            draw_study(*each, options.out);
        } catch (const input_error&) {
            throw;
        } catch (const std::exception& problem) {
            failures.push_back(each->name + ": " + problem.what());
        }
    }
    into.keep();
    if (!options.only && !options.skip) {
        write_whole_file((std::filesystem::path(options.out) / "README.md").string(), index_of(studies));
    }
    for (const std::string& failure : failures) {
        fmt::print(stderr, "libration: failed: {}\n", failure);
    }
    fmt::print(stderr, "libration: wrote {}\n", options.out);
    return failures.empty() ? 0 : 1;
}

}  // namespace

subcommand reproduce_command(CLI::App& program) {
    const auto options = std::make_shared<reproduce_options>();
    CLI::App* command = program.add_subcommand("reproduce", "run every study with its own parameters");
    command->add_option("--out", options->out, "the folder to write")->type_name("DIR")->capture_default_str();
    command->add_option("--only", options->only, "these studies only")->type_name("NAMES");
    command->add_option("--skip", options->skip, "all but these studies")->type_name("NAMES");
    command->add_option("--jobs", options->jobs, "threads; all cores without it")->type_name("J");
    return {command, [options] { return run_reproduce(*options); }};
}

}  // namespace libration
