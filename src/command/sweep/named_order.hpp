// Orders of studies by their names, for their own problems and for any equation: the question is the same, --problem
// gives the equation, and --set makes axes of its parameters.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sweep/study_order.hpp"

namespace libration {

/// NAME-P: the study about this equation. Requires what.any_equation.
std::shared_ptr<const study> study_about(const study& what, const shared_problem& equation);

/// The order of a study by its name: for any equation if `asked` has one, else as order_of. Throws input_error for
/// --problem with a study that supports only its own problem, and for a study without its own problem and without
/// --problem.
study_order order_asked(const std::string& option, const std::string& name, const std::optional<equation_words>& asked,
                        const study_words& words, int jobs);

/// The order described by the command of a study, in the form of study_order::command. Throws std::runtime_error for
/// any other text.
study_order order_from(const std::string& command, int jobs);

/// The studies of any equation.
std::vector<const study*> studies_of_equations();

/// The example of one of them as an order.
study_order example_of(const study& what, int jobs);

/// All of them; valid until the program ends.
const std::vector<study_order>& example_orders();

/// The study of DIR/NAME: one of all_studies(), or that of the command in NAME.json. Throws input_error.
std::shared_ptr<const study> study_in(const std::string& option, const std::string& name, const std::string& folder);

}  // namespace libration
