// Equations whose Taylor coefficients are known by recurrences or closed forms of their own: poles, branch points, movable
// logarithms and the singular points of linear equations, also in pairs and on one circle.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "attack/question.hpp"

namespace libration::attack {

/// What a closed form knows of the singularities that are nearest to the initial point: their modulus, the limit of
/// a_n/a_(n-p), p = power, and the exponent of their leading term; no limit: the ratios have none.
struct nearest_singularity {
    truth modulus;
    truth limit;
    int power = 1;
    rational exponent;
};

struct asked_law {
    std::string text;
    std::function<std::vector<mpfr>(long)> coefficients;  ///< 0 to n of the first unknown, in the working precision
    std::optional<nearest_singularity> nearest = {};
    std::shared_ptr<std::map<long, std::vector<mpfr>>> known = std::make_shared<std::map<long, std::vector<mpfr>>>();

    /// The same, kept for each precision.
    const std::vector<mpfr>& coefficients_up_to(long n) const;
    /// Of a derivative of the first unknown.
    mpfr coefficient(long n, int derivative = 0) const;
};

asked_law any_law(choices& next);
/// One that knows its nearest singularities.
asked_law any_closed_law(choices& next);

}  // namespace libration::attack
