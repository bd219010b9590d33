// Square root of a power series.
#pragma once

#include "libration/series/convolution.hpp"

namespace libration {

/// r = sqrt f, with r_0 given (of either sign, r_0^2 = f_0; f_0 itself is not read): 2 r_0 r_n = f_n - sum_{k=1}^{n-1}
/// r_k r_{n-k}, each pair of equal products formed once. O(N^2), half of a product of series; an even f, a quarter of
/// that.
template <scalar T>
power_series<T> square_root(const power_series<T>& f, const T& root_of_constant, parity of_f = parity::any) {
    auto r = power_series<T>::zero(f.order());
    r[0] = root_of_constant;
    const T twice = root_of_constant * 2;
    const int step = of_f == parity::any ? 1 : 2;
    for (int n = step; n <= f.order(); n += step) {
        T sum = convolution(r, r, n, 1, (n - 1) / 2, of_f);
        sum += sum;
        const bool middle = n % 2 == 0 && (n / 2) % step == 0;
        if (middle) {
            add_product(sum, r[n / 2], r[n / 2]);
        }
        r[n] = (f[n] - sum) / twice;
    }
    return r;
}

}  // namespace libration
