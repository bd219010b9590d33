// libration reproduce: every study with its own parameters, the claims, the reference values, then the report.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "claims/claim.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "report/reference_set.hpp"
#include "report/report.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct reproduce_options {
    std::string out = "results";
    std::optional<std::string> only, skip, jobs;
};

// What a run of reproduce consists of: studies, the claims and the reference values, which --only and --skip call by
// name.
struct work {
    std::vector<const study*> studies;
    bool claims = true;
    bool references = true;
};

constexpr const char* claims_name = "claims";
constexpr const char* references_name = "reference";

work named(const char* option, const std::string& list) {
    work result{{}, false, false};
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        if (name == claims_name) {
            result.claims = true;
        } else if (name == references_name) {
            result.references = true;
        } else {
            result.studies.push_back(&study_named(option, name));
        }
    }
    if (result.studies.empty() && !result.claims && !result.references) {
        throw input_error(option, list, "names no study", "write names with commas between them");
    }
    return result;
}

work chosen(const reproduce_options& options) {
    work result = options.only ? named("--only", *options.only) : work{all_studies()};
    if (options.skip) {
        const work left_out = named("--skip", *options.skip);
        for (const study* each : left_out.studies) {
            std::erase(result.studies, each);
        }
        result.claims = result.claims && !left_out.claims;
        result.references = result.references && !left_out.references;
    }
    return result;
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

// Runs one part; its failure becomes a line and does not stop the others.
template <class Part>
void attempt(const std::string& name, std::vector<std::string>& failures, const Part& part) {
    try {
        part();
    } catch (const std::exception& problem) {
        failures.push_back(name + ": " + problem.what());
    }
}

void make_claims(const std::string& folder, int jobs) {
    const auto claims = all_claims();
    write_into((std::filesystem::path(folder) / "claims.csv").string(), to_csv(claims_table(judge(claims, jobs))));
}

int run_reproduce(const reproduce_options& options) {
    const work chosen_work = chosen(options);
    const int jobs = jobs_of(options.jobs);
    const auto orders = orders_of(chosen_work.studies, jobs);
    output_folder into("--out", options.out);
    std::vector<std::string> failures;
    for (const study_order& order : orders) {
        const study* each = order.what;
        fmt::print(stderr, "libration: {}{} (about {:.1f} s)\n", order.request.shown.before, each->name, each->seconds);
        attempt(each->name, failures, [&] {
            write_study(order, options.out);
            draw_study(*each, options.out);
        });
    }
    into.keep();
    if (chosen_work.claims) {
        fmt::print(stderr, "libration: claims\n");
        attempt(claims_name, failures, [&] { make_claims(options.out, jobs); });
    }
    if (chosen_work.references) {
        fmt::print(stderr, "libration: reference values\n");
        attempt(references_name, failures, [&] { write_reference_set(options.out, jobs); });
    }
    attempt("report", failures, [&] { write_report(options.out); });
    for (const std::string& failure : failures) {
        fmt::print(stderr, "libration: failed: {}\n", failure);
    }
    fmt::print(stderr, "libration: wrote {0}; open {0}/index.html\n", options.out);
    return failures.empty() ? 0 : 1;
}

}  // namespace

subcommand reproduce_command(CLI::App& program) {
    const auto options = std::make_shared<reproduce_options>();
    CLI::App* command = program.add_subcommand(
        "reproduce",
        "run every study with its own parameters, judge the claims, make the reference values, write the report");
    command->add_option("--out", options->out, "the folder to write")->type_name("DIR")->capture_default_str();
    command->add_option("--only", options->only, "these studies only (and 'claims', 'reference')")->type_name("NAMES");
    command->add_option("--skip", options->skip, "all but these studies (or 'claims', 'reference')")
        ->type_name("NAMES");
    command->add_option("--jobs", options->jobs, "threads; all cores without it")->type_name("J");
    return {command, [options] { return run_reproduce(*options); }};
}

}  // namespace libration
