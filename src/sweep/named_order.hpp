// Orders of studies by their names, of their own problems and of any equation: the question stands, the equation comes
// with --problem, and --set makes axes of its parameters.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sweep/study_order.hpp"

namespace libration {

/// NAME-P: the study about this equation. Requires what.any_equation.
std::shared_ptr<const study> study_about(const study& what, const shared_problem& equation);

/// The order of a study by its name: of any equation where `asked` has one, else as order_of. Throws input_error for
/// --problem of a study that is of its own problem alone, and for a study without a problem of its own and no --problem.
study_order order_asked(const std::string& option, const std::string& name, const std::optional<equation_words>& asked,
                        const study_words& words, int jobs);

/// The order that a command of a study stands for, as study_order::command holds it. Throws std::runtime_error for
/// another text.
study_order order_from(const std::string& command, int jobs);

/// The studies of any equation.
std::vector<const study*> studies_of_equations();

/// The example of one of them as an order.
study_order example_of(const study& what, int jobs);

/// All of them; they live as long as the program.
const std::vector<study_order>& example_orders();

/// The study of DIR/NAME: one of all_studies(), or that of the command which NAME.json holds. Throws input_error.
std::shared_ptr<const study> study_in(const std::string& option, const std::string& name, const std::string& folder);

}  // namespace libration
