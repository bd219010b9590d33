#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "guarded.hpp"
#include "libration/digits/proved_decimals.hpp"
#include "libration/number/given_number.hpp"
#include "libration/scalar/ball/binary_parts.hpp"
#include "libration/scalar/proved_digits.hpp"

namespace libration::c {

libration_number rounded_number(const std::string& decimal) {
    if (decimal == "0" || decimal.find_first_of("in") != std::string::npos) {
        return {decimal, "0", LIBRATION_ROUNDED};
    }
    const std::size_t e = std::min(decimal.find('e'), decimal.size());
    const std::size_t point = std::min(decimal.find('.'), e);
    const long exponent = e < decimal.size() ? std::stol(decimal.substr(e + 1)) : 0;
    const long places = point < e ? static_cast<long>(e - point - 1) : 0;
    return {decimal, place_point(false, "1", exponent - places + 1), LIBRATION_ROUNDED};
}

libration_number proved_number(const proved_decimal& number) {
    if (!has_a_digit(number)) {
        throw std::logic_error("a proved number has no proved digit");
    }
    return {number.text, number.uncertainty, LIBRATION_PROVED};
}

namespace {

// Bits beyond the digits of a decimal, with which it is converted.
constexpr long digits_beyond = 25;

// +1 or -1 if the number is infinite.
int infinity_of(const libration_number& x) { return x.decimal == "inf" ? 1 : x.decimal == "-inf" ? -1 : 0; }

// A ball that contains the exact number. Throws error if nothing is known about it.
ball enclosure_of(const libration_number& x) {
    const precision_scope scope(std::max<long>(static_cast<long>(x.decimal.size()), 17) + digits_beyond);
    if (x.uncertainty.empty()) {
        throw error(error_kind::undecided, error_subject::number, x.decimal, "has no bound of its error");
    }
    try {
        return enclose(from_rational<ball>(read_exact(x.decimal).coefficient),
                       from_rational<ball>(read_exact(x.uncertainty).coefficient));
    } catch (const error& problem) {  // beyond the supported exponents
        throw error(error_kind::range, error_subject::number, x.decimal, problem.reason());
    }
}

double nearest_double(const libration_number& x) {
    if (infinity_of(x) != 0) {
        return infinity_of(x) * std::numeric_limits<double>::infinity();
    }
    const ball enclosure = enclosure_of(x);
    const double below = mpfr_get_d(handle(midpoint_of(lower_bound(enclosure))), MPFR_RNDN);
    const double above = mpfr_get_d(handle(midpoint_of(upper_bound(enclosure))), MPFR_RNDN);
    if (!(below == above)) {
        throw error(error_kind::undecided, error_subject::number, x.decimal,
                    "does not determine its double: request more digits");
    }
    return below;
}

void write_text(const std::string& text, char* place, std::size_t size) {
    given(place, "the pointer to the text");
    if (text.size() >= size) {
        throw error(error_kind::range, "size", std::to_string(size),
                    "is too small: " + std::to_string(text.size() + 1) + " characters are needed");
    }
    std::memcpy(place, text.c_str(), text.size() + 1);
}

std::string exact_text(const std::string& mantissa, long exponent) {
    const std::size_t first = mantissa.starts_with('-') || mantissa.starts_with('+') ? 1 : 0;
    const bool whole =
        mantissa.size() > first && std::all_of(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                               [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!whole) {
        throw error(error_kind::argument, "mantissa", mantissa, "is not an integer");
    }
    return mantissa + "*2^" + (exponent < 0 ? "(" + std::to_string(exponent) + ")" : std::to_string(exponent));
}

// A decimal, and a bound that leaves at least one digit if it is proved.
void require_bound(const libration_number& written) {
    const rational value = given_fraction("decimal", written.decimal);
    const rational bound = written.uncertainty.empty() ? 0 : given_fraction("uncertainty", written.uncertainty);
    if (bound < 0) {
        throw error(error_kind::argument, "uncertainty", written.uncertainty, "is negative");
    }
    if (written.rigour == LIBRATION_PROVED && value != 0 && bound > abs(value)) {
        throw error(error_kind::argument, "uncertainty", written.uncertainty,
                    "is larger than the number: no digit of it is proved");
    }
}

std::size_t mantissa_size(const libration_number& x) {
    // The digits of the decimal and of the additional bits, a sign, the terminating 0.
    return x.decimal.size() + static_cast<std::size_t>(2 * digits_beyond);
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_number_read(const char* text, long digits, libration_number** number) {
    return made(number, [&] {
        const exact read = given_number("number", text_of(text, "number"));
        return proved_number(sign_of_exact(read) == 0
                                 ? proved_decimal{"0", "0"}
                                 : proved_value(given_digits(digits), [&] { return from_exact<ball>(read); }));
    });
}

int libration_number_of(const char* decimal, const char* uncertainty, int rigour, libration_number** number) {
    return made(number, [&] {
        if (rigour < LIBRATION_HEURISTIC || rigour > LIBRATION_PROVED) {
            throw error(error_kind::argument, "rigour", std::to_string(rigour), "is not one of the three");
        }
        libration_number written{text_of(decimal, "decimal"), text_of(uncertainty, "uncertainty"), rigour};
        if (infinity_of(written) == 0) {
            require_bound(written);
        }
        return written;
    });
}

int libration_exact_text(const char* mantissa, long exponent, char* text, size_t size) {
    return guarded([&] { write_text(exact_text(text_of(mantissa, "mantissa"), exponent), text, size); });
}

const char* libration_number_decimal(const libration_number* number) {
    return number == nullptr ? "" : number->decimal.c_str();
}

const char* libration_number_uncertainty(const libration_number* number) {
    return number == nullptr ? "" : number->uncertainty.c_str();
}

int libration_number_rigour(const libration_number* number) {
    return number == nullptr ? LIBRATION_HEURISTIC : number->rigour;
}

int libration_number_double(const libration_number* number, double* nearest) {
    return guarded([&] {
        const double found = nearest_double(given(number, "number"));
        given(nearest, "the pointer to the result");
        *nearest = found;
    });
}

int libration_number_bounds(const libration_number* number, double* lower, double* upper) {
    return guarded([&] {
        const libration_number& x = given(number, "number");
        given(lower, "the pointer to the lower bound");
        given(upper, "the pointer to the upper bound");
        if (infinity_of(x) != 0) {
            *lower = *upper = infinity_of(x) * std::numeric_limits<double>::infinity();
            return;
        }
        const ball enclosure = enclosure_of(x);
        *lower = mpfr_get_d(handle(midpoint_of(lower_bound(enclosure))), MPFR_RNDD);
        *upper = mpfr_get_d(handle(midpoint_of(upper_bound(enclosure))), MPFR_RNDU);
    });
}

size_t libration_number_mantissa_size(const libration_number* number) {
    return number == nullptr ? 0 : mantissa_size(*number);
}

int libration_number_exact(const libration_number* number, char* mantissa, size_t size, long* exponent,
                           unsigned long* radius, long* radius_exponent) {
    return guarded([&] {
        const libration_number& x = given(number, "number");
        given(exponent, "the pointer to the exponent");
        given(radius, "the pointer to the radius");
        given(radius_exponent, "the pointer to the exponent of the radius");
        if (infinity_of(x) != 0) {
            throw error(error_kind::range, error_subject::number, x.decimal, "is infinite");
        }
        const binary_parts parts = parts_of(enclosure_of(x));
        write_text(parts.mantissa.str(), mantissa, size);
        *exponent = parts.exponent;
        *radius = parts.radius;
        *radius_exponent = parts.radius_exponent;
    });
}

void libration_number_free(libration_number* number) { delete number; }
