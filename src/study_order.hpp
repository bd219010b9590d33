// From the words of the command line to a study's parameters.
#pragma once

#include <optional>
#include <string>

#include "study_files.hpp"

namespace libration {

/// What a user may say to a study; nothing means the study's default.
struct study_words {
    std::optional<std::string> energies;
    std::optional<std::string> gaps;
    std::optional<std::string> orders;
    std::optional<std::string> scalar;
    std::optional<std::string> jobs;
};

/// The parsed order. With --energies or --gaps given, the defaults of both are put aside. Throws input_error.
study_order order_of(const study& what, const study_words& words);

/// The number of threads: --jobs, or all cores.
int jobs_of(const std::optional<std::string>& words);

}  // namespace libration
