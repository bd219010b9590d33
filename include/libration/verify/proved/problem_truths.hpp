// What the unknowns of any system of differential equations are compared with.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/proved/condition_numbers.hpp"
#include "libration/verify/proved/row_question.hpp"

namespace libration::ode {

/// A derivative of an unknown, by their numbers.
struct solution_component {
    std::size_t unknown;
    std::size_t derivative;
};

/// The unknowns and their lower derivatives, in order.
std::vector<solution_component> components_of(const explicit_system& system);

/// The truths of a problem at any times. A truth is proved (proved_march); before a singular start, and where theorem S
/// does not hold for that, it is that of two marches of other orders and precisions, within 16 times what they differ
/// by. The condition number is the largest
///     (|t dy/dt| + sum_x |x dy/dx|) / max(1, |y|)
/// of the components y that are compared, x the starts and the parameters that are not 0 (dependence); at a singular
/// start |t dy/dt| / max(1, |y|) of the first one alone.
/// A row whose time needs more work than a limit is undecided (row_work), and so are rows beyond it; a condition number
/// that needs more is empty. Times that grow share the marches. Not for several threads at once.
class problem_truths {
public:
    /// A problem solved for its highest derivatives and as it is written, and the components that are compared, one at
    /// least. What these do not depend on is left out.
    problem_truths(const explicit_system& system, equation_system equations,
                   const std::vector<solution_component>& asked);

    /// The components at a time. The question holds as long as this, and asks it.
    row_question at(const exact& time);

private:
    struct march_pair;
    struct proved_way;
    struct dependent_way;
    using components = std::vector<solution_component>;

    bool proves(const exact& time);
    std::vector<ball> proved_state(const exact& time, long digits);
    march_pair& marches(long digits);
    std::vector<true_value> truths_at(const exact& time, long digits);
    std::string condition_at(const exact& time, long digits);
    std::string condition_of_slope(const exact& time, const solution_component& of, long digits);
    std::optional<std::vector<moved_value>> moved_at(const exact& at);

    explicit_system system_;  // of the components that are compared and what they depend on
    equation_system equations_;
    components asked_;                 // by the unknowns of system_
    std::vector<std::size_t> places_;  // in its state
    std::map<long, std::shared_ptr<march_pair>> by_digits_;
    std::map<long, std::shared_ptr<proved_way>> proved_by_digits_;
    std::shared_ptr<dependent_way> dependent_;
    std::optional<bool> provable_;  // from a singular start
};

}  // namespace libration::ode
