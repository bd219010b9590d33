// A problem: its equations, and the axes along which studies vary it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/ode/equation_system.hpp"
#include "libration/problem/axis.hpp"

namespace libration {

/// A problem: equations with their initial values and parameters, or a family of them by axes.
struct problem {
    /// Neither equations nor axes.
    problem() = default;
    /// The equations of a text (ode/parse.hpp), or of the problem of this name in the catalogue if it contains no =.
    /// Throws error of the subject "problem".
    explicit problem(const std::string& text);
    /// Existing equations.
    explicit problem(ode::equation_system system) : equations(std::move(system)) {}
    /// A family that is varied along its axes, which are in the order in which commands are written.
    problem(std::string given_name, std::vector<axis> given_axes)
        : name(std::move(given_name)), axes(std::move(given_axes)) {}

    /// Changes a parameter or an initial value: "k = 1/3", "x'(0) = 0". Throws error for a name that the problem does
    /// not have.
    problem& set(const std::string& change);

    std::string name;
    std::vector<axis> axes;
    ode::equation_system equations;
};

/// Values of a coordinate for which a study is not defined, and the reason, as in "has the energy 2, where the period
/// is infinite".
struct without_answer {
    std::string coordinate;
    std::function<bool(const exact&)> at;
    std::string reason;
};

/// The reason why a study is not defined at this value of a coordinate; empty if it is defined.
std::string reason_against(const std::vector<without_answer>& excluded, const std::string& coordinate,
                           const exact& value);

}  // namespace libration
