// The files of a study: CSV and LaTeX tables, the figures drawn from the CSV, and the JSON that names them all.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sweep/cell_engine.hpp"
#include "sweep/study.hpp"
#include "sweep/study_figures.hpp"
#include "sweep/study_journal.hpp"
#include "sweep/study_order.hpp"

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
/// and figures of an earlier run go. Cells that failed are left out of the tables, named in the JSON and returned; where
/// all failed, what the first of them threw is thrown. Throws input_error when DIR cannot be written: then DIR/NAME is
/// as it was. Throws what draw_figures throws: then the tables are there without figures.
failures_found make_study(const study_order& order, const std::string& folder, const study_run& how = {});

/// The tables of the cells that a journal holds for the order, as make_study leaves them in DIR/NAME. `cells` is the
/// journal of that folder. Throws std::runtime_error where cells are missing.
failures_found make_tables(const study_order& order, const study_cells& of, cell_store& store,
                           const std::string& folder);

/// Draws the figures in DIR/NAME again, from the tables that NAME.json names. Throws input_error when one of them is
/// missing or is not the one that NAME.json describes, or when gnuplot is missing.
void draw_study(const study& what, const std::string& folder);

/// Writes one file of a results folder, whole or not at all. Throws input_error of --out.
void write_into(const std::string& path, const std::string& content);

/// The study of that name; throws input_error that lists the names there are.
const study& study_named(std::string_view option, std::string_view name);

}  // namespace libration
