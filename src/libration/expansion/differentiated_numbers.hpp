// The numbers with respect to which the solution of a problem is differentiated.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// Parameters and initial values by their names, r and x'(0). Throws error of the subject "derivatives" for a name that
/// is given twice, for an initial value that the problem does not have, and as require_independent().
struct differentiated_numbers {
    /// The index of a parameter in `parameters`, or of an initial value in the state.
    struct column {
        bool of_start;
        std::size_t index;
    };

    /// `state` has the names of the unknowns and their lower derivatives, with initial values at `point`.
    differentiated_numbers(const equation_system& given, const std::vector<std::string>& state, const number& point,
                           const std::vector<std::string>& numbers);

    std::vector<column> columns;  ///< of each number, in order
    std::vector<std::string> parameters;
};

/// Throws error of the subject "derivatives" if one of these parameters is defined by another one, directly or not. The
/// derivative by a parameter holds all other numbers fixed, while parameters that are defined by it follow it: one of
/// these cannot be held fixed and follow at once.
void require_independent(const equation_system& given, const std::vector<std::string>& parameters);

/// Throws error of the subject "derivatives".
[[noreturn]] void refuse_derivative(const std::string& name, const std::string& reason);

/// The result of a function of the problem with open parameters, whose errors about one of these are thrown as errors of
/// the subject "derivatives".
template <class Make>
auto with_derivative_errors(const Make& make) {
    try {
        return make();
    } catch (const error& problem) {
        if (problem.kind() != error_kind::argument) {
            throw;
        }
        refuse_derivative(problem.value(), problem.reason());
    }
}

}  // namespace libration::ode
