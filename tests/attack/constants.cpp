#include "attack/constants.hpp"

#include <stdexcept>

#include "libration/number/exact.hpp"

namespace libration::attack {

namespace {

long number_between(const std::string& text, const std::string& before) {
    return std::stol(text.substr(text.find(before) + before.size()));
}

// base^-k.
mpfr power_below_one(long base, long k) { return 1 / pow(mpfr(base), mpfr(k)); }

// The forms of corner_numbers::constant(), in MPFR.
mpfr value_of(const std::string& text) {
    if (text == "tanh(25)") {
        return tanh(mpfr(25));
    }
    if (text.starts_with("1 - exp(")) {
        return 1 - exp(mpfr(-number_between(text, "exp(-")));
    }
    if (text.starts_with("1 ")) {
        const long base = text.find("10^") != std::string::npos ? 10 : 2;
        const mpfr small = power_below_one(base, number_between(text, "^(-"));
        return text[2] == '+' ? mpfr(1 + small) : mpfr(1 - small);
    }
    const exact number = read_exact(text);
    if (!number.is_fraction()) {
        throw std::logic_error("no value is known of the constant " + text);
    }
    return real(number.coefficient);
}

}  // namespace

constant constant_of(const rational& q) {
    return {"(" + q.str() + ")", [q] { return real(q); }};
}

constant constant_of(long n) { return constant_of(rational(n)); }

constant simple_constant(choices& next) { return constant_of(rational(next.between(1, 9), next.between(1, 9))); }

constant near_one(choices& next) {
    const std::string text = next.constant();
    return {"(" + text + ")", [text] { return value_of(text); }};
}

constant any_constant(choices& next) { return next.one_in(2) ? near_one(next) : simple_constant(next); }

}  // namespace libration::attack
