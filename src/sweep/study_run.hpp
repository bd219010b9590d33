// A study run into a folder: what its journal does not hold is computed, and the tables are made of all of it.
#pragma once

#include <optional>
#include <string>

#include "sweep/cell_engine.hpp"
#include "sweep/study_journal.hpp"

namespace libration {

/// How a study is run into a folder.
struct study_run {
    earlier_cells earlier = earlier_cells::taken;
    /// Its cells alone are computed, into the journal, and no tables are made; std::nullopt: all of them.
    std::optional<study_shard> shard = std::nullopt;
    /// It is a part of a larger work, which says itself what is kept and what goes on.
    bool part_of_more = false;
};

/// Runs the study and leaves in DIR/NAME the files of this run: NAME[_SUFFIX].csv, the same as .tex, the figures, and
/// NAME.json, which names every file with its SHA-256; and NAME.journal, which keeps every finished cell, so that only
/// those are computed that it does not hold. The files are made beside and moved there when they are whole; tables
/// and figures of an earlier run go. Cells that failed are left out of the tables, named in the JSON and returned;
/// where
/// all failed, what the first of them threw is thrown. Throws input_error when DIR cannot be written: then DIR/NAME is
/// as it was. Throws what draw_figures throws: then the tables are there without figures.
failures_found make_study(const study_order& order, const std::string& folder, const study_run& how = {});

}  // namespace libration
