// Sequences of balls cut into blocks of similar exponents.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "libration/scalar/ball/value.hpp"

namespace libration {

/// Coefficients first .. first + length - 1, of which the first and the last are nonzero. All of them, divided by
/// 2^(scale k), are multiples of 2^low and below 2^high.
struct exponent_block {
    int first, length;
    long low, high;
};

/// Whether it is finite, with its midpoint and its radius 0 or within 2^(-2^28) and 2^(2^28): then the sums of
/// exponents of two of them and of 2^31 times a slope do not overflow.
bool has_moderate_exponents(const ball& x);

/// The slope of the exponents of the midpoints of both sequences: (e_l - e_f) / (l - f), f and l the first and the last
/// nonzero coefficient, weighted by l - f and rounded. 0 if there is none. All exponents are moderate.
long common_slope(const ball* a, int a_terms, const ball* b, int b_terms);

/// The blocks of terms 0 .. terms - 1, in order: each continues as long as high - low < height. extent(k) returns `low`
/// and `high` of term k, or std::nullopt if it is 0.
template <class Extent>
std::vector<exponent_block> blocks_of(int terms, long height, const Extent& extent) {
    std::vector<exponent_block> blocks;
    for (int k = 0; k < terms; ++k) {
        const std::optional<exponent_block> term = extent(k);
        if (!term) {
            continue;
        }
        if (!blocks.empty()) {
            exponent_block& last = blocks.back();
            const long low = std::min(last.low, term->low);
            const long high = std::max(last.high, term->high);
            if (high - low < height) {
                last = {last.first, k - last.first + 1, low, high};
                continue;
            }
        }
        blocks.push_back(*term);
    }
    return blocks;
}

/// Those of the midpoints, whose exponents are moderate, divided by 2^(scale k).
std::vector<exponent_block> blocks_of_midpoints(const ball* a, int terms, long scale, long height);

}  // namespace libration
