#include "motion/solution_options.hpp"

#include <utility>

#include "libration/problem/known/pendulum_solution.hpp"
#include "text/input_error.hpp"

namespace libration {

void solution_options::add_to(CLI::App& command) {
    motion_.add_to(command);
    problem_.add_to(command);
}

chosen_solution solution_options::choose(const arithmetic_options& numbers) const {
    const auto motion = motion_.first_given();
    if (motion && problem_.is_chosen()) {
        throw input_error(*motion + " applies to motions of the pendulum, not to a --problem: leave one of them out");
    }
    if (problem_.is_chosen()) {
        problem_.state_first_branch();
        return {problem_.general_solution(), "", std::to_string(usual_order_of_radius)};
    }
    chosen_motion chosen = motion_.choose_for(numbers.choose().scalar);
    const std::string point = usual_point_of(chosen);
    return {solution_of(std::move(chosen.of)),
            point,
            std::nullopt,
            {{"theta", {"coefficient", ""}}, {"theta_uncertainty", {"uncertainty", ""}}}};
}

void solution_options::require_problem(const std::string& message) const {
    if (!problem_.is_chosen()) {
        throw input_error(message);
    }
}

}  // namespace libration
