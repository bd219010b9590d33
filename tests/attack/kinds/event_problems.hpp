// Problems whose events have closed forms.
#pragma once

#include <string>
#include <vector>

#include "attack/solved_problem.hpp"

namespace libration::attack {

/// More than any question requests.
inline constexpr long most_events = 12;

/// A time since the initial time at which the function of a condition is 0.
struct known_event {
    truth since;
    int way = 1;  ///< 1 upwards, -1 downwards, 0 where it touches
};

/// A problem, a condition, and the first of its events after the initial time: all of them if `all` is set.
struct asked_events {
    solved_problem problem;
    std::string condition;
    std::vector<known_event> events;
    bool all = false;
};

/// Oscillators, polynomials, falls and monotone functions, with levels anywhere, at the initial value and near it.
asked_events any_events(choices& next);

}  // namespace libration::attack
