// A list as it is written in a file: its values, and how much the rounding of its decimals may change them.
#pragma once

#include <optional>
#include <vector>

#include "libration/convergence/list.hpp"
#include "libration/number/exact.hpp"

namespace libration::convergence {

/// Coefficients and the largest errors that the rounding of their decimals allows; none for exact ones.
struct written_list {
    series_list list;
    std::vector<mpfr> rounding;
};

/// Whole numbers, fractions and formulas are exact. Decimals are rounded to half a unit of their last digit if there are
/// fewer than 60: relatively to the digits that the middle one of them has, absolutely to the largest number of places
/// behind the point that any of them has. With `rounded` they are correct to that many significant digits, or exact if it
/// is 0. In the working precision.
written_list written_list_of(const std::vector<exact>& coefficients, std::optional<long> rounded = std::nullopt);

}  // namespace libration::convergence
