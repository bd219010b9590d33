// A problem: its equations, and the axes along which studies vary it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libration/ode/equation_system.hpp"
#include "libration/problem/axis.hpp"

namespace libration {

/// A problem: equations with their starts and parameters, or a family of them by axes.
struct problem {
    /// Neither equations nor axes.
    problem() = default;
    /// The equations of a text (ode/parse.hpp), or without = in it those of this name in the catalogue. Throws error of
    /// the subject "problem".
    explicit problem(const std::string& text);
    /// Equations that are already there.
    explicit problem(ode::equation_system system) : equations(std::move(system)) {}
    /// A family that is varied along its axes, which stand in the order in which commands are written.
    problem(std::string given_name, std::vector<axis> given_axes)
        : name(std::move(given_name)), axes(std::move(given_axes)) {}

    /// Changes a parameter or a start: "k = 1/3", "x'(0) = 0". Throws error for what the problem does not have.
    problem& set(const std::string& change);

    std::string name;
    std::vector<axis> axes;
    ode::equation_system equations;
};

/// Where a study has no answer: values of a coordinate, and why, as in "has the energy 2, where the period is
/// infinite".
struct without_answer {
    std::string coordinate;
    std::function<bool(const exact&)> at;
    std::string reason;
};

/// The reason why there is no answer at this value of a coordinate; empty where there is one.
std::string reason_against(const std::vector<without_answer>& excluded, const std::string& coordinate,
                           const exact& value);

}  // namespace libration
