// From the words of the command line to a study's parameters.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sweep/study.hpp"

namespace libration {

/// What a user says to a study: words by option. What is missing is the study's usual value.
using study_words = std::map<std::string, std::string>;

/// An option that studies may have.
struct study_option {
    std::string option;     ///< --orders
    std::string type_name;  ///< LIST
    std::string help;
    std::string remedy;  ///< what to write instead of what was wrong
};

/// All of them, in the order in which commands are written.
const std::vector<study_option>& study_order_options();

/// A study with its parameters and the words of its canonical command, without --out and --jobs.
struct study_order {
    const study* what;
    study_request request;
    std::string command;
};

/// The parsed order. With --energies or --gaps given, the usual values of both are put aside. Throws input_error, also
/// for an option that the study does not have.
study_order order_of(const study& what, const study_words& words, int jobs);

/// The number of threads: the words of --jobs, or all cores. Throws input_error.
int jobs_of(const std::optional<std::string>& words);

}  // namespace libration
