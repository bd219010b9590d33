#include "sweep/study_run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "option/options.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

// The command that resumes this run; empty for a part of a larger work.
std::string command_again(const study_order& order, const std::string& folder, const study_run& how) {
    if (how.part_of_more) {
        return "";
    }
    std::string words = order.command + " --out " + folder;
    if (how.shard) {
        words += fmt::format(" --shard {}/{}", how.shard->index + 1, how.shard->count);
    }
    return words;
}

void say_what_is_there(const cells_found& found, const journal& cells) {
    if (found.to_compute < found.cells) {
        say_line(fmt::format("{} of {} cells are in {}", found.cells - found.to_compute, found.cells,
                             cells.path().string()));
    }
}

// Computes the cells that the journal does not contain. If a signal ends the process, all finished cells are kept.
void complete_journal(const study_cells& of, journal& cells, journal_store& store, const study_shard& shard,
                      const std::string& again) {
    const cells_found found = missing_cells(of, store, shard);
    if (!again.empty()) {
        say_what_is_there(found, cells);
    }
    const at_ending_signal keep([&] {
        try {
            store.flush();
            cells.settle();
            if (!again.empty()) {
                say_line(fmt::format("interrupted: {} cells saved in {}; to resume, run: {}", cells.counts().done,
                                     cells.path().string(), again));
            }
        } catch (const std::exception& problem) {
            say_line(problem.what());
        }
    });
    compute_missing(of, store, found);
    cells.settle();
}

// Throws if no cell of a shard has a result.
failures_found failures_of_shard(const study_cells& of, const journal_store& store, const study_shard& shard) {
    const cells_found left = missing_cells(of, store, shard);
    if (left.cells > 0 && left.to_compute == left.cells) {
        of.rethrow_first_failure();
    }
    return failures_among(left, of, store);
}

failures_found run_with(const study_order& order, const study_cells& of, journal& cells, journal_store& store,
                        const std::string& folder, const study_run& how) {
    const study_shard shard = how.shard.value_or(study_shard{});
    try {
        complete_journal(of, cells, store, shard, command_again(order, folder, how));
    } catch (const journal_error& problem) {
        if (problem.kind() != journal_error::fault::unwritable) {
            throw;
        }
        throw std::runtime_error(
            std::string(problem.what()) +
            ": finished cells are saved; free some disk space and rerun the same command to resume");
    }
    if (!how.shard) {
        return make_tables(order, of, store, folder);
    }
    auto failures = failures_of_shard(of, store, shard);
    say_line(fmt::format("wrote {}, shard {} of {}: 'libration journal merge' makes the tables of all shards",
                         cells.path().string(), shard.index + 1, shard.count));
    return failures;
}

// A journal created for a run without any result is removed.
failures_found run_into(const study_order& order, const study_cells& of, const std::string& folder,
                        const study_run& how) {
    const fs::path path = journal_path(folder, order.what->name);
    const bool was_there = fs::exists(path);
    std::optional<journal> cells(open_study_journal(of, order.command, folder, how.earlier));
    std::optional<journal_store> store(std::in_place, *cells);
    try {
        return run_with(order, of, *cells, *store, folder, how);
    } catch (...) {
        store.reset();
        const bool useless = !was_there && cells->counts().done == 0;
        cells.reset();
        if (useless) {
            drop_journal(path);
        }
        throw;
    }
}

}  // namespace

failures_found make_study(const study_order& order, const std::string& folder, const study_run& how) {
    if (folder.empty()) {
        throw input_error("--out", folder, "is not a directory", "name one");
    }
    const study_cells of(order);
    require_columns(of.plan().tables, order.columns);
    if (cell_server()) {
        cell_server()(of);
        return {};
    }
    output_folder into("--out", (fs::path(folder) / order.what->name).string());
    try {
        auto failures = run_into(order, of, folder, how);
        into.keep();
        return failures;
    } catch (const journal_error& problem) {
        refuse_journal(problem, "--out");
    }
}

}  // namespace libration
