// The amplitude of a singularity on the positive or negative real axis.
#pragma once

#include <optional>
#include <span>

#include "libration/convergence/verdict.hpp"

namespace libration::convergence {

/// What is known of a singularity: where, its exponent t, and the second one s of two confluent powers.
struct known_power {
    exponent_estimate position, exponent;
    std::optional<double> second = std::nullopt;
    bool is_logarithm = false;
};

/// A of f ~ A (1 - x/x0)^t, for a logarithm of A (1 - x/x0)^t log(1 - x/x0), where x0 is the only singularity on the circle
/// of convergence of f = sum b_k x^k: by the last K + 1 coefficients as sums of those of the functions with the exponents
/// t, t + 1, .. and s, s + 1, .., K + 1 in all, K = 0 .. 8 such that it changes least by the last coefficient, also for the
/// one or two K before. The uncertainty is the largest of four times the difference to the neighbouring K, twice the error
/// by the rate between the lengths N, N/sqrt 2 and N/2 (unknown confluent powers make it slow), and the effect of the
/// uncertainties of x0, t and s. std::nullopt if that is not smaller than |A|, for fewer than 20 coefficients, or if t is
/// not negative, an integer and no logarithm.
std::optional<exponent_estimate> amplitude_of(std::span<const mpfr> b, const known_power& at);

}  // namespace libration::convergence
