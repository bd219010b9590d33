// One mistake that explains the errors of all rows of a table: degrees for radians, exchanged columns, times that are
// off by a constant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/verification/row_question.hpp"

namespace libration {

/// Sums over rows from which a mistake is recognised. It is if, without it, the root mean square of the errors would be
/// less than a hundredth of what it is: with v the values, y the true values and y' their derivatives by time,
///     degrees    sum (v pi/180 - y)^2          of each column by itself,
///     exchanged  sum (v_i - y_j)^2 + (v_j - y_i)^2      of each pair of columns,
///     offset d   sum (v - y - d y')^2, d = sum (v - y) y' / sum y'^2,      of all columns,
/// and at least 3 rows and nine of ten miss their tolerance. A hint, which changes no verdict. O(c^2) per row of c
/// columns.
class mistake_hint {
public:
    /// The names of the compared columns.
    explicit mistake_hint(std::vector<std::string> names);

    /// Another row; `within` is whether all its values are within their tolerances.
    void add(const row_numbers& row, bool within);
    /// The mistake in words; empty if none is recognised.
    std::string found() const;

private:
    std::string degrees() const;
    std::string exchanged() const;
    std::string offset() const;

    std::vector<std::string> names_;
    long rows_ = 0;
    long misses_ = 0;
    std::vector<std::vector<mpfr>> apart_;  // sum (v_i - y_j)^2
    std::vector<mpfr> in_degrees_;          // sum (v_i pi/180 - y_i)^2
    long sloped_rows_ = 0;                  // of those with slopes:
    mpfr errors_, slopes_, products_;       // sum (v - y)^2, sum y'^2, sum (v - y) y'
};

}  // namespace libration
