// Coordinates at an equilibrium in which an invariant subspace is diagonal.
#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "complex_jet.hpp"

namespace libration::ode {

/// Which eigenvalues are followed, in double: the choice of coordinates, on which no proof depends.
struct frame_plan {
    std::vector<std::complex<double>> rates;                 ///< real ones, then pairs of conjugate ones
    std::vector<std::vector<std::complex<double>>> vectors;  ///< their eigenvectors, with entry 1 at the pivot
    std::vector<std::size_t> pivots;
    std::vector<std::vector<double>> others;  ///< the columns that complete them
    long log2_scale = 0;                      ///< of the columns of the eigenvectors

    std::size_t size() const { return rates.size(); }
    /// Whether theta_j and theta_{j+1} are conjugate.
    bool begins_pair(std::size_t j) const { return rates[j].imag() > 0; }
    bool ends_pair(std::size_t j) const { return rates[j].imag() < 0; }
};
/// The eigenvalues with real part below minus a thousandth of the largest one, at most so many, the fastest of them.
/// Empty if that would separate a pair, or eigenvalues that nearly have the same real part.
frame_plan stable_plan(const jet_matrix& linear, std::size_t most = static_cast<std::size_t>(-1));

/// y - y* = Q w: the first columns are eigenvectors.
struct linear_frame {
    jet_matrix columns;              ///< Q by rows
    std::vector<complex_jet> rates;  ///< the eigenvalues of the first columns
};
/// Encloses the eigenvectors, with their derivatives, for all matrices of the balls: Krawczyk's test for A v = d v, v = 1
/// at the pivot, in complex balls. std::nullopt if it fails, as for multiple eigenvalues.
std::optional<linear_frame> enclosed_frame(const jet_matrix& linear, const frame_plan& plan);

}  // namespace libration::ode
