// Merging the journals of shards.
#pragma once

#include <string>
#include <vector>

#include "sweep/cell_engine.hpp"

namespace libration {

/// The journals in DIR: DIR/NAME/NAME.journal for every NAME, or DIR/NAME.journal if DIR is the directory NAME itself.
/// Throws input_error if there is none.
std::vector<std::filesystem::path> journals_in(const std::string& folder);

/// Writes the cells of the journals in these directories into DIR/NAME/NAME.journal, one for each study, and the tables
/// and figures of the command of which they are shards, as the whole run would. Throws input_error for cells of another
/// version or of several commands and for cells that differ; std::runtime_error if cells are missing: the merged
/// journal is then kept.
failures_found merge_journals(const std::vector<std::string>& folders, const std::string& out, int jobs);

}  // namespace libration
