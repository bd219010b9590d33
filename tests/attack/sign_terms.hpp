// Terms of the signs of two functions u and v: as typed, and their values by the signs.
#pragma once

#include <functional>
#include <string>

#include "attack/constants.hpp"

namespace libration::attack {

struct sign_term {
    std::string text;
    std::function<rational(int sign_of_u, int sign_of_v)> value;
};

/// Random terms of u and v, which are given as typed. Some are valid for |v| < 100 only.
class sign_term_choices {
public:
    sign_term_choices(choices& next, std::string u, std::string v) : next_(next), u_(std::move(u)), v_(std::move(v)) {}

    /// Of at most so many functions inside each other.
    sign_term any(long depth);

private:
    sign_term number();
    sign_term conditional(long depth);
    sign_term smooth(long depth);

    choices& next_;
    std::string u_, v_;
};

}  // namespace libration::attack
