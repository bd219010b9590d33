// The journal of a study in its directory: DIR/NAME/NAME.journal.
#pragma once

#include <filesystem>
#include <string>

#include "journal.hpp"
#include "sweep/cell_engine.hpp"

namespace libration {

/// How cells that a journal already contains are treated.
enum class earlier_cells {
    taken,             ///< used; those of other versions are an error
    replaced,          ///< all are recomputed: --fresh
    taken_or_replaced  ///< used; those of other versions are recomputed
};

/// DIR/NAME/NAME.journal.
std::filesystem::path journal_path(const std::string& folder, const std::string& study);

/// The journal of these cells, open for writing, with the command that requests them. Throws input_error of --out: for
/// a file that another run writes, that is damaged, that cannot be written or that contains cells of another version.
journal open_study_journal(const study_cells& of, const std::string& command, const std::string& folder,
                           earlier_cells earlier);

/// Throws input_error of the option if the cells were made by a version other than this.
void require_own_stamp(const journal& cells, const journal_stamp& own, const std::string& option);

/// The same for errors that a journal reports while it is used, such as a full disk.
[[noreturn]] void refuse_journal(const journal_error& problem, const std::string& option);

}  // namespace libration
