// libration journal DIR: lists the journals of a directory; recomputes a sample, exports, drops, merges shards.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "run/parallel.hpp"
#include "run/sha256.hpp"
#include "sweep/journal_merge.hpp"
#include "sweep/named_order.hpp"
#include "sweep/study_journal.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

namespace fs = std::filesystem;

struct journal_options {
    std::vector<std::string> folders;
    std::optional<std::string> check, file, jobs;
    bool drop = false;
    output_options output;
};

// A journal as shown in the list.
struct listed_journal {
    journal_stamp stamp;
    journal_counts counts;
    std::uintmax_t bytes;
    std::vector<std::string> commands;
    failures_found failures;
};

listed_journal listed(const fs::path& path) {
    const journal cells(path, journal::access::read);
    listed_journal result{cells.stamp().value_or(journal_stamp{path.stem().string(), "", ""}),
                          cells.counts(),
                          fs::file_size(path),
                          cells.commands(),
                          {}};
    cells.for_each([&](const journal_record& each) {
        if (each.failed) {
            result.failures.add(each);
        }
    });
    return result;
}

table table_of(const std::vector<listed_journal>& journals) {
    using row = listed_journal;
    static const column_list<row> columns{
        {"study", "", [](const row& r) { return r.stamp.study; }},
        {"cells", "finished", [](const row& r) { return r.counts.done; }},
        {"failed", "cells that failed", [](const row& r) { return r.counts.failed; }},
        {"seconds", "of one core, of all cells",
         [](const row& r) { return cell::number(fmt::format("{:.3f}", r.counts.seconds), 3); }},
        {"bytes", "of the file", [](const row& r) { return r.bytes; }},
        {"version", "of the study", [](const row& r) { return r.stamp.version; }},
        {"library", "version and commit of libration", [](const row& r) { return r.stamp.library; }},
        {"commands", "whose cells it contains",
         [](const row& r) { return fmt::format("{}", fmt::join(r.commands, "; ")); }}};
    return make_table(columns, journals);
}

int list_journals(const journal_options& options) {
    options.output.check();
    std::vector<listed_journal> all;
    for (const std::string& folder : options.folders) {
        for (const fs::path& path : journals_in(folder)) {
            all.push_back(listed(path));
        }
    }
    options.output.write(table_of(all));
    for (const listed_journal& each : all) {
        if (each.failures.count > 0) {
            say_line(each.stamp.study + ": " + message_of(each.failures));
        }
    }
    return 0;
}

// 1% or 0.5%: a fraction between 0 and 1.
double share_of(const std::string& words) {
    const char* const remedy = "write a share of the cells such as 1% or 100%";
    const std::string number = words.ends_with('%') ? words.substr(0, words.size() - 1) : words;
    const exact percent = reading("--check", words, remedy, [&] { return read_exact(number); });
    if (percent.measure != unit::one || percent.coefficient <= 0 || percent.coefficient > 100) {
        throw input_error("--check", words, "is not between 0% and 100%", remedy);
    }
    return static_cast<double>(percent.coefficient) / 100;
}

// The reproducible part of a cell: all tables except those of times.
bool same_rows(const study_cells& of, const std::string& a, const std::string& b) {
    const cell_rows first = rows_from(a);
    const cell_rows second = rows_from(b);
    bool same = first.size() == second.size();
    for (std::size_t place = 0; same && place < first.size(); ++place) {
        same = of.plan().tables.at(place).timed || first[place] == second[place];
    }
    return same;
}

// The cells of a journal that are recomputed: for each command those that no previous command has.
class journal_check {
public:
    journal_check(const fs::path& path, double share, int jobs)
        : cells_(path, journal::access::read), share_(share), jobs_(jobs), random_(std::random_device()()) {}

    void run() {
        for (const std::string& command : cells_.commands()) {
            check_command(command);
        }
    }
    std::size_t checked() const { return checked_; }
    const std::vector<std::string>& different() const { return different_; }

private:
    void check_command(const std::string& command) {
        const study_order order = order_from(command, jobs_);
        const study_cells of(order);
        require_own_stamp(cells_, of.stamp(), "DIR");
        const auto work = sample(of);
        std::mutex mutex;
        progress shown(of.of().name + ", cells checked", work.size());
        on_threads(work.size(), jobs_, [&](std::size_t i) {
            for (const journal_record& again : of.compute(work[i])) {
                const auto kept = cells_.find(again.key);
                const bool same = kept && !again.failed && same_rows(of, kept->content, again.content);
                const std::lock_guard lock(mutex);
                ++checked_;
                if (!same) {
                    different_.push_back(again.inputs);
                }
            }
            shown.step();
        });
    }

