// The summary that `libration verify` prints for a file: counts, the worst row, a mistake that all rows have in common,
// and the correct digits of all rows: those of the value that has the fewest.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/verification/mistake_hint.hpp"
#include "verify/verify_rows.hpp"

namespace libration {

/// Takes the rows in their order and names the first that miss, are malformed or undecided on stderr as they come.
class verify_summary {
public:
    /// `columns` are the names of the compared columns, as the file has them.
    verify_summary(std::string file, const std::vector<std::string>& columns)
        : file_(std::move(file)), mistake_(columns) {}

    /// These columns hold doubles, which determines their tolerance.
    void name_doubles(std::vector<std::string> columns) { of_doubles_ = std::move(columns); }

    /// The times and arguments in these columns are taken for doubles.
    void name_inputs(std::vector<std::string> columns) { inputs_ = std::move(columns); }

    void add(const compared_row& row);
    /// To stderr.
    void print() const;

    long rows() const { return rows_; }
    /// 2 where a row was malformed, 1 where one missed or stayed undecided, else 0.
    int exit_code() const { return malformed_ > 0 ? 2 : misses_ + undecided_ > 0 ? 1 : 0; }

private:
    void name(const compared_row& row, long count, long& named) const;

    std::string file_;
    long rows_ = 0;
    long misses_ = 0;
    long malformed_ = 0;
    long undecided_ = 0;
    long unproved_ = 0;
    long misses_named_ = 0;
    long malformed_named_ = 0;
    long undecided_named_ = 0;
    std::optional<compared_row> worst_;
    std::vector<std::string> of_doubles_, inputs_;
    mistake_hint mistake_;
    std::map<long, long> digits_;  ///< how many rows have so many correct digits in all values
};

}  // namespace libration
