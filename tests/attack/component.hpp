// Equations of first order with one unknown whose solutions have closed forms.
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

/// u' = slope(u, s), u = start at s = 0, s the time since the start.
struct component {
    std::function<std::string(const std::string& u, const std::string& s)> slope;
    constant start;
    function value;  ///< u(s)
    /// The solution is analytic for -backward < s < forward, about.
    double backward = std::numeric_limits<double>::infinity();
    double forward = std::numeric_limits<double>::infinity();
    /// Its coefficient n about the start, where that is known.
    std::function<mpfr(long)> coefficient = {};
    /// All singularities with |s| below a bound of at most 50, where they are known; none: entire.
    std::function<std::vector<place>(double within)> singularities = {};
    /// When u passes a value after the start, once: u is monotone there. Nothing where it does not.
    std::function<std::optional<truth>(const constant& level)> passes = {};
};

/// One of all of them, its constants near one in half of the cases.
component any_component(choices& next);
/// One whose coefficients are known.
component with_coefficients(choices& next);
/// One whose singularities are known, and of which it has some.
component with_singularities(choices& next);

/// Those that other kinds ask for by name.
component growth(const constant& rate, const constant& start);   ///< u' = a u
component pole(const constant& rate, const constant& start);     ///< u' = a u^2
component tangent(const constant& rate, const constant& start);  ///< u' = a (1 + u^2)

}  // namespace libration::attack
