// Certificates of values of a solution: texts from which a program in integers proves them (docs/certificates.md).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::ode {

/// An interval that contains a value: its ends as decimals and as fractions.
struct decimal_interval {
    std::string lower, upper;
    rational low, high;
};

/// The numbers within one unit of the last digit of a decimal; of "0" those within 10^-digits.
decimal_interval within_one_unit(const std::string& decimal, long digits);

/// The times after the initial point at which a condition, in the unknowns, their lower derivatives and the variable, is
/// 0: all of them up to the last, in the order in which they are reached, each the only one in its interval.
struct certified_zeros {
    expression condition;
    std::vector<decimal_interval> times;
};

/// The value of an unknown or a lower derivative, by its index in names_of_state(), at a time, at all times from it to
/// `until`, or at a zero of the condition, by its index. The index plus the number of these names is that of the
/// derivative by the varied start.
struct claimed_value {
    rational time;
    std::size_t place = 0;
    decimal_interval in;
    std::optional<std::size_t> zero = {};
    std::optional<rational> until = {};
};

/// All numbers between two fractions, instead of the initial value of the unknown or lower derivative with this index.
struct start_interval {
    std::size_t place = 0;
    rational low, high;
};

/// What a certificate proves: values at times, or at all zeros of a condition up to the last that is listed; of every
/// solution that begins in the intervals, if there are any; also of the derivatives of the solution by the start with the
/// index `varied`.
struct certified_statement {
    std::vector<claimed_value> values;
    std::optional<certified_zeros> zeros = {};
    std::vector<start_interval> starts = {};
    std::optional<std::size_t> varied = {};
};

/// The text of a certificate: the equations as typed, the definitions of the unknowns added by the polynomial form, and
/// for each step of theorem K (tube.hpp) exact polynomials, frames and radii, with as few bits as prove the values. The
/// precision is increased from run to run until they do. `digits` is the number of digits of the first run;
/// `watch` is a progress callback with the time reached and the bits, an exception that it throws ends the work.
///
/// Throws error of the subject "certificate": of the kind argument if the format does not contain the problem (numbers
/// that are not fractions, functions except exp, log, sin, cos and powers, singular initial points, times on both sides
/// of the initial point, a condition that holds at an initial point that is not given by fractions); of the kind
/// undecided if no step is proved at some time, or the statement is not proved within the limits.
std::string certificate_of(const explicit_system& system, const certified_statement& statement, long digits,
                           const std::function<void(const ball& reached, long bits)>& watch = {});

}  // namespace libration::ode
