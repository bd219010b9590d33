// Converts the arguments of the command line to a study's parameters.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sweep/study.hpp"

namespace libration {

/// The axes that studies of any problem may have: order, digits, step.
const std::vector<axis>& study_axes();

/// An option that studies may have.
struct study_option {
    std::string option;     ///< --orders
    std::string type_name;  ///< LIST
    std::string help;
};

/// The options of these studies: the axes of their problems, study_axes() and --scalar.
std::vector<study_option> options_of(const std::vector<const study*>& studies);

/// What may be written for a parameter of this study: "LIST or a:b:count, integers".
std::string forms_of(const study& what, const std::string& option);

/// A study with its parameters and the words of its canonical command, without --out and --jobs.
struct study_order {
    const study* what;
    study_request request;
    std::string command;
    /// The values of ranges that were left out because the study has no result there, with the reasons: "2 of
    /// --energies, where the period is infinite"; empty if all were kept.
    std::string left_out;
    /// The columns of the tables for LaTeX, and of the output on stdout: a,b,c; std::nullopt: all. A table with only
    /// some of them has these.
    std::optional<std::string> columns = {};
    /// `what`, if it was made for an equation and is owned by the order.
    std::shared_ptr<const study> made = {};
};

/// Those of the columns a,b,c that a table has; the whole table if it has none of them.
table with_columns_of(const table& data, const std::optional<std::string>& names);

/// The parsed order. Values of an axis override the defaults of all axes of its coordinate. A value of a range without
/// a result is left out; one that was typed as a single item throws error "has the energy 2, where ...". Throws
/// input_error, also for an option that the study does not have.
study_order order_of(const study& what, const study_words& words, int jobs);

/// The columns of a table that are not redundant: a column NAME_typed that repeats NAME in all rows is left out.
class own_columns {
public:
    explicit own_columns(const std::vector<column>& columns);
    void see(const table_row_cells& row);
    /// Of the columns that are kept.
    std::vector<std::size_t> places() const;

private:
    struct typed_column {
        std::size_t place;
        std::optional<std::size_t> plain;  // the column of this name without _typed
        bool repeats = true;
    };
    std::size_t columns_;
    std::vector<typed_column> typed_;
};

/// The tables with these columns alone, and without those that are not to be written.
void without_repetitions(std::vector<study_table>& tables);

/// The number of threads: the argument of --jobs, or all cores. Throws input_error.
int jobs_of(const std::optional<std::string>& words);

}  // namespace libration
