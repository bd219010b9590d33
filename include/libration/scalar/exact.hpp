// Exact numbers: what a person typed, kept as typed until it meets a precision.
#pragma once

#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

/// What an exact number counts.
enum class unit { one, pi, degree, period };

/// coefficient * unit, exactly: 1.71, 171/100, 1e-30, 3pi/4, 150deg, -3T/4.
struct exact {
    rational coefficient = 0;
    unit measure = unit::one;
    std::string text = "0";  ///< as typed

    /// The coefficient of pi of an angle; pi = 180 degrees. Meaningful for pi and degree only.
    rational in_pi() const { return measure == unit::degree ? rational(coefficient / 180) : coefficient; }
    bool is_zero() const { return coefficient == 0; }
};

/// Reads numbers of the form [sign] digits[.digits][e[sign]digits] [pi|deg|T] [/ digits[.digits][e...]].
/// The digits may be missing before pi and T. Throws error of the kind argument saying what is wrong with the text.
class exact_reader {
public:
    explicit exact_reader(std::string_view text) : text_(text), rest_(text) {}

    exact read() {
        if (rest_.empty()) {
            refuse("is empty");
        }
        exact result;
        result.text = std::string(text_);
        const bool negative = sign();
        const bool bare_unit = rest_.starts_with("pi") || rest_.starts_with("T");
        rational value = bare_unit ? rational(1) : decimal();
        result.measure = suffix();
        if (take("/")) {
            const rational divisor = decimal();
            if (divisor == 0) {
                refuse("divides by zero");
            }
            value /= divisor;
        }
        if (!rest_.empty()) {
            refuse("is not a number");
        }
        result.coefficient = negative ? rational(-value) : value;
        return result;
    }

private:
    static constexpr long largest_exponent = 100'000;
    static constexpr std::size_t longest_text = 200'000;

    [[noreturn]] void refuse(const char* reason) const {
        throw error(error_kind::argument, "number", std::string(text_), reason);
    }

    bool take(std::string_view word) {
        if (!rest_.starts_with(word)) {
            return false;
        }
        rest_.remove_prefix(word.size());
        return true;
    }

    // Takes a sign; true for minus.
    bool sign() {
        if (take("-")) {
            return true;
        }
        take("+");
        return false;
    }

    unit suffix() {
        if (take("pi")) {
            return unit::pi;
        }
        if (take("deg")) {
            return unit::degree;
        }
        return take("T") ? unit::period : unit::one;
    }

    std::string digit_run() {
        std::string run;
        while (!rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0) {
            run += rest_.front();
            rest_.remove_prefix(1);
        }
        return run;
    }

    // The value of [digits][.digits][e[sign]digits]; at least one digit before the exponent.
    rational decimal() {
        std::string significand = digit_run();
        long exponent = 0;
        if (take(".")) {
            const std::string fraction = digit_run();
            significand += fraction;
            exponent = -static_cast<long>(fraction.size());
        }
        if (significand.empty()) {
            refuse("is not a number");
        }
        exponent += written_exponent();
        if (std::labs(exponent) > largest_exponent || significand.size() > longest_text) {
            refuse("is beyond the range 1e-100000 .. 1e100000");
        }
        const std::size_t first = significand.find_first_not_of('0');
        if (first == std::string::npos) {
            return 0;
        }
        const integer digits(significand.substr(first));
        const integer power = boost::multiprecision::pow(integer(10), static_cast<unsigned>(std::labs(exponent)));
        return exponent < 0 ? rational(digits, power) : rational(integer(digits * power));
    }

    long written_exponent() {
        if (!take("e") && !take("E")) {
            return 0;
        }
        const bool negative = sign();
        const std::string run = digit_run();
        if (run.empty()) {
            refuse("is not a number");
        }
        long value = 0;
        const auto [end, problem] = std::from_chars(run.data(), run.data() + run.size(), value);
        if (problem != std::errc() || value > 2 * largest_exponent) {
            refuse("is beyond the range 1e-100000 .. 1e100000");
        }
        return negative ? -value : value;
    }

    std::string_view text_;
    std::string_view rest_;
};

/// The exact number a text stands for; throws error ("is not a number", "divides by zero", ...).
inline exact read_exact(std::string_view text) { return exact_reader(text).read(); }

/// A whole or fractional value as an exact number.
inline exact exactly(const rational& value) { return {value, unit::one, value.str()}; }

/// The exact number in T, rounded once: pi enters with 64 more bits than T has.
/// Throws error for multiples of the period, which only a motion knows.
template <rounding_scalar T>
T from_exact(const exact& number) {
    switch (number.measure) {
        case unit::one: return from_rational<T>(number.coefficient);
        case unit::period:
            throw error(error_kind::argument, "number", number.text, "is a multiple of a period, not a number");
        default: break;
    }
    mpfr product;
    {
        const precision_scope guard(decimal_digits(digits<T>() + 64));
        product = from_rational<mpfr>(number.in_pi()) * pi<mpfr>();
    }
    return narrow<T>(product);
}

}  // namespace libration
