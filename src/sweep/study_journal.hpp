// The journal of a study in its folder: DIR/NAME/NAME.journal.
#pragma once

#include <filesystem>
#include <string>

#include "journal/journal.hpp"
#include "sweep/cell_engine.hpp"

namespace libration {

/// What is done with the cells that a journal holds already.
enum class earlier_cells {
    taken,             ///< those of other versions are refused
    replaced,          ///< all are computed anew: --fresh
    taken_or_replaced  ///< those of other versions are computed anew
};

/// DIR/NAME/NAME.journal.
std::filesystem::path journal_path(const std::string& folder, const std::string& study);

/// The journal of these cells, open for writing, with the command that asks for them. Throws input_error of --out:
/// for a
/// file that another run writes, that is damaged, that cannot be written or that holds cells of another version.
journal open_study_journal(const study_cells& of, const std::string& command, const std::string& folder,
                           earlier_cells earlier);

/// Throws input_error of the option where the cells were made by another version than this.
void require_own_stamp(const journal& cells, const journal_stamp& own, const std::string& option);

/// The same of what a journal says of itself while it is used: that the disk is full.
[[noreturn]] void refuse_journal(const journal_error& problem, const std::string& option);

}  // namespace libration
