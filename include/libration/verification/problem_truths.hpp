// The true values with which the unknowns of any system of differential equations are compared.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/number/exact.hpp"
#include "libration/query/condition_numbers.hpp"
#include "libration/verification/row_question.hpp"

namespace libration::ode {

/// A derivative of an unknown, by their indices.
struct solution_component {
    std::size_t unknown;
    std::size_t derivative;
};

/// The unknowns and their lower derivatives, in order.
std::vector<solution_component> components_of(const explicit_system& system);

/// The true values of a problem at any times. A value is proved (proved_march); before a singular initial point, and if
/// theorem S does not apply to it, it is that of two integrations of different orders and precisions, within 16 times
/// their difference. The condition number is the largest
///     (|t dy/dt| + sum_x |x dy/dx|) / max(1, |y|)
/// of the components y that are compared, x the nonzero initial values and parameters (dependence); at a singular
/// initial point |t dy/dt| / max(1, |y|) of the first one alone.
/// A row whose time needs more work than a limit is undecided (row_work), and so are rows beyond it; a condition number
/// that needs more is empty. Increasing times share the integrations. Not for several threads at once.
class problem_truths {
public:
    /// A problem solved for its highest derivatives and as it is written, and the components that are compared, at
    /// least one. Equations on which these do not depend are omitted.
    problem_truths(const explicit_system& system, equation_system equations,
                   const std::vector<solution_component>& asked);

    /// The components at a time. The question uses this object and is valid for its lifetime.
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
    std::string condition_of_slope(const exact& time, long digits);
    std::vector<mpfr> slopes_at(const exact& time, long digits);
    std::vector<mpfr> slopes_of(const exact& time, const solution_state<mpfr>& state) const;
    solution_state<mpfr> midpoints_of(const std::vector<ball>& values) const;
    std::optional<std::vector<moved_value>> moved_at(const exact& time);

    explicit_system system_;  // of the components that are compared and those on which they depend
    equation_system equations_;
    components asked_;                 // by the unknowns of system_
    std::vector<std::size_t> places_;  // indices in its state
    std::map<long, std::shared_ptr<march_pair>> by_digits_;
    std::map<long, std::shared_ptr<proved_way>> proved_by_digits_;
    std::shared_ptr<dependent_way> dependent_;
    std::optional<bool> provable_;  // from a singular initial point
};

}  // namespace libration::ode
