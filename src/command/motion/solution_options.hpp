// The options of a command about one solution: of --problem, or of the pendulum, which is the usual problem.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "equation/answer_table.hpp"
#include "equation/problem_options.hpp"
#include "motion/motion_options.hpp"
#include "option/options.hpp"

namespace libration {

/// A solution, and what its options determine in the output.
struct chosen_solution {
    std::unique_ptr<solution> of;
    std::string usual_point;                 ///< the expansion point without --at
    std::optional<std::string> usual_order;  ///< the last power of a radius without --order
    column_labels labels = {};
};

/// --problem P --set X=VALUE, or --energy, --gap, --theta0, --omega0, --direction, --length, --gravity.
class solution_options {
public:
    void add_to(CLI::App& command);
    /// Whether any of them is given. Throws input_error for --set alone.
    bool given() const { return problem_.is_chosen() || motion_.first_given(); }
    /// The first option of a motion that is given, as "--energy '1.71'".
    std::optional<std::string> motion_given() const { return motion_.first_given(); }
    /// The solution: of equations by Taylor series; of a motion in closed form, in an arithmetic that can represent its
    /// energy. Throws input_error, also for options of both kinds.
    chosen_solution choose(const arithmetic_options& numbers) const;
    /// Throws input_error with this message if there is no --problem.
    void require_problem(const std::string& message) const;

private:
    motion_options motion_;
    problem_options problem_;
};

}  // namespace libration
