// Values of elliptic functions as text, and how well conditioned they are.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "libration/elliptic/named_function.hpp"

namespace libration {

/// A modulus k, parameter m, complementary parameter m1, modular angle or nome q as typed.
struct typed_parameter {
    exact typed;
    elliptic::real_parameter (*from)(const exact&);

    elliptic::real_parameter value() const { return from(typed); }
};

/// The arguments of a function, as typed.
struct elliptic_point {
    std::optional<exact> argument;  ///< std::nullopt if the function has none
    typed_parameter parameter;
    std::optional<exact> characteristic = std::nullopt;
    std::optional<exact> imaginary = std::nullopt;  ///< of a complex argument

    elliptic::function_arguments exactly() const { return {argument, parameter.value(), characteristic}; }
};

/// The value in the working precision and as many digits more as the argument has before its point.
/// Throws as the function does.
true_value value_at(const elliptic::named_function& function, const elliptic_point& at);

/// `digits` proved digits; inf or -inf where the function is infinite, 0 where it is 0. Throws error where the function
/// is not real, where the digits are not decided, and where no exponent holds the value.
std::string function_text(const elliptic::named_function& function, const elliptic_point& at, long digits);

/// The same of a complex argument; nothing at a pole.
std::optional<elliptic::complex_parts> complex_value_at(const elliptic::named_function& function,
                                                        const elliptic_point& at);

/// function_text() of a complex argument: the real and the imaginary part, each with so many proved digits.
std::array<std::string, 2> complex_texts(const elliptic::named_function& function, const elliptic_point& at,
                                         long digits);

/// Three digits of the condition number, computed with twice the digits until they stay: heuristic. inf where it is
/// infinite, or the function is.
std::string condition_text(const elliptic::named_function& function, const elliptic_point& at);

/// The same of a complex argument, whose real and imaginary part are two of the numbers that move.
std::string complex_condition_text(const elliptic::named_function& function, const elliptic_point& at);

/// Either of the two, as the argument is.
std::array<std::string, 2> texts_of(const elliptic::named_function& function, const elliptic_point& at, long digits);
std::string condition_of(const elliptic::named_function& function, const elliptic_point& at);

}  // namespace libration
