// Random values of every scalar for round-trip tests: full significands with corners, exponents from a given range.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "libration/scalar/precision.hpp"

namespace libration::tests {

/// The exponents e, 2^(e-1) <= |x| < 2^e, of all finite values of T, subnormal ones included. For mpfr, whose range is
/// practically unlimited, beyond the range of all other scalars but short enough to be written out.
template <class T>
struct exponent_range {
    static constexpr bool has_subnormal = std::numeric_limits<T>::has_denorm == std::denorm_present;
    long least = std::numeric_limits<T>::min_exponent + 1 - (has_subnormal ? std::numeric_limits<T>::digits : 0);
    long largest = std::numeric_limits<T>::max_exponent;
};
template <>
struct exponent_range<mpfr> {
    long least = -50'000;
    long largest = 50'000;
};

template <class T>
class random_value {
public:
    T operator()() {
        using std::ldexp;
        T value(0);
        for (int bits = 0; bits <= digits<T>() + chunk; bits += chunk) {
            value = ldexp(value + next_chunk(), -chunk);
        }
        value = ldexp(value + 1, -1);  // in [1/2, 1]; the rounding of the sum is acceptable
        const T result = ldexp(value, exponent());
        return bits_() % 2 == 0 ? result : T(-result);
    }

private:
    static constexpr int chunk = 16;

    // Half of the chunks are runs of zeros or ones: carries and short significands are where conversions fail.
    int next_chunk() {
        constexpr std::uint64_t all_ones = (1U << chunk) - 1;
        const std::uint64_t kind = bits_() % 4;
        return static_cast<int>(kind == 0 ? 0 : kind == 1 ? all_ones : bits_() & all_ones);
    }
    // A quarter each at both ends of the range; 1 below the largest, because the significand may have rounded to 1.
    int exponent() {
        const exponent_range<T> range;
        const std::uint64_t kind = bits_() % 4;
        if (kind < 2) {
            const long near_end = std::uniform_int_distribution<long>(0, digits<T>())(bits_);
            return static_cast<int>(kind == 0 ? range.least + near_end : range.largest - 1 - near_end);
        }
        return static_cast<int>(std::uniform_int_distribution<long>(range.least, range.largest - 1)(bits_));
    }

    std::mt19937_64 bits_{20240229};  // any fixed seed
};

}  // namespace libration::tests
