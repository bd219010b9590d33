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

/// The problem and the range of coefficients.
struct problem_series_request {
    ode::explicit_system system;
    long first = 0;
    long order = 0;
    /// A time, 1/2 or 1+2i; the initial point if it is not given.
    std::optional<std::string> at;
    /// The corners of the path to it in the complex plane, 1+i,2+i; straight without them.
    std::optional<std::string> via = {};
};

/// n,<unknown>...; with balls followed by <unknown>_uncertainty..., about a complex point, or by a path in the complex
/// plane, <unknown>_re,<unknown>_im..., and for an initial point with powers of t^(1/q), n of which are counted, power.
/// Throws input_error for a point to which there is no path, and for balls by a path in the complex plane. With
/// `check`, in balls, each is compared with a second proof (ode::proof_route::second): throws std::runtime_error with
/// both enclosures if they disagree.
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

/// a_0 .. a_order of every unknown, to this number of digits. Throws as problem_coefficients does.
problem_lists lists_of_problem(const problem_series_request& request, long digits);

/// The coefficients as a table of exact fractions. Throws input_error for a problem whose coefficients are not
/// fractions.
table problem_fractions(const problem_series_request& request);

}  // namespace libration
