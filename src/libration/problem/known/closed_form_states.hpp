// The answer of a closed form to a list of times, whatever its problem.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/problem/answer.hpp"

namespace libration {

/// The values at a time, and the reason if one of them is undecided.
struct closed_form_row {
    std::vector<answer_value> values;
    std::optional<error> missing = {};
};

/// The row of each time, in order, with the rigour `proved`. If `at` throws an error of the kind undecided the row is
/// empty; if the progress callback throws one, so are all rows that follow; the answer has the last of these reasons.
/// Throws error for an integrator, which `problem`, the name of the closed form, does not use.
answer closed_form_states(const std::string& problem, const std::vector<std::string>& quantities,
                          const std::vector<exact>& times, const request& how,
                          const std::function<closed_form_row(const exact& time)>& at);

}  // namespace libration
