// Series with random integer coefficients: products, quotients and powers of these are exact in every scalar.
#pragma once

#include <random>

#include "libration/series/convolution.hpp"

namespace libration::tests {

using namespace series;

class random_series {
public:
    /// Coefficients in -size .. size, of the given parity; the constant one as given.
    template <class T>
    power_series<T> of_order(int order, int constant, parity p = parity::any, int size = 3) {
        auto series = power_series<T>::zero(order);
        std::uniform_int_distribution<int> coefficient(-size, size);
        for (int n = 1; n <= order; ++n) {
            const bool vanishes = p != parity::any && (n % 2 == 0) != (p == parity::even);
            series[n] = T(vanishes ? 0 : coefficient(bits_));
        }
        series[0] = T(constant);
        return series;
    }

private:
    std::mt19937 bits_{42};  // any fixed seed
};

}  // namespace libration::tests
