// The audit of a list of coefficients, and the prediction of further ones, as tables.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/convergence/verdict.hpp"
#include "text/table.hpp"

namespace libration {

/// The list of a file that holds one real list, its decimals exact for `rounded` 0, rounded to so many digits, or as
/// convergence::rounding_of finds; up to `order` if given. Throws input_error.
convergence::series_list real_list_in(const std::string& file, const std::optional<long>& rounded,
                                      const std::optional<std::size_t>& order = std::nullopt);

/// n,predicted,uncertainty,deviation,confirmed: the coefficient that the others contradict; no row if there is none.
table table_of_suspect(const convergence::list_verdict& verdict, long digits);
/// The same in words.
std::string text_of_suspect(const convergence::list_verdict& verdict, const table& data);

/// n,value,uncertainty.
table table_of_predictions(const std::vector<convergence::predicted_coefficient>& found, long digits);

}  // namespace libration
