// The length and the order of a step of many bits, and the bits of its coefficients, from the series in long double. No
// proof depends on them.
#pragma once

#include <optional>
#include <vector>

#include "libration/expansion/ball_expansion.hpp"

namespace libration::ode {

/// From so many bits on a step is planned: the series in long double then takes a small part of its time.
inline constexpr long least_bits_of_plan = 256;

struct planned_step {
    double log_of_length = 0;  ///< log2
    int order = 0;
    /// [n]: so many decimal digits of what follows from coefficient n contribute to the values at the end of the step
    /// as much as all bits of the values at its beginning.
    std::vector<long> digits;
};

/// From the coefficients a_n of the unknowns, with R from the last ones. A step of length h takes order N = bits/log2(R/h)
/// and N^p operations; of all divisions of the way into equal steps, that of the least cost. With the bits of coefficient
/// n reduced by -log2(|a_n| h^n/max_k |a_k| h^k) in the unknown where that is the least, the errors of all coefficients
/// are about as large.
class step_planner {
public:
    /// The tape must outlive it.
    step_planner(const tape& of, long bits);

    long bits() const { return bits_; }
    /// From values of all unknowns at a time, over a way that may be infinite. std::nullopt if a coefficient is beyond
    /// the exponents of long double, or the series has no radius.
    std::optional<planned_step> plan(const ball& time, const std::vector<ball>& values, double way);

private:
    int order_for(double log_of_length, double log_of_radius) const;
    double planned_length(double way, double log_of_radius) const;
    std::vector<long> digits_for(double log_of_length, int order) const;

    std::size_t unknowns_;
    long bits_;
    std::optional<taylor_expansion<long double>> series_;
};

}  // namespace libration::ode
