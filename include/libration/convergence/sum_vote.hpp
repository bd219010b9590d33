// The vote of several approximations of one number, each of which has changed by a step with its last coefficients: the
// number where most of them agree to within their steps.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libration/scalar/mpfr.hpp"

namespace libration::convergence {

/// An approximation and the root mean square of its last changes, positive.
struct stepped_value {
    mpfr value, step;
};

/// The weighted median of the sharpest members, the distance within which three quarters of their weight are, and their
/// median step.
struct vote_result {
    mpfr value, spread, step;
    std::vector<std::size_t> members;  ///< indices of the values within 12 of their steps of the leader
};

/// With s_i the steps and l `scale`, the leader is the value v_j with the largest product over i of
///     7/10 (l/(4 s_i))/(1 + ((v_j - v_i)/(4 s_i))^2)^(3/2) + 3/10,
/// and the sharpest members are the at most twelve with steps up to ten times the third smallest. std::nullopt for no
/// values.
std::optional<vote_result> vote_on(std::span<const stepped_value> values, const mpfr& scale);

}  // namespace libration::convergence
