// Many times at once through the tables of the sampler in double, in the widest vectors that the processor has.
#pragma once

#include <cstddef>

#include "libration/pendulum/sampler/sampling_constants.hpp"

namespace libration::pendulum {

/// The tables of a sampler<double>, which has to outlive them.
struct vector_tables {
    const clock_constants<double>& clock;
    const turn_constants<double>& turns;
    /// Rows of 2 double_panel_terms numbers as panel<double> has them, at addresses divisible by 64.
    const double* panels;
    /// The largest time since the bottom, in the unit of the panels.
    double end;
};

/// How many times are answered together.
inline constexpr std::size_t vector_block = 32;

/// theta and omega at the leading times, block by block until a block holds a time that the clock does not reach, or
/// is no whole block any more; returns how many that are. The arrays may be the same.
///
/// What sampled_at does, in its order but for the polynomials: a vector holds two, four or eight neighbouring
/// coefficients of theta and of its slope, Horner's rule runs in the power of x that goes with it, and once more over
/// the sums. So the error is not larger than there, and the last digit is another with SSE, AVX2, AVX-512 and
/// NEON. The processor is asked once, by Highway [Highway]. Compiled: in the target libration::libration alone.
std::size_t sample_vectors(const vector_tables& tables, const double* times, std::size_t count, double* theta,
                           double* omega);

}  // namespace libration::pendulum
