// A list of coefficients as input of a verdict, and the sizes of its coefficients.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "libration/convergence/coefficient_pattern.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::convergence {

/// a_0 .. a_N, each known to `noise` of its size; 0 for exact numbers. Exact ones should have at least bits_for(N) bits.
struct series_list {
    std::vector<mpfr> values;
    double noise = 0;
    /// Coefficients below 64 times this, relative to their largest neighbour, are rounding errors of 0.
    double zero = 0;

    int order() const { return static_cast<int>(values.size()) - 1; }
};

/// The zeros of a list: exact ones, and those that its rounding may have left, at most 1e-12 of their neighbours.
coefficient_pattern pattern_of(const series_list& list);

/// The coefficients of the class that the pattern found, b_k = a_(first + stride k).
std::vector<mpfr> class_of(const series_list& list, const coefficient_pattern& pattern);

/// The working precision that a list of order N deserves: 384 + 2 N bits. The systems of differential approximants are
/// so ill-conditioned that half of them are lost.
constexpr long bits_for(int order) { return 384 + 2L * order; }

/// That of a list known to `noise` of its size, at most 384 + max(256, -8 log2 noise): the noise bounds the condition of
/// the systems.
long bits_for(int order, double noise);

/// log |x|, -infinity for 0, to a few epsilon.
double log_size(const mpfr& x);

/// The least-squares coefficients c of sum_i c_i rows[k][i] = y_k; std::nullopt for fewer rows than unknowns.
std::optional<std::vector<double>> least_squares(const std::vector<std::vector<double>>& rows,
                                                 const std::vector<double>& y);

/// log |b_k| = alpha + beta k + gamma k log k over the nonzero k >= N/4, fitted once more to the points on or above the
/// first fit; std::nullopt for fewer than eight points. gamma is 0 for a positive radius up to about 2.2 t/N for
/// coefficients like k^t, s for a divergent series of Gevrey order s, and negative for an entire function.
struct size_growth {
    double alpha, beta, gamma;
};
std::optional<size_growth> size_growth_of(std::span<const mpfr> b);

/// A length r, with 20 significant bits, that makes the sizes of b_k r^k level over the second half.
mpfr level_unit(std::span<const mpfr> b);

/// b_k r^k in `bits` bits.
std::vector<mpfr> in_unit(std::span<const mpfr> b, const mpfr& unit, long bits);

}  // namespace libration::convergence
