// A request for Taylor coefficients of a solution, and the lists in which tests of convergence examine them.
#pragma once

#include <string>
#include <vector>

#include "libration/convergence/radius_answers.hpp"
#include "libration/equation/expression.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration {

/// The largest power of a coefficient: that of sums over the singularities of the pendulum.
inline constexpr long largest_power_of_series = 1'000'000'000'000'000;

/// The usual order of a radius from coefficients.
inline constexpr long usual_order_of_radius = 100;

/// A range of Taylor coefficients about a point.
struct series_request {
    long first = 0;
    long order = 0;
    /// The point: a time, 1/2, also complex, 1+2i; of a motion of the pendulum top, bottom, start or a time, 1/2, T/8.
    /// The initial point if it is empty.
    std::string about = {};
    /// The corners of the path to it through the complex plane; a straight line if there are none.
    std::vector<ode::complex_constant> corners = {};
};

/// A point of the complex plane in a text. Throws error of the subject "point".
ode::complex_constant point_in(const std::string& text);

/// Points of the complex plane, each reached by the corners and then straight.
struct complex_path_request {
    std::vector<ode::complex_constant> times;
    std::vector<ode::complex_constant> corners = {};
};

/// The coefficients of an unknown; about a complex point its real and its imaginary parts.
struct unknown_series {
    std::string name;
    convergence::listed_function lists;

    /// The list, or that of the real parts.
    const series::power_series<mpfr>& coefficients() const { return lists.parts.front().coefficients; }
};

}  // namespace libration
