// `libration table` in words, and the file that they make: what the command writes, and what reproduce publishes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "option/option_words.hpp"
#include "problem/problem_options.hpp"
#include "table/motion_table.hpp"
#include "text/table.hpp"

namespace libration {

/// What a table is of: motions, elliptic functions, or the solution of a problem.
class table_subject {
public:
    table_subject() = default;
    table_subject(const table_subject&) = delete;
    table_subject& operator=(const table_subject&) = delete;
    virtual ~table_subject() = default;

    /// The arguments of the command that name it: " pendulum".
    virtual std::string words() const = 0;
    /// The first line of a file with comments.
    virtual std::string title() const = 0;
    /// The text of the problem; empty if it is not one.
    virtual std::string text() const { return {}; }
    virtual std::string rigour() const { return "proved to one unit in the last place"; }
    /// Throws input_error.
    virtual table rows(const option_words& said, long digits, input_style style, int jobs) const = 0;
};

/// pendulum, or functions as in am,sn. Throws input_error for another name.
std::shared_ptr<const table_subject> table_subject_named(const std::string& what);

/// The problem of --problem, otherwise what is named. Throws input_error if neither is given.
std::shared_ptr<const table_subject> table_subject_of(const std::string& what, const problem_options& problem);

/// The request: the subject, and the arguments of its options.
struct table_order {
    std::shared_ptr<const table_subject> subject;
    option_words said;
    long digits = 50;

    /// The command that makes it, without --out and --jobs.
    std::string command() const;
};

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
