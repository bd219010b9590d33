// A problem with many values of its parameters and initial values, for integration in lock step.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "libration/equation/parametric_system.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

/// The parameters and initial values of these names are components of the state besides the unknowns (parametric_system),
/// so that one system has all values of them.
class varied_problem {
public:
    /// Names are those of parameters, or of initial values such as x'(0). Throws error as opened() does, and if the
    /// initial point is singular.
    varied_problem(const equation_system& given, const std::vector<std::string>& names);

    const explicit_system& system() const { return open_.system; }
    /// Whether each component of the state is one of the names.
    const std::vector<bool>& parameters() const { return parameters_; }
    std::size_t names() const { return open_.leaves.size(); }

    /// Appends the state at the initial point for these values of the names, in order; rounded as its formulas are in
    /// double.
    void append_state(std::span<const double> values, std::vector<double>& to) const;
    /// The same with another state of the unknowns, in the order of names_of_state without the names.
    void append_state(std::span<const double> values, std::span<const double> unknowns, std::vector<double>& to) const;
    /// The state at the initial point in the working precision.
    std::vector<mpfr> state_of(std::span<const mpfr> values) const;

private:
    parametric_system open_;
    std::vector<bool> parameters_;
};

}  // namespace libration::ode
