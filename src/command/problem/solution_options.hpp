// The options of a command about one solution: of --problem, or of the pendulum, which is the usual problem.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "answer_table.hpp"
#include "motion_options.hpp"
#include "option/options.hpp"
#include "problem_options.hpp"

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
    /// The solution: of equations by Taylor series; of a motion in closed form, in an arithmetic that can represent its
    /// energy. Throws input_error.
    chosen_solution choose(const arithmetic_options& numbers) const;
    /// The motion of the pendulum alone; std::nullopt with --problem. Throws input_error.
    std::optional<chosen_motion> motion(const arithmetic_options& numbers) const;

private:
    motion_options motion_;
    problem_options problem_;
};

}  // namespace libration
