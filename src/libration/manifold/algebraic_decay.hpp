// How fast a solution approaches a limit, where it does so like a power of the time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/scalar/ball/value.hpp"

namespace libration::ode {

/// From states at times t, 2 t, 4 t, ... from the initial point.
class algebraic_decay {
public:
    void add(const std::vector<ball>& state);
    /// q > 0 where the last three changes of the state decrease like t^-q: from each to the next by factors whose
    /// logarithms to base 2 agree to 1 %. If that continues, the state has a limit, which it approaches like t^-q;
    /// exponential decay doubles the logarithm with the time.
    std::optional<double> exponent() const;
    /// For the end of a message that no equilibrium is approached; empty where there is no such exponent.
    std::string text() const;

private:
    std::vector<ball> last_;
    std::vector<ball> changes_;  ///< sums of the absolute values over the unknowns
};

}  // namespace libration::ode