    // At least one cell, if there is any.
    std::vector<group_work> sample(const study_cells& of) {
        std::vector<group_work> work;
        std::optional<group_work> any;
        std::uniform_real_distribution<double> draw(0, 1);
        for (std::size_t i = 0; i < of.plan().groups; ++i) {
            const cell_group group = of.plan().group(i);
            group_work chosen{i, {}};
            for (std::size_t which = 0; which < group.cells.size(); ++which) {
                const cell_key key = of.key(group.cells[which]);
                const auto record = cells_.find(key);
                if (!record || record->failed || !seen_.insert(key).second) {
                    continue;
                }
                any = any ? any : group_work{i, {which}};
                if (draw(random_) < share_) {
                    chosen.cells.push_back(which);
                }
            }
            if (!chosen.cells.empty()) {
                work.push_back(std::move(chosen));
            }
        }
        if (work.empty() && any) {
            work.push_back(*any);
        }
        return work;
    }

    journal cells_;
    double share_;
    int jobs_;
    std::mt19937_64 random_;
    std::set<cell_key> seen_;
    std::size_t checked_ = 0;
    std::vector<std::string> different_;
};

int check_journals(const journal_options& options) {
    const double share = share_of(*options.check);
    const int jobs = jobs_of(options.jobs);
    bool good = true;
    for (const std::string& folder : options.folders) {
        for (const fs::path& path : journals_in(folder)) {
            journal_check check(path, share, jobs);
            check.run();
            const auto& different = check.different();
            fmt::print("{}: {} cells recomputed, {}\n", path.string(), check.checked(),
                       different.empty() ? "all equal"
                                         : fmt::format("{} differ: {}", different.size(), fmt::join(different, "; ")));
            good = good && different.empty();
        }
    }
    return good ? 0 : 1;
}

nlohmann::ordered_json described_record(const std::string& study, const journal_record& each) {
    nlohmann::ordered_json line{{"study", study},        {"key", hexadecimal(each.key)}, {"inputs", each.inputs},
                                {"failed", each.failed}, {"attempts", each.attempts},    {"seconds", each.seconds}};
    if (each.failed) {
        line["reason"] = each.content;
        return line;
    }
    line["tables"] = nlohmann::ordered_json::array();
    for (const auto& of_table : rows_from(each.content)) {
        auto rows = nlohmann::ordered_json::array();
        for (const table_row_cells& row : of_table) {
            auto cells = nlohmann::ordered_json::array();
            for (const cell& one : row) {
                cells.push_back(one.text());
            }
            rows.push_back(std::move(cells));
        }
        line["tables"].push_back(std::move(rows));
    }
    return line;
}

// One JSON object per line, completely or not at all.
int export_journals(const journal_options& options) {
    const fs::path target(*options.file);
    const fs::path beside = target.string() + ".part";
    std::ofstream out(beside, std::ios::binary);
    long count = 0;
    for (const std::string& folder : options.folders) {
        for (const fs::path& path : journals_in(folder)) {
            const journal cells(path, journal::access::read);
            cells.for_each([&](const journal_record& each) {
                out << described_record(path.stem().string(), each).dump() << '\n';
                ++count;
            });
        }
    }
    out.close();
    std::error_code problem;
    if (out) {
        fs::rename(beside, target, problem);
    }
    if (!out || problem) {
        fs::remove(beside, problem);
        throw input_error("--export", *options.file, "cannot be written", "name a file in a writable directory");
    }
    say_line(fmt::format("wrote {} cells to {}", count, *options.file));
    return 0;
}

int drop_journals(const journal_options& options) {
    for (const std::string& folder : options.folders) {
        for (const fs::path& path : journals_in(folder)) {
            drop_journal(path);
            say_line("removed " + path.string());
        }
    }
    return 0;
}

int merge(const journal_options& options) {
    const std::vector<std::string> folders(options.folders.begin() + 1, options.folders.end());
    if (!options.output.file()) {
        throw input_error("journal merge: add --out DIR for the tables of all shards");
    }
    if (folders.empty()) {
        throw input_error("DIR", "", "is missing",
                          "write the directories of the shards: journal merge DIR... --out DIR");
    }
    const failures_found failures = merge_journals(folders, *options.output.file(), jobs_of(options.jobs));
    if (failures.count > 0) {
        say_line(message_of(failures));
    }
    return failures.count > 0 ? 1 : 0;
}

int run_journal(const journal_options& options) {
    try {
        if (options.folders.front() == "merge") {
            return merge(options);
        }
        return options.check  ? check_journals(options)
               : options.file ? export_journals(options)
               : options.drop ? drop_journals(options)
                              : list_journals(options);
    } catch (const journal_error& problem) {
        refuse_journal(problem, "DIR");
    }
}

}  // namespace

subcommand journal_command(CLI::App& program) {
    const auto options = std::make_shared<journal_options>();
    CLI::App* command = program.add_subcommand(
        "journal",
        "list the finished cells of a study (journal DIR), or merge shards (journal merge DIR... --out DIR)");
    command->add_option("DIR", options->folders, "the output folder of a study, or 'merge' and those of its shards")
        ->required()
        ->type_name("DIR");
    command->add_option("--check", options->check, "recompute this share of the cells and compare: 1%")
        ->type_name("P%");
    command->add_option("--export", options->file, "write all cells to FILE, one JSON object per line")
        ->type_name("FILE");
    command->add_flag("--drop", options->drop, "remove the journals");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    options->output.add_to(*command, output_options::columns_option::not_here);
    return {command, [options] { return run_journal(*options); }};
}

}  // namespace libration
