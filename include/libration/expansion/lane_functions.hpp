// Constants, functions and sums of numbers in lanes.
#pragma once

#include "libration/equation/constant_value.hpp"
#include "libration/equation/function_value.hpp"
#include "libration/expansion/lane_numbers.hpp"
#include "libration/scalar/fixed_traits.hpp"

namespace libration::ode {

/// One constant in all lanes.
template <>
struct constant_value<lane_numbers> {
    static lane_numbers of(const number& x) { return {constant_value<double>::of(x)}; }
};

/// The function of double in each lane.
template <>
inline lane_numbers function_value<lane_numbers>(function_kind f, const lane_numbers& x, const rational* order) {
    lane_numbers result;
    for (std::size_t i = 0; i < batch_lanes; ++i) {
        result[i] = function_value<double>(f, x[i], order);
    }
    return result;
}

/// The coefficients of series_values() in each lane.
inline std::vector<lane_numbers> series_by_balls(function_kind f, relative_kind family, int order,
                                                 const lane_numbers& x, int count) {
    std::vector<lane_numbers> result(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < batch_lanes; ++i) {
        const std::vector<double> of_lane = series_by_balls(f, family, order, x[i], count);
        for (std::size_t j = 0; j < result.size(); ++j) {
            result[j][i] = of_lane[j];
        }
    }
    return result;
}

template <>
inline lane_numbers power_value<lane_numbers>(const lane_numbers& x, const lane_numbers& r) {
    lane_numbers result;
    for (std::size_t i = 0; i < batch_lanes; ++i) {
        result[i] = power_value<double>(x[i], r[i]);
    }
    return result;
}

}  // namespace libration::ode

/// Sums in the order in which those of doubles are formed.
template <>
struct libration::scalar_traits<libration::ode::lane_numbers> {
    using numbers = libration::ode::lane_numbers;
    static numbers sum_of_products(const numbers* x, int x_step, const numbers* y, int y_step, int count) {
        constexpr int stride = libration::ode::batch_lanes;
        numbers result;
        for (std::size_t i = 0; i < libration::ode::batch_lanes; ++i) {
            const double* const a = x->lane.data() + i;
            const double* const b = y->lane.data() + i;
            if (x_step == 1 && y_step == -1) {
                result[i] = sum_in_lanes<stride, -stride>(a, b, count);
            } else if (x_step == 1 && y_step == 1) {
                result[i] = sum_in_lanes<stride, stride>(a, b, count);
            } else {
                result[i] = scalar_traits<double>::sum_of_products(a, x_step * stride, b, y_step * stride, count);
            }
        }
        return result;
    }
};
