// The results of `libration radius` as a table and in words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/convergence/radius_answers.hpp"
#include "text/table.hpp"

namespace libration {

/// The radius as known independently of the coefficients.
struct known_radius {
    std::string text;               ///< as printed; empty if it is not known
    std::optional<mpfr> true_size;  ///< the same with more digits; std::nullopt also if it is infinite
};

/// One row per estimate, each with the digits that its uncertainty supports, at most the requested number.
table radius_table(const convergence::radius_answers& answers, const known_radius& known, long digits);

/// The verdict in words, followed by that table without the columns for programs.
std::string radius_text(const convergence::radius_answers& answers, const known_radius& known, const table& data);

/// The same for several unknowns: the verdict of the nearest of them first, then all rows of each, with `unknown` as
/// last column.
table radius_table_of_unknowns(const std::vector<convergence::radius_answers>& all,
                               const std::vector<std::string>& names, std::size_t nearest, const known_radius& known,
                               long digits);

/// The verdict of the nearest in words, with the name of its unknown and of those that agree with it, followed by that
/// table.
std::string radius_text_of_unknowns(const std::vector<convergence::radius_answers>& all,
                                    const std::vector<std::string>& names, std::size_t nearest,
                                    const known_radius& known, const table& data);

}  // namespace libration
