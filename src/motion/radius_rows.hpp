// The answers of `libration radius` as a table and in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/convergence/radius_report.hpp"
#include "libration/scalar/exact.hpp"
#include "text/table.hpp"

namespace libration {

/// The coefficients to judge, and what is known of their radius otherwise.
struct judged_list {
    series::power_series<mpfr> coefficients;
    std::vector<exact> written;     ///< as in the file; empty for a motion
    std::string exact_text;         ///< the true radius as printed, empty where it is not known
    std::optional<mpfr> true_size;  ///< the same with more digits, nothing also where it is infinite
};

/// What all tests said, the verdict first, in the unit of the list.
struct radius_answers {
    convergence::coefficient_pattern pattern;
    std::string floor;  ///< of noise, in words; empty where there is none
    std::vector<convergence::radius_estimate<mpfr>> rows;
};

/// The radius is computed with so many digits more than it is printed.
inline constexpr long radius_guard_digits = 20;

/// A row an answer, each with the digits that its uncertainty supports, and no more than asked.
table radius_table(const radius_answers& answers, const judged_list& list, long digits);

/// The verdict in words, and below it that table without the columns for programs.
std::string radius_text(const radius_answers& answers, const judged_list& list, const table& data);

/// The same of several unknowns: the verdict of the nearest of them first, then all rows of each, and the column
/// `unknown` behind.
table radius_table_of_unknowns(const std::vector<radius_answers>& all, const std::vector<std::string>& names,
                               std::size_t nearest, const judged_list& list, long digits);

/// The verdict of the nearest in words, and that table below it.
std::string radius_text_of_unknowns(const radius_answers& nearest, const std::string& name, const judged_list& list,
                                    const table& data);

}  // namespace libration
