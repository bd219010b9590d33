#include "sweep/journal_merge.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "option/options.hpp"
#include "run/progress.hpp"
#include "sweep/named_order.hpp"
#include "sweep/study_files.hpp"
#include "sweep/study_journal.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace fs = std::filesystem;

std::vector<fs::path> journals_in(const std::string& folder) {
    const fs::path own =
        fs::path(folder) / (fs::absolute(fs::path(folder) / ".").parent_path().filename().string() + ".journal");
    if (fs::is_regular_file(own)) {
        return {own};
    }
    std::set<fs::path> found;
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(folder, problem)) {
        const fs::path inside = entry.path() / (entry.path().filename().string() + ".journal");
        if (fs::is_regular_file(inside)) {
            found.insert(inside);
        }
    }
    if (found.empty()) {
        throw input_error("DIR", folder, "contains no journal NAME/NAME.journal", "name the --out of a study");
    }
    return {found.begin(), found.end()};
}

namespace {

// Adds all records of one journal. Cells in both must be equal; of two attempts at a cell the finished one counts.
void add_all(const journal& from, journal& to) {
    constexpr std::size_t together = 1000;
    std::vector<journal_record> fresh;
    const auto keep = [&] {
        to.add(fresh);
        fresh.clear();
    };
    from.for_each([&](const journal_record& each) {
        const auto there = to.find(each.key);
        if (there && !there->failed && !each.failed && there->content != each.content) {
            throw input_error("DIR", from.path().string(),
                              "has for " + each.inputs + " rows that differ from those of a previous journal",
                              "run 'libration journal DIR --check 100%' to find the wrong one");
        }
        if (!there || (there->failed && !each.failed)) {
            fresh.push_back(each);
        }
        if (fresh.size() == together) {
            keep();
        }
    });
    keep();
}

// The common command of these journals.
std::string common_command(const std::vector<fs::path>& paths) {
    std::set<std::string> commands;
    for (const fs::path& path : paths) {
        for (const std::string& each : journal(path, journal::access::read).commands()) {
            commands.insert(each);
        }
    }
    if (commands.size() != 1) {
        throw input_error("DIR", paths.front().parent_path().string(),
                          commands.empty()
                              ? "has no command in its journal"
                              : fmt::format("and the others have several commands ({})", fmt::join(commands, "; ")),
                          "merge the shards of one command");
    }
    return *commands.begin();
}

failures_found merge_study(const std::vector<fs::path>& paths, const std::string& out, int jobs) {
    const std::string command = common_command(paths);
    const study_order order = order_from(command, jobs);
    const study_cells of(order);
    output_folder into("--out", (fs::path(out) / order.what->name).string());
    journal all = open_study_journal(of, command, out, earlier_cells::taken);
    for (const fs::path& path : paths) {
        if (!fs::equivalent(path, all.path())) {
            const journal shard(path, journal::access::read);
            require_own_stamp(shard, of.stamp(), "DIR");
            add_all(shard, all);
        }
    }
    into.keep();
    journal_store store(all);
    const cells_found found = missing_cells(of, store, {});
    const std::size_t failed = failures_among(found, of, store).count;
    if (found.to_compute > failed) {
        throw std::runtime_error(
            fmt::format("{} of {} cells of {} are missing from the journals; to compute them, run: "
                        "{} --out {}",
                        found.to_compute - failed, found.cells, order.what->name, command, out));
    }
    auto failures = make_tables(order, of, store, out);
    say_line(fmt::format("wrote {}", into.path()));
    return failures;
}

}  // namespace

failures_found merge_journals(const std::vector<std::string>& folders, const std::string& out, int jobs) {
    std::map<std::string, std::vector<fs::path>> by_study;
    for (const std::string& folder : folders) {
        for (const fs::path& path : journals_in(folder)) {
            by_study[path.stem().string()].push_back(path);
        }
    }
    failures_found failures;
    try {
        for (const auto& [study, paths] : by_study) {
            const failures_found own = merge_study(paths, out, jobs);
            failures.count += own.count;
            failures.first.insert(failures.first.end(), own.first.begin(), own.first.end());
        }
    } catch (const journal_error& problem) {
        refuse_journal(problem, "DIR");
    }
    return failures;
}

}  // namespace libration
