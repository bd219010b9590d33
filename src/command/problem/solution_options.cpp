#include "solution_options.hpp"

#include <utility>

#include "libration/problem/known/pendulum_solution.hpp"

namespace libration {

void solution_options::add_to(CLI::App& command) {
    motion_.add_to(command);
    problem_.add_to(command);
}

chosen_solution solution_options::choose(const arithmetic_options& numbers) const {
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

std::optional<chosen_motion> solution_options::motion(const arithmetic_options& numbers) const {
    return problem_.is_chosen() ? std::nullopt : std::optional(motion_.choose_for(numbers.choose().scalar));
}

}  // namespace libration
