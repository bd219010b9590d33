#include "sweep/study_journal.hpp"

#include <fmt/format.h>

#include "text/input_error.hpp"

namespace libration {

namespace fs = std::filesystem;

namespace {

bool is_of_another(const fs::path& path, const journal_stamp& own) {
    const journal cells(path, journal::access::read);
    const auto found = cells.stamp();
    return found && *found != own;
}

}  // namespace

void require_own_stamp(const journal& cells, const journal_stamp& own, const std::string& option) {
    const auto found = cells.stamp();
    if (found && *found != own) {
        throw input_error(
            option, cells.path().string(),
            found->study != own.study
                ? "contains cells of the study " + found->study
                : fmt::format(
                      "contains cells of libration {}, version {} of the study, and this is libration {}, version {}",
                      found->library, found->version, own.library, own.version),
            "add --fresh to recompute all cells, or name another --out");
    }
}

fs::path journal_path(const std::string& folder, const std::string& study) {
    return fs::path(folder) / study / (study + ".journal");
}

journal open_study_journal(const study_cells& of, const std::string& command, const std::string& folder,
                           earlier_cells earlier) {
    const fs::path path = journal_path(folder, of.of().name);
    try {
        if (earlier == earlier_cells::replaced ||
            (earlier == earlier_cells::taken_or_replaced && fs::exists(path) && is_of_another(path, of.stamp()))) {
            drop_journal(path);
        }
        journal cells(path, journal::access::write);
        require_own_stamp(cells, of.stamp(), "--out");
        if (!cells.stamp()) {
            cells.set_stamp(of.stamp());
        }
        cells.add_command(command);
        return cells;
    } catch (const journal_error& problem) {
        refuse_journal(problem, "--out");
    }
}

void refuse_journal(const journal_error& problem, const std::string& option) {
    switch (problem.kind()) {
        case journal_error::fault::in_use:
            throw input_error(option, problem.path(), problem.reason(),
                              "wait until it ends, or name another directory");
        case journal_error::fault::damaged:
            throw input_error(option, problem.path(), problem.reason(),
                              "add --fresh to 'libration study' to recompute its cells");
        case journal_error::fault::unbegun:
            throw input_error(
                option, problem.path(), problem.reason(),
                "try again when its study has run for a second; if it was killed, rerun the same command to resume");
        case journal_error::fault::unwritable: break;
    }
    throw input_error(option, problem.path(), problem.reason(), "choose a writable directory with free disk space");
}

}  // namespace libration
