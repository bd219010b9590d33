// A problem: differential equations with their initial values and parameters.
#pragma once

#include <string>
#include <utility>

#include "libration/equation/equation_system.hpp"

namespace libration {

class problem {
public:
    /// The equations of a text (equation/text/parse.hpp), or of the problem of this name in the catalogue if it contains no =.
    /// Throws error of the subject "problem".
    explicit problem(const std::string& text);
    /// Existing equations.
    explicit problem(ode::equation_system system) : equations_(std::move(system)) {}

    /// Changes a parameter or an initial value: "k = 1/3", "x'(0) = 0". Throws error for a name that the problem does
    /// not have.
    problem& set(const std::string& change);

    const ode::equation_system& equations() const { return equations_; }

private:
    ode::equation_system equations_;
};

}  // namespace libration
