// Proved digits: balls are recomputed with more guard digits until every printed digit is proved.
#pragma once

#include <functional>
#include <vector>

#include "libration/digits/precision_loop.hpp"
#include "libration/scalar/ball/decimal.hpp"

namespace libration {

/// The maximum number of guard digits of a proof: 20, doubled nine times.
inline constexpr long most_guard_digits = 10'240;

/// The runs of a proof of this number of digits.
inline growing_digits proving(long digits) { return {digits, 20, most_guard_digits}; }

/// compute() returns balls in the working precision; they are printed with `digits` digits, each proved. vanishing(),
/// called once if a ball keeps containing 0, returns which of them are exactly 0, which no precision can decide. Throws
/// error of the kind undecided if a proof is impossible: a digit is not decided by most_guard_digits more.
std::vector<proved_decimal> proved_decimals(long digits, const std::function<std::vector<ball>()>& compute,
                                            const std::function<std::vector<bool>()>& vanishing = {});

/// The same for one number.
proved_decimal proved_value(long digits, const std::function<ball()>& compute);

}  // namespace libration
