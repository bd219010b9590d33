// The Taylor coefficients of any differential equation as a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/series/power_series.hpp"
#include "option/options.hpp"
#include "text/table.hpp"

namespace libration {

/// Which coefficients of which problem.
struct problem_series_request {
    ode::explicit_system system;
    long first = 0;
    long order = 0;
    /// A time, 1/2 or 1+2i; the start where it is not given.
    std::optional<std::string> at;
    /// The corners of the way there through the complex plane, 1+i,2+i; straight without them.
    std::optional<std::string> via = {};
};

/// n,<unknown>...; with balls <unknown>_uncertainty... behind, about a complex point, or by a way through the plane,
/// <unknown>_re,<unknown>_im..., and for a start in powers of t^(1/q), n of which are counted, power. Throws
/// input_error for a point where there is no way to, and for balls by a way through the plane.
/// With `check`, in balls, each is compared with a second proof (ode::proof_route::second): throws std::runtime_error
/// with both enclosures where they disagree.
table problem_coefficients(const problem_series_request& request, const arithmetic& numbers, bool check = false);

/// The coefficients of an unknown; about a complex point its real and its imaginary parts.
struct problem_list {
    std::string name;
    std::vector<series::power_series<mpfr>> parts;
};

/// Those of all unknowns, in powers of the root-th root of the distance from the point.
struct problem_lists {
    std::vector<problem_list> unknowns;
    int root;
};

/// a_0 .. a_order of every unknown, to so many digits. Throws as problem_coefficients does.
problem_lists lists_of_problem(const problem_series_request& request, long digits);

/// The coefficients as a table of exact fractions. Throws input_error for a problem that has others.
table problem_fractions(const problem_series_request& request);

}  // namespace libration
