// A system y' = f(t, y) whose right-hand side is a C++ function template over the number type.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// unknowns[i]' = right(t, y)[i], unknowns[i](point) = starts[i]. `right` accepts T and std::vector<T> and returns an
/// object with size() and elements, for T = expression as well as for the T of any integrator: it is called once, and
/// its operations become those of the tape. It cannot contain branches that depend on values, such as an if. Throws
/// error if the numbers of unknowns, initial values and right-hand sides differ.
template <class F>
equation_system system_of(const F& right, const std::vector<std::string>& unknowns,
                          const std::vector<expression>& starts, const expression& point = 0) {
    std::vector<expression> y;
    y.reserve(unknowns.size());
    for (const std::string& name : unknowns) {
        y.push_back(unknown(name));
    }
    const auto slopes = right(variable(), std::as_const(y));
    if (slopes.size() != y.size() || starts.size() != y.size()) {
        throw error(error_kind::argument, "system", "",
                    "has " + std::to_string(y.size()) + " unknowns, " + std::to_string(starts.size()) +
                        " initial values and " + std::to_string(slopes.size()) + " right-hand sides");
    }
    equation_system system;
    for (std::size_t i = 0; i < y.size(); ++i) {
        system.add(derivative(y[i]), slopes[i]);
        system.begin(y[i], starts[i], point);
    }
    return system;
}

}  // namespace libration::ode
