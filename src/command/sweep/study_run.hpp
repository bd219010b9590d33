// Running a study into a directory: the cells missing from its journal are computed, and the tables are made of all
// cells.
#pragma once

#include <optional>
#include <string>

#include "sweep/cell_engine.hpp"
#include "sweep/study_journal.hpp"

namespace libration {

/// How a study is run into a directory.
struct study_run {
    earlier_cells earlier = earlier_cells::taken;
    /// Only its cells are computed, into the journal, and no tables are made; std::nullopt: all cells.
    std::optional<study_shard> shard = std::nullopt;
    /// It is a part of a larger work, which reports itself what is saved and how to resume.
    bool part_of_more = false;
};

/// Runs the study and writes to DIR/NAME the files of this run: NAME[_SUFFIX].csv, the same as .tex, the figures, and
/// NAME.json, which lists every file with its SHA-256; and NAME.journal, which keeps every finished cell, so that only
/// the cells missing from it are computed. The files are written to a temporary directory and moved when they are
/// complete; tables and figures of an earlier run are removed. Cells that failed are left out of the tables, named in
/// the JSON and returned; if all failed, the exception of the first of them is rethrown. Throws input_error if DIR
/// cannot be written: then DIR/NAME is unchanged. Throws what draw_figures throws: then the tables are there without
/// figures.
failures_found make_study(const study_order& order, const std::string& folder, const study_run& how = {});

}  // namespace libration
