// The files of a study: CSV, the JSON beside it, and the figures drawn from the CSV.
#pragma once

#include <string>
#include <vector>

#include "sweep/study.hpp"

namespace libration {

/// A study with the words of its canonical command, without --out and --jobs.
struct study_order {
    const study* what;
    study_request request;
    std::string command;
};

/// Runs the study and writes DIR/NAME/NAME[_SUFFIX].csv and DIR/NAME/NAME.json. Throws input_error when DIR cannot be
/// written.
void write_study(const study_order& order, const std::string& folder);

/// Draws DIR/NAME/*.svg and *.png from the CSV with studies/NAME.gp. Throws input_error when the CSV or gnuplot is missing.
void draw_study(const study& what, const std::string& folder);

/// The study of that name; throws input_error that lists the names there are.
const study& study_named(const std::string& option, const std::string& name);

}  // namespace libration
