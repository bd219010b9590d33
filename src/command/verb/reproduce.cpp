// libration reproduce: the studies of a set with their own parameters, the claims, the reference values and the report,
// in a separate directory, compared with the published results.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <thread>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "paper/claims/claim.hpp"
#include "paper/report/publish.hpp"
#include "paper/report/reference_set.hpp"
#include "paper/report/report.hpp"
#include "paper/report/reproduce_set.hpp"
#include "paper/report/results_comparison.hpp"
#include "paper/report/unfinished_run.hpp"
#include "run/shared_cores.hpp"
#include "sweep/study_figures.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_order.hpp"
#include "sweep/study_run.hpp"
#include "text/input_error.hpp"
#include "text/members.hpp"

namespace libration {

namespace {

namespace fs = std::filesystem;

struct reproduce_options {
    std::string set = "paper";
    std::string out = "reproduced";
    std::string results = "results";
    bool results_given = false;
    bool publish = false;
    std::optional<std::string> only, skip, jobs;
};

// A piece of the work: its files are made by one call.
struct part {
    std::string name;
    double seconds;  // expected on two cores
    bool alone;      // nothing runs at the same time
    std::function<void(const progress_context&)> make;
};

constexpr double seconds_of_claims = 3;
constexpr double seconds_of_references = 0.5;

void make_claims(const std::string& folder, int jobs) {
    const auto claims = all_claims();
    write_into((fs::path(folder) / place_of_part(claims_name)).string(), to_csv(claims_table(judge(claims, jobs))));
}

// A study with the parameters of its order.
part part_of(const study_order& order, const std::string& out, int jobs) {
    const study& what = *order.what;
    return {what.name, what.seconds, what.alone, [order, out, jobs](const progress_context& shown) {
                study_order own = order;
                own.request.jobs = jobs;
                own.request.shown = shown;
                const auto failures =
                    make_study(own, out, {.earlier = earlier_cells::taken_or_replaced, .part_of_more = true});
                if (failures.count > 0) {
                    throw std::runtime_error(message_of(failures));
                }
            }};
}

// All parts, the longest first, so that short ones fill the cores at the end.
std::vector<part> parts_of(const reproduce_set& set, const std::string& out, int jobs) {
    std::vector<part> parts;
    for (const study* each : set.studies) {
        parts.push_back(part_of(order_of(*each, {}, jobs), out, jobs));
    }
    for (const study_order* each : set.examples) {
        parts.push_back(part_of(*each, out, jobs));
    }
    if (set.claims) {
        parts.push_back({claims_name, seconds_of_claims, false,
                         [out, jobs](const progress_context& /*shown*/) { make_claims(out, jobs); }});
    }
    if (set.references) {
        parts.push_back({references_name, seconds_of_references, false,
                         [out, jobs](const progress_context& /*shown*/) { write_reference_set(out, jobs); }});
    }
    std::stable_sort(parts.begin(), parts.end(), [](const part& a, const part& b) { return a.seconds > b.seconds; });
    return parts;
}

// Makes parts side by side on shared cores. A failure becomes a line and does not stop the others.
class workshop {
public:
    workshop(const std::vector<part>& parts, unfinished_run& record, int cores)
        : parts_(parts),
          record_(record),
          cores_(cores),
          whole_(std::make_shared<work_estimate>(members_of(parts, &part::seconds))) {}

    /// The failures, in the order of the parts.
    std::vector<std::string> make_all() {
        std::vector<std::string> failures(parts_.size());
        make_those(false, failures);
        make_those(true, failures);
        std::erase(failures, "");
        return failures;
    }

private:
    // A part begins when a core is free for it; one that is to be alone waits for the one before it.
    void make_those(bool alone, std::vector<std::string>& failures) {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (parts_[i].alone != alone) {
                continue;
            }
            cores_.take(static_cast<int>(i));
            say_line(fmt::format("{}{} (about {:.1f} s)", before_of(i), parts_[i].name, parts_[i].seconds));
            threads.emplace_back([this, i, &failures] { make(i, failures[i]); });
            if (alone) {
                threads.back().join();
            }
        }
    }

    // In a separate thread, which was given a core.
    void make(std::size_t i, std::string& failure) {
        const part& own = parts_[i];
        const core_share share(cores_, static_cast<int>(i), core_share::taken);
        try {
            own.make({before_of(i), whole_, i});
            const std::lock_guard lock(mutex_);
            record_.add(own.name);
        } catch (const std::exception& problem) {
            failure = own.name + ": " + problem.what();
        }
        whole_->reached(i, 1);
    }

    std::string before_of(std::size_t i) const { return fmt::format("part {} of {}, ", i + 1, parts_.size()); }

