// Constants of the problems of an attack: as they are typed, and their values in MPFR.
#pragma once

#include <string>

#include "attack/judge.hpp"
#include "corner_numbers.hpp"

namespace libration::attack {

using choices = tests::corner_numbers;

/// A constant as it is typed, in parentheses unless it is a decimal, and its value.
struct constant {
    std::string text;
    truth value;

    double rough() const { return attack::rough(value); }
};

constant constant_of(const rational& q);
constant constant_of(long n);

/// p/q with p, q of one digit.
constant simple_constant(choices& next);
/// Forty nines, 1 - 10^-k, 1 - 2^-k, tanh(25), 1 - exp(-k) and the like: near 1.
constant near_one(choices& next);
/// Half of them near one.
constant any_constant(choices& next);

}  // namespace libration::attack
