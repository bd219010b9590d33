// First guesses of an unknown for which none is given.
#pragma once

#include <array>
#include <vector>

#include "libration/equation/constant_value.hpp"

namespace libration::ode {

inline constexpr std::array first_guesses_of_one{1.0, 0.5, 2.0,  0.0, 0.25, 0.75, 1.5, 3.0,
                                                 5.0, 0.1, 0.35, 0.9, 1.25, 7.0,  10.0};

/// Numbers in double.
inline std::vector<double> nearest_doubles(const std::vector<number>& of) {
    std::vector<double> result;
    for (const number& each : of) {
        result.push_back(constant_value<double>::of(each));
    }
    return result;
}

/// These with both signs.
inline std::vector<double> signed_first_guesses() {
    std::vector<double> all;
    for (const double each : first_guesses_of_one) {
        all.push_back(each);
        if (each != 0) {
            all.push_back(-each);
        }
    }
    return all;
}

/// A guess, and numbers on both sides of it at distances of `first` of its size, 2 first, .. up to `last`.
inline std::vector<double> guesses_around(double given, double first, double last) {
    std::vector<double> all{given};
    for (double part = first; part <= last; part *= 2) {
        all.insert(all.end(), {given * (1 + part) + part / 8, given * (1 - part) - part / 8});
    }
    return all;
}

}  // namespace libration::ode
