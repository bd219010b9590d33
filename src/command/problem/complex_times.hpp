// Complex times, and the paths to them around singularities, in the notation of the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/equation/expression.hpp"

namespace libration {

/// A point of the complex plane and how it was typed; a point of a range as it would be typed alone.
struct typed_point {
    ode::complex_constant value;
    std::string text;
};

/// Whether the imaginary unit i occurs in a number, list or range.
bool has_imaginary_unit(const std::string& words);

/// Reads LIST, items separated by commas: complex constants, 1+2i, or ranges a:b:count along the straight line from a
/// to b. Throws input_error of the option.
std::vector<typed_point> complex_points(const std::string& option, const std::string& words);

/// The corners of --via; empty if it is not given.
std::vector<ode::complex_constant> corners_of(const std::optional<std::string>& via);

}  // namespace libration
