// The verdict on a statement: compared with a number that is computed in MPFR alone.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::attack {

/// A number in the thread's working precision (precision_scope), computed anew by each call.
using truth = std::function<mpfr()>;

/// A fraction in the working precision.
mpfr real(const rational& q);
/// The fraction represented by a decimal.
rational typed_fraction(const std::string& decimal);
mpfr pi_value();
/// About 15 digits of it.
double rough(const truth& exact);

enum class verdict {
    right,
    refused,   ///< nothing was stated, or only facts that are true
    wrong,     ///< a false statement
    undecided  ///< the truth is not known well enough to judge it
};
inline constexpr std::size_t verdicts = 4;

/// The verdicts on the statements of one question.
struct outcome {
    std::string command;  ///< to be pasted into a shell
    std::array<long, verdicts> counts{};
    std::vector<std::pair<verdict, std::string>> statements;

    void add(verdict v, const std::string& statement);
    long count(verdict v) const { return counts[static_cast<std::size_t>(v)]; }
};

/// Whether the printed decimal is within one unit of its last digit and within its uncertainty of the true value, which
/// is computed in increasing precision until two precisions agree.
verdict judged(const proved_decimal& printed, long digits, const truth& exact);

/// Whether lower <= x <= upper, where the bounds are decimals.
verdict judged_bounds(const std::string& lower, const std::string& upper, const truth& exact);

/// Whether |x - from| is at most the sum of these bounds, all decimals.
verdict judged_distance(const std::string& from, const std::vector<std::string>& bounds, const truth& exact);

/// Whether the true value is in a ball.
verdict judged_ball(const ball& enclosure, const truth& exact);

/// -1, 0 or 1: the sign of the true value, 0 if it is 0 in every precision up to `most` digits.
int sign_of(const truth& exact, long most = 3000);

}  // namespace libration::attack
