// The solution over a step to a few digits, by Rosenbrock's method of order 2: the initial guess of Newton's method,
// and a check for stiffness. No proof depends on it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "polynomial_map.hpp"

namespace libration::ode {

/// y' = f(t, y) in long double.
struct stiff_equations {
    using result = polynomial_map::result<long double>;

    /// The rows and columns of the entries of f_y that are not identically 0.
    std::vector<std::pair<std::size_t, std::size_t>> places;
    /// f and, if requested, these entries.
    std::function<result(long double time, const std::vector<long double>& state, bool with_entries)> values;
};

/// ode23s [ShampineReichelt1997] in long double. Errors are relative to each unknown, or to its floor if that is
/// larger.
class stiff_guide {
public:
    explicit stiff_guide(stiff_equations of) : of_(std::move(of)) {}
    /// The map must outlive this object.
    stiff_guide(const polynomial_map& map, std::vector<long double> constants);

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

    /// True if explicit steps of this length are much too short: the solution from a state is smooth over 32 of them.
    /// Of the first `resolved` unknowns, those that are not 0 must not decay by more than 10^-6, which steps of
    /// collocation resolve.
    bool is_smooth_over_steps(long double time, const std::vector<long double>& start, long double step,
                              std::size_t resolved) const;

private:
    struct run;
    stiff_equations of_;
};

}  // namespace libration::ode
