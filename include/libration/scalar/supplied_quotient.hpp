// The seam between mpfr, which needs no FLINT, and FLINT's quotient of whole sequences, which a program that links
// FLINT has for its mpfr numbers too.
#pragma once

#include <optional>
#include <vector>

#include "libration/scalar/mpfr.hpp"

namespace libration {

/// q with sum_k b_k q_{n-k} = a_n for n below the shorter length, which is not 0, every q_n to within 2^48 epsilon of
/// the largest of them; nothing where that is not proved.
using mpfr_quotient = std::optional<std::vector<mpfr>> (*)(const std::vector<mpfr>& a, const std::vector<mpfr>& b);

/// None, unless a source of the program includes scalar/ball.hpp, whose ball_quotient.hpp sets it before main().
inline mpfr_quotient supplied_quotient = nullptr;

}  // namespace libration
