// A complex argument as typed: "1+2i".
#pragma once

#include <optional>
#include <string>

#include "libration/elliptic/named_function.hpp"

namespace libration {

/// A number with an imaginary part, or a real one.
struct complex_argument {
    exact real;
    std::optional<exact> imaginary;
};

/// Whether a text ends in a complex number's i, which is not that of pi: "1+2i", "i", "0.5-3/2i", "1+pi*i".
bool is_complex_text(const std::string& text);

/// Reads "1+2i", "-i", or a real number as read_exact does. Throws as that does.
complex_argument read_complex(const std::string& item);

/// "1+2i" of two typed numbers, an expression in parentheses.
std::string complex_argument_text(const std::string& real, const std::string& imaginary);

/// Whether a function takes complex arguments: the twelve of Jacobi.
bool takes_complex(const elliptic::named_function& function);

}  // namespace libration
