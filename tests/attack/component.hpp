// First-order equations with one unknown whose solutions have closed forms.
#pragma once

#include <complex>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "attack/constants.hpp"

namespace libration::attack {

/// A function of a number, in the working precision.
using function = std::function<mpfr(const mpfr&)>;

/// re + i im.
struct place {
    truth re, im;
};

/// u' = slope(u, s), u = start at s = 0, s the time since the initial time.
struct component {
    std::function<std::string(const std::string& u, const std::string& s)> slope;
    constant start;
    function value;  ///< u(s)
    /// The solution is analytic for -backward < s < forward, approximately.
    double backward = std::numeric_limits<double>::infinity();
    double forward = std::numeric_limits<double>::infinity();
    /// Its coefficient n about the initial point, if that is known.
    std::function<mpfr(long)> coefficient = {};
    /// All singularities with |s| below a bound of at most 50, if they are known; none: entire.
    std::function<std::vector<place>(double within)> singularities = {};
    /// The time after the initial time at which the monotone u passes a value; std::nullopt if it does not.
    std::function<std::optional<truth>(const constant& level)> passes = {};
};

/// Any component, with constants near one in half of the cases.
component any_component(choices& next);
/// A component with known coefficients.
component with_coefficients(choices& next);
/// A component with known singularities, at least one.
component with_singularities(choices& next);

/// Components that other kinds construct by name.
component growth(const constant& rate, const constant& start);   ///< u' = a u
component pole(const constant& rate, const constant& start);     ///< u' = a u^2
component tangent(const constant& rate, const constant& start);  ///< u' = a (1 + u^2)

}  // namespace libration::attack
