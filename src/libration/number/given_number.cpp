#include "libration/number/given_number.hpp"

#include "libration/scalar/dispatch.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

exact given_number(const std::string& quantity, const std::string& text) {
    try {
        return read_exact(text);
    } catch (const error& problem) {
        throw error(problem.kind(), quantity, text, problem.reason());
    }
}

rational given_fraction(const std::string& quantity, const std::string& text) {
    const exact number = given_number(quantity, text);
    if (number.measure != unit::one) {
        throw error(error_kind::argument, quantity, text, "has a unit");
    }
    return number.coefficient;
}

exact given_angle(const std::string& quantity, const std::string& text) {
    exact number = given_number(quantity, text);
    if (number.has_periods()) {
        throw error(error_kind::argument, quantity, text, "is a time");
    }
    return number;
}

exact given_time(const std::string& quantity, const std::string& text) {
    exact number = given_number(quantity, text);
    if (number.measure == unit::degree) {
        throw error(error_kind::argument, quantity, text, "is an angle");
    }
    return number;
}

long given_digits(long digits) {
    if (digits < 1 || digits > most_digits) {
        throw error(error_kind::argument, "number of digits", std::to_string(digits),
                    "is not between 1 and " + std::to_string(most_digits));
    }
    return digits;
}

}  // namespace libration
