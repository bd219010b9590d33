// Square root of a power series.
#pragma once

#include "libration/series/kernel.hpp"

namespace libration::series {

/// r = sqrt f, with r_0 given (of either sign, r_0^2 = f_0; f_0 itself is not read), by square_root_kernel(). O(N^2),
/// half of a product of series; for an even f, a quarter of that.
template <field R>
power_series<R> square_root(const power_series<R>& f, const R& root_of_constant, parity of_f = parity::any) {
    auto r = power_series<R>::zero(f.order());
    r[0] = root_of_constant;
    const R twice = root_of_constant * 2;
    const int step = of_f == parity::any ? 1 : 2;
    for (int n = step; n <= f.order(); n += step) {
        square_root_kernel(f.data(), twice, r.data(), n, of_f);
    }
    return r;
}

}  // namespace libration::series
