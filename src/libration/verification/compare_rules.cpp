#include "libration/verification/compare_rules.hpp"

#include <algorithm>
#include <cctype>

#include "libration/number/written_number.hpp"

namespace libration {

namespace {

constexpr long least_places = 17;
constexpr long double_digits = 53;

// "nan" and "inf" are possible outputs of a program: 0 for neither, else 1, with a minus for -inf.
struct special_answer {
    bool none = true;
    int infinite = 0;
};

special_answer special(const std::string& text) {
    std::string word;
    for (const char c : text) {
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    const int sign = word.starts_with('-') ? -1 : 1;
    word.erase(0, word.starts_with('-') || word.starts_with('+') ? 1 : 0);
    const bool infinite = word == "inf" || word == "infinity";
    return {!infinite && !word.starts_with("nan"), infinite ? sign : 0};
}

// p with 10^-p <= |x|, at most one more than needed.
long places_of(const rational& x) {
    const precision_scope scope(20);
    const long exponent = binary_exponent(from_rational<mpfr>(x));
    return exponent == exponent_of_zero ? 0
           : exponent > 0               ? 1 - decimal_digits(exponent - 1)
                                        : decimal_digits(1 - exponent);
}

// The largest power of 10 that is at most |x|, x nonzero.
rational power_below(const rational& x) {
    const rational size = abs(x);
    long exponent = -places_of(x);
    while (power_of(10, exponent + 1) <= size) {
        ++exponent;
    }
    return power_of(10, exponent);
}

error_bound larger(const error_bound& a, const error_bound& b) { return certainly_less(a.value, b.value) ? b : a; }

error_bound relative_bound(const true_value& truth, const rational& relative) {
    return truth.exactly && !truth.is_zero() ? error_bound(rational(abs(*truth.exactly) * relative))
                                             : error_bound(ball(truth.size() * from_rational<ball>(relative)));
}

// One unit of the last digit, half of it if values are rounded, half a unit in the last place of a double. At an exact
// 0, that of a number of the scale with as many digits.
error_bound last_digit_of(const written_number& value, const true_value& truth, bool of_double, bool rounded) {
    const rational share(1, of_double || rounded ? 2 : 1);
    if (of_double) {
        error_bound own(rational(share * unit_in_last_place(value.value)));
        if (!truth.is_zero()) {
            return own;
        }
        const long exponent = binary_exponent(midpoint_of(truth.scale));
        return larger(error_bound(rational(share * power_of(2, exponent - double_digits))), own);
    }
    error_bound last_place(rational(share * value.last_place));
    if (!truth.is_zero() || value.value == 0) {
        return last_place;
    }
    return larger(relative_bound(truth, rational(share * value.last_place / power_below(value.value))), last_place);
}

error_bound tolerance_for(const written_number& value, const true_value& truth, bool of_double,
                          const compare_rules& rules) {
    if (rules.ulps) {
        const long exponent = std::max(1L, binary_exponent(midpoint(truth.value())));
        return error_bound(rational(*rules.ulps * power_of(2, exponent - double_digits)));
    }
    if (rules.relative) {
        const error_bound of_size = relative_bound(truth, *rules.relative);
        return rules.tolerance ? larger(of_size, error_bound(*rules.tolerance)) : of_size;
    }
    return rules.tolerance ? error_bound(*rules.tolerance) : last_digit_of(value, truth, of_double, rules.rounded);
}

comparison compare_infinite(int answer, const true_value& truth) {
    const char* const reference = truth.infinite < 0 ? "-inf" : "inf";
    return answer == truth.infinite ? comparison{true, reference, "0", std::nullopt, mpfr(0)}
                                    : infinite_error(reference);
}

}  // namespace

bool is_not_finite(const std::string& value) { return !special(value).none; }

long places_for(const std::string& value, const compare_rules& rules) {
    const long of_rules =
        std::max(rules.tolerance ? places_of(*rules.tolerance) : 0, rules.relative ? places_of(*rules.relative) : 0);
    const long of_value = special(value).none ? places_of(read_written(value).last_place) : 0;
    return std::max({of_value, of_rules, least_places});
}

std::optional<comparison> compare_value(const written_value& value, const true_value& truth, const compare_rules& rules,
                                        bool last_attempt) {
    const special_answer answer = special(value.text);
    if (truth.infinite != 0) {
        return compare_infinite(answer.infinite, truth);
    }
    written_number written = answer.none ? read_written(value.text) : written_number{0, 1};
    const bool of_double = value.of_double && answer.none;
    if (of_double) {
        written.value = nearest_double(written.value);
    }
    const error_bound tolerance = tolerance_for(written, truth, of_double, rules);
    const long places = std::max(places_for(value.text, rules), rules.ulps || rules.relative ? least_places : 0) + 3;
    auto result = compare(written.value, truth, tolerance, places, last_attempt);
    return result && !answer.none ? std::optional(infinite_error(result->reference)) : result;
}

}  // namespace libration
