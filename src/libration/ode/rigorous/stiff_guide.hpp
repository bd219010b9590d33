// The solution over a step to a few digits, by Rosenbrock's method of order 2: the initial guess of Newton's method,
// and a check for stiffness. No proof depends on it.
#pragma once

#include <optional>
#include <vector>

#include "polynomial_map.hpp"

namespace libration::ode {

/// ode23s [ShampineReichelt1997] in long double. Errors are relative to each unknown, or to its floor if that is
/// larger.
class stiff_guide {
public:
    stiff_guide(const polynomial_map& map, std::vector<long double> constants)
        : map_(map), constants_(std::move(constants)) {}

    struct request {
        std::vector<long double> start;
        long double time = 0;
        long double length = 0;  ///< of either sign
        std::vector<long double> floors;
        long double tolerance = 3e-6L;
        int most_steps = 20'000;
    };
    /// The states at parts 0 <= a_0 < a_1 < .. <= 1 of the length; std::nullopt if more steps are needed.
    std::optional<std::vector<std::vector<long double>>> states(const request& asked,
                                                                const std::vector<long double>& parts) const;

private:
    struct run;
    const polynomial_map& map_;
    std::vector<long double> constants_;
};

}  // namespace libration::ode
