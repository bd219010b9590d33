// `libration table` in words, and the file that they make: what the command writes, and what reproduce publishes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "option/option_words.hpp"
#include "table/problem_table.hpp"
#include "text/table.hpp"

namespace libration {

/// The request: pendulum or a list of elliptic functions, and the arguments of their options.
struct table_order {
    std::string what;
    option_words said;
    long digits = 50;
    std::optional<table_problem> problem = {};  ///< instead of `what`, if given

    /// The command that makes it, without --out and --jobs.
    std::string command() const;
};

/// Throws input_error for options that belong to the other kind of table.
void require_own_options(const table_order& order);

/// The table in the style that a format needs: typed numbers in csv, json, text and latex, decimals in those for
/// programs.
table table_for(const table_order& order, const std::string& format, int jobs);

/// Whether a format holds its provenance in comments.
bool has_comments(const std::string& format);

/// The file: `command` and the versions of provenance() are in its comment if the format has one.
std::string table_file(const table_order& order, const table& data, const std::string& format, const std::string& name,
                       const std::string& command);

/// The same provenance with columns and their meanings as JSON, for a file next to one without comments.
std::string provenance_json(const table_order& order, const table& data, const std::string& command);

}  // namespace libration
