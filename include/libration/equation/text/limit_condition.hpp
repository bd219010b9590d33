// Conditions at infinity in the text of a problem: f'(inf) = 1, u(-inf) = 0.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libration/equation/equation_system.hpp"

namespace libration::ode {

/// The limit of an unknown or of a lower derivative as t -> inf, or as t -> -inf.
struct limit_condition {
    expression of;
    expression value;  ///< a constant, with parameters
    int direction = 1;
    bool exponentially = false;  ///< f'(inf) = 1 exponentially: faster than every power of t
    bool fast = false;           ///< u(inf) = 0 fast: along the fastest directions alone
    /// u(inf) = 0 with amplitude A: u = u(inf) + A exp(-r |t|) + smaller terms, with the rate r of the slowest direction.
    std::optional<expression> amplitude = {};
    std::string text = {};  ///< as written
};

/// A text without its conditions at infinity, with blanks in their place, and these conditions.
struct separated_text {
    std::string problem;
    std::vector<std::string> limits;
};
/// Throws error like parse() for characters that form no token.
separated_text with_limits_separated(const std::string& problem);

/// Whether a condition contains a value at inf or -inf.
bool has_limit(std::string_view condition);

/// The limit of one value, a*f'(inf) + b = c with a number a, possibly followed by `exponentially` or `fast`, and by `with
/// amplitude A`. Throws error like add_condition().
limit_condition parse_limit(const equation_system& of, const std::string& condition);

}  // namespace libration::ode
