#include "libration/integration/taylor/taylor_march.hpp"

#include <cmath>

namespace libration::ode {

namespace {

// The least of (size / |c_n|)^(1/n) 2^-shortening.
step_length shortened_radius(long size, const std::vector<coefficient_size>& last, double shortening) {
    constexpr int bits = 10;
    bool found = false;
    double least = 0;
    for (const coefficient_size& each : last) {
        if (each.exponent == exponent_of_zero || each.degree == 0) {
            continue;
        }
        const double here = static_cast<double>(size - each.exponent) / each.degree;
        least = found ? std::min(least, here) : here;
        found = true;
    }
    if (!found) {
        return {};
    }
    const double exponent = least - shortening;
    const double whole = std::floor(exponent);
    return {static_cast<int>(std::exp2(exponent - whole + bits)), static_cast<long>(whole) - bits};
}

}  // namespace

step_length taylor_step(long size, const std::vector<coefficient_size>& last) {
    return shortened_radius(size, last, 2 * std::log2(std::exp(1.0)));
}

step_length taylor_step(long size, const std::vector<coefficient_size>& last, const step_accuracy& accuracy) {
    return shortened_radius(size, last, static_cast<double>(accuracy.bits) / accuracy.order);
}

template class taylor_march<double>;
template class taylor_march<mpfr>;

}  // namespace libration::ode
