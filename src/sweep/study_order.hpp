// From the words of the command line to a study's parameters.
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

/// A study with its parameters and the words of its canonical command, without --out and --jobs.
struct study_order {
    const study* what;
    study_request request;
    std::string command;
    /// The values of ranges that were left out because the study has no answer there, with the reasons: "2 of
    /// --energies, where the period is infinite"; empty where all were kept.
    std::string left_out;
    /// The columns of the tables for LaTeX, and of what goes to stdout: a,b,c; all where there is nothing. A table
    /// without some of them has the others.
    std::optional<std::string> columns = {};
    /// `what`, where it was made for an equation and lives with the order.
    std::shared_ptr<const study> made = {};
};

/// Those of the columns a,b,c that a table has; the whole table where it has none of them.
table with_columns_of(const table& data, const std::optional<std::string>& names);

/// The parsed order. Values of an axis put the usual ones of all axes of its coordinate aside. A value of a range
/// without an answer is left out; one that was typed by itself is refused: error "has the energy 2, where
/// ...". Throws input_error, also for an option that the study does not have.
study_order order_of(const study& what, const study_words& words, int jobs);

/// Which columns of a table say something of their own: a column NAME_typed that says nothing but what NAME says, in
/// all rows, is left out.
class own_columns {
public:
    explicit own_columns(const std::vector<column>& columns);
    void see(const table_row_cells& row);
    /// Of the columns that are kept.
    std::vector<std::size_t> places() const;

private:
    struct typed_column {
        std::size_t place;
        std::optional<std::size_t> plain;  // the column that is called as this one is without _typed
        bool repeats = true;
    };
    std::size_t columns_;
    std::vector<typed_column> typed_;
};

/// The tables with these columns alone, and without those that are not to be written.
void without_repetitions(std::vector<study_table>& tables);

/// The number of threads: the words of --jobs, or all cores. Throws input_error.
int jobs_of(const std::optional<std::string>& words);

}  // namespace libration
