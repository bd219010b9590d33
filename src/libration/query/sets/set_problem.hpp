// A problem with sets as a system with a box of initial values and free parameters.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/integration/lohner_set.hpp"
#include "number_box.hpp"

namespace libration::ode {

/// The sets of a problem are the numbers p of a box. Those on which the equations depend are unknowns of system(), which
/// are constant; its initial values are functions S(p). Unknowns of the problem that keep their initial values, and do
/// not occur in the condition, are not in it.
class set_problem {
public:
    /// Throws error like enclosed_solutions.
    explicit set_problem(const equation_system& given) : set_problem(given, std::nullopt) {}
    /// With a condition on the solutions, such as x = a, which may contain sets. Throws like parse_condition too.
    set_problem(const equation_system& given, const std::optional<std::string>& condition);

    const explicit_system& system() const { return system_; }
    /// The names of the sets: b, x(0).
    const std::vector<std::string>& sets() const { return sets_; }
    /// The indices in the state of system() of the unknowns of the problem and their lower derivatives.
    const std::vector<std::size_t>& own() const { return own_; }
    /// The names of all unknowns of the problem and their lower derivatives, and their values with those of own().
    const std::vector<std::string>& names() const { return names_; }
    std::vector<closed_interval> all_values(const std::vector<closed_interval>& of_own) const;
    /// The difference of the sides of the condition, in the unknowns of system().
    const expression& condition() const { return condition_; }

    /// Whether a set is more than one number.
    bool is_wide(std::size_t set) const { return (upper_[set] - lower_[set]).sign() > 0; }
    /// The whole box, each end rounded outwards to the working precision.
    number_box box() const;
    /// All initial states of a box: S(p) is in S(c) + DS (p - c), c its centre, DS over the whole box, which is convex.
    /// Its first columns are those of the numbers with a width.
    state_set states_of(const number_box& box) const;
    /// DS over a box, a row for each unknown of system().
    ball_matrix derivative_of_start(const number_box& box) const;

private:
    std::vector<ball> starts_at(const std::vector<ball>& numbers) const;
    void read_starts(const equation_system& given);
    void leave_out_constants(const equation_system& given);
    std::vector<std::string> names_of_own() const;

    std::vector<std::string> sets_;
    std::vector<number> lower_, upper_;
    expression condition_;
    std::vector<std::string> free_;  ///< the sets that are unknowns
    explicit_system system_;
    std::vector<expression> leaves_;  ///< which represent p
    std::vector<expression> starts_;  ///< S, in leaves
    std::vector<std::vector<expression>> derivatives_;
    std::vector<std::size_t> own_;
    std::vector<std::string> names_;
    std::vector<std::variant<std::size_t, number>> values_;  ///< of each name: an index in own_, or the constant value
};

}  // namespace libration::ode
