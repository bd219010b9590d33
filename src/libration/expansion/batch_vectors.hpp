// Taylor coefficients of several solutions in lock step, one solution in each lane of the widest SIMD vectors available.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "libration/expansion/lane_numbers.hpp"

namespace libration::ode {

/// How coefficient n of a step of a tape follows from the lower ones.
enum class lane_operation {
    sum,
    difference,
    multiple,       ///< a by a factor, over a divisor
    lane_multiple,  ///< a by coefficient 0 of b, which has no others
    product,
    square,
    quotient,
    lane_quotient,  ///< a over coefficient 0 of b, which has no others
    slope,          ///< one degree behind
    copy,           ///< a, n > 0
    square_root,
    primitive,
    sine_cosine,  ///< the cosine in the array behind the result
    hyperbolic_sine_cosine,
    exponential,
    logarithm,  ///< its slope in the array behind the result
    tangent,    ///< 1 + t^2 in the array behind the result
    hyperbolic_tangent,
    power,  ///< its slope in the array behind the result
    other   ///< computed by the caller
};

/// n as a divisor.
struct degree {
    explicit degree(int of) : n(of), value(of), reciprocal(of == 0 ? 0 : 1 / value) {}

    int n;
    double value;
    double reciprocal;  ///< 1/n, rounded; 0 for n = 0
};

/// A step with its arrays, whose coefficients n have the distance batch_lanes.
struct lane_step {
    lane_operation kind;
    int index;  ///< on the tape
    double* result;
    double* behind;  ///< the array of the next step of the tape
    const double* a;
    const double* b;
    const double* derivative;
    double factor;
    degree divisor;
    double* ahead;  ///< two times batch_lanes numbers for sums of the next degree
};

/// An unknown or a lower derivative, and what its slope is.
struct lane_state {
    double* here;
    const double* above;
};

struct lane_program {
    std::vector<lane_step> first;  ///< at n = 0
    std::vector<lane_step> later;  ///< at n > 0, without those of which only coefficient 0 is nonzero
    std::vector<lane_state> states;
    std::vector<degree> degrees;  ///< 0 .. N
    int steps_until = 0;          ///< the last n of the steps
};

/// All coefficients from coefficient 0 of the states; otherwise(index, n) computes that of the other steps. Sums as
/// placed_steps and step_arrays form them in double, separately in each lane, without fused operations.
void run_batch(const lane_program& program, const std::function<void(int, int)>& otherwise);

/// values[i batch_lanes + lane] is the polynomial of array i of degree `order`, by Horner's rule, at distances[lane].
void batch_values(std::span<const double* const> arrays, int order, const double* distances, double* values);

/// sizes[lane] is max |c_n| over these arrays, NaN if one of them is not finite.
void batch_sizes(std::span<const double* const> arrays, int n, double* sizes);

}  // namespace libration::ode
