// The rows of `verify` in their format: the cells of the input, and what was added.
#pragma once

#include <string>
#include <vector>

#include "text/csv_records.hpp"

namespace libration {

/// CSV, with the rows of a comma-separated input unchanged, or a JSON array of objects, whose values are
/// strings, null where a cell is empty.
class row_writer {
public:
    /// An output column that the input has too is called verify_NAME.
    row_writer(bool json, separator between, std::vector<std::string> input, const std::vector<std::string>& added);

    separator between() const { return between_; }
    /// What comes before the rows, between two of them, and behind them.
    std::string head() const;
    std::string joint() const { return json_ ? ",\n" : "\n"; }
    std::string tail() const { return json_ ? "\n]\n" : "\n"; }
    /// A record without a text is given by its cells.
    std::string row(const csv_record& record, const std::vector<std::string>& cells,
                    const std::vector<std::string>& added) const;

private:
    bool json_;
    separator between_;
    std::vector<std::string> names_;
};

}  // namespace libration
