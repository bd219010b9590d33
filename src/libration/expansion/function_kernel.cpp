#include "libration/expansion/function_kernel.hpp"

#include <algorithm>
#include <cstddef>

namespace libration::ode {

namespace {

const magnitude& unit_size() {
    thread_local const magnitude value(1U);
    return value;
}

}  // namespace

magnitude function_kernel::value(const magnitude& z) const {
    return power == 0 ? size * exponential(z)
                      : size * pow(unit_size() / magnitude::difference_below(unit_size(), z / reach), power);
}

magnitude function_kernel::slope(const magnitude& z) const {
    return power == 0 ? value(z) : value(z) * magnitude(power) / (magnitude::difference_below(reach, z));
}

magnitude function_kernel::second(const magnitude& z) const {
    return power == 0 ? value(z) : slope(z) * magnitude(power + 1) / (magnitude::difference_below(reach, z));
}

magnitude function_kernel::rest(const std::vector<magnitude>& terms) const {
    const std::size_t count = terms.size();
    const magnitude unit = power == 0 ? unit_size() : reach;
    const magnitude factor = power == 0 ? unit_size() : magnitude(power);
    const auto part = [&](std::size_t j, std::size_t i) {  // of h_j M_i in n M_n
        const magnitude weight = factor * magnitude(j);
        return power == 0 ? weight : weight + magnitude(i);
    };
    std::vector<magnitude> h{magnitude()};
    std::vector<magnitude> series{size};
    magnitude norm;
    magnitude moved;
    for (std::size_t n = 1; n < count; ++n) {
        h.push_back(terms[n] / unit);
        norm += terms[n];
        moved += h[n] * factor * magnitude(n);
        magnitude sum;
        for (std::size_t j = 1; j <= n; ++j) {
            sum.add_product(h[j] * part(j, n - j), series[n - j]);
        }
        series.push_back(sum / n);
    }
    magnitude below;
    for (std::size_t j = 1; j < count; ++j) {
        for (std::size_t i = count - j; i < count; ++i) {
            below.add_product(h[j] * part(j, i), series[i]);
        }
    }
    // Y (1 - norm/reach - moved/N) <= below, and ||phi(h), degrees >= N|| <= Y/N <= phi(norm).
    const magnitude lost = (power == 0 ? magnitude() : norm / reach) + moved / count;
    const magnitude margin = magnitude::difference_below(unit_size(), lost);
    const magnitude all = value(norm);
    return margin.is_zero() ? all : std::min(all, below / margin / count);
}

}  // namespace libration::ode
