// Studies of any equation: the question stands, the equation comes with --problem, and --set makes axes of its
// parameters.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sweep/study_order.hpp"

namespace libration {

/// The words of an order of a study, without those of its own parameters.
struct equation_words {
    std::string problem;
    std::vector<std::string> sets;
};

/// A study of any equation; studies/equation/NAME.cpp defines one and NAME.gp beside it draws it. It may have the name
/// of a study of the pendulum, of which it asks the same.
struct equation_study {
    std::string name;
    std::string title;
    std::string question;
    std::string reading;                      ///< as of a study
    std::vector<study_parameter> parameters;  ///< besides --problem, --set and --unknowns
    equation_words example;                   ///< what the set `problems` asks,
    study_words example_words;                ///< with these parameters
    study_words quick;                        ///< the same, of a second at most
    double seconds;                           ///< of the example, on two cores
    std::function<study_plan(const shared_problem&, const study_request&)> plan;
    int version = 1;
    bool alone = false;
    arithmetics offers = arithmetics::rounding;  ///< as of a study
};

/// All of them, by name (generated at build time from the files in studies/equation).
std::vector<const equation_study*> all_equation_studies();

/// NAME-P: the study about this equation.
std::shared_ptr<const study> study_about(const equation_study& what, const shared_problem& equation);

/// The order of a study by its name: of any equation where `asked` has one, else as order_of. Throws input_error for
/// --problem of a study that is the pendulum's alone, and for a study of equations without one.
study_order order_asked(const std::string& option, const std::string& name, const std::optional<equation_words>& asked,
                        const study_words& words, int jobs);

/// The order that a command of a study stands for, as study_order::command holds it. Throws std::runtime_error for
/// another text.
study_order order_from(const std::string& command, int jobs);

/// The example of a study of any equation as an order.
study_order example_of(const equation_study& what, int jobs);

/// All of them; they live as long as the program.
const std::vector<study_order>& example_orders();

/// The study of DIR/NAME: one of all_studies(), or that of the command which NAME.json holds. Throws input_error.
std::shared_ptr<const study> study_in(const std::string& option, const std::string& name, const std::string& folder);

}  // namespace libration