    const std::vector<part>& parts_;
    unfinished_run& record_;
    shared_cores cores_;
    std::shared_ptr<work_estimate> whole_;
    std::mutex mutex_;
};

// results/ here or, elsewhere, that of the tree from which the program comes, or the tables that are installed with it.
std::string usual_results() {
    std::error_code error;
    const fs::path own = fs::path(studies_folder()).parent_path() / "results";
    return !fs::is_directory("results", error) && fs::is_directory(own, error) ? own.string() : "results";
}

// The published folder to compare with, if there is one.
bool has_published(const reproduce_options& options) {
    std::error_code error;
    const bool there = fs::is_directory(options.results, error);
    const bool same = there && fs::exists(options.out, error) && fs::equivalent(options.out, options.results, error);
    if (options.publish && same) {
        throw input_error("--publish", options.results, "is replaced by the folder of --out, and is that",
                          "leave --out away or name another folder");
    }
    if (options.results_given && !there && !options.publish) {
        throw input_error("--results", options.results, "is not a directory", "name the published folder");
    }
    return there && !same;
}

void say_all(const std::vector<std::string>& lines) { std::for_each(lines.begin(), lines.end(), say_line); }

// The parts that an interrupted run has not made.
std::vector<part> left_of(std::vector<part> parts, const unfinished_run& record) {
    const auto all = parts.size();
    std::erase_if(parts, [&](const part& each) { return record.has(each.name); });
    if (parts.size() < all) {
        say_line(fmt::format("resuming an interrupted run: {} of {} parts are done", all - parts.size(), all));
    }
    return parts;
}

// Compares and publishes; whether what has to be the same is.
bool judge_by_published(const reproduce_options& options, const std::vector<std::string>& names, bool complete) {
    bool same = true;
    if (has_published(options)) {
        const results_comparison found = compared(options.out, options.results, names);
        say_all(found.lines(options.results));
        same = found.same() || options.publish;
    } else if (!options.publish) {
        say_line("not compared: there is no folder of published results: name it by --results DIR");
    }
    if (options.publish && complete) {
        publish(options.out, options.results, names);
        say_line("published in " + options.results);
    }
    return same;
}

int run_reproduce(const reproduce_options& options) {
    const reproduce_set set = chosen_of(set_named(options.set), options.only, options.skip);
    const int jobs = jobs_of(options.jobs);
    has_published(options);  // throws
    const auto parts = parts_of(set, options.out, jobs);
    output_folder into("--out", options.out);
    unfinished_run record(options.out);
    const auto left = left_of(parts, record);
    std::vector<std::string> failures = workshop(left, record, jobs).make_all();
    into.keep();
    const auto attempt = [&](const char* name, const auto& step) {
        try {
            return step();
        } catch (const std::exception& problem) {
            failures.push_back(std::string(name) + ": " + problem.what());
            return false;
        }
    };
    attempt("report", [&] {
        write_report(options.out);
        return true;
    });
    const bool complete = failures.empty();
    const bool same =
        attempt("comparison", [&] { return judge_by_published(options, members_of(parts, &part::name), complete); });
    if (failures.empty()) {
        record.finish();
    }
    for (const std::string& failure : failures) {
        say_line("failed: " + failure);
    }
    say_line(fmt::format("wrote {0}; open {0}/index.html", options.out));
    return failures.empty() && same ? 0 : 1;
}

}  // namespace

subcommand reproduce_command(CLI::App& program) {
    const auto options = std::make_shared<reproduce_options>();
    CLI::App* command = program.add_subcommand("reproduce",
                                               "make the paper's studies, claims and reference values again, in about "
                                               "two minutes, write the report, compare with "
                                               "results/");
    command->add_option("SET", options->set, "paper, problems, proved or all")->capture_default_str();
    command->add_option("--out", options->out, "the folder to write; an interrupted run is resumed")
        ->type_name("DIR")
        ->capture_default_str();
    command
        ->add_option("--results", options->results,
                     "the published folder (default: ./results, or else that of the source tree or of the "
                     "installation); if a table of mpfr or of balls differs from it, "
                     "the exit code is 1")
        ->type_name("DIR");
    command->add_flag("--publish", options->publish, "then replace the published folder by what was made");
    command->add_option("--only", options->only, "these studies only (and 'claims', 'reference')")->type_name("NAMES");
    command->add_option("--skip", options->skip, "all but these studies (or 'claims', 'reference')")
        ->type_name("NAMES");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    return {command, [options, command] {
                options->results_given = command->count("--results") > 0;
                if (!options->results_given && !options->publish) {
                    options->results = usual_results();
                }
                return run_reproduce(*options);
            }};
}

}  // namespace libration
