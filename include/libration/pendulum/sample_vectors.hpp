// Many times at once through the tables of the sampler in double, using the widest SIMD instructions available.
#pragma once

#include <cstddef>

#include "libration/pendulum/sampling_constants.hpp"

namespace libration::pendulum {

/// The tables of a sampler<double>, which must outlive them.
struct vector_tables {
    const clock_constants<double>& clock;
    const turn_constants<double>& turns;
    /// Rows of 2 double_panel_terms numbers as in panel<double>, at addresses divisible by 64.
    const double* panels;
    /// The largest time since the bottom, in the unit of the panels.
    double end;
};

/// The number of times that are evaluated together.
inline constexpr std::size_t vector_block = 32;

/// theta and omega at the leading times, block by block until a block contains a time outside the range of the clock,
/// or is incomplete; returns the number of these times. The arrays may be the same.
///
/// The algorithm of sampled_at, in its order except for the polynomials: a vector contains two, four or eight
/// neighbouring coefficients of theta and of its slope, Horner's rule runs in the corresponding power of x, and once
/// more over the sums. So the error is not larger than there, and the last digit differs between SSE, AVX2, AVX-512 and
/// NEON. The processor is identified once, by Highway [Highway]. Compiled: in the target libration::libration alone.
std::size_t sample_vectors(const vector_tables& tables, const double* times, std::size_t count, double* theta,
                           double* omega);

}  // namespace libration::pendulum
