// Which eigenvalues of an equilibrium are followed, in double: the choice of coordinates, on which no proof depends.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "complex_jet.hpp"

namespace libration::ode {

/// Nearly equal eigenvalues, or a single one, with a basis of their invariant subspace.
struct frame_block {
    std::vector<std::size_t> columns;                      ///< of the frame; the conjugate of a complex one is the next
    std::vector<std::size_t> pivots;                       ///< the rows of the basis that are the unit matrix
    std::vector<std::vector<std::complex<double>>> basis;  ///< a vector for each column
    std::vector<std::vector<std::complex<double>>> mixture;  ///< by rows: the columns of the frame are basis * mixture
};

struct frame_plan {
    std::vector<std::complex<double>>
        rates;  ///< real ones, then pairs of conjugate ones; the mean of nearly equal ones
    std::vector<frame_block> blocks;
    std::vector<std::vector<double>> others;  ///< the columns that complete them
    long log2_scale = 0;                      ///< of the columns of the blocks

    std::size_t size() const { return rates.size(); }
    /// Whether theta_j and theta_{j+1} are conjugate.
    bool begins_pair(std::size_t j) const { return rates[j].imag() > 0; }
    bool ends_pair(std::size_t j) const { return rates[j].imag() < 0; }
};
/// The eigenvalues with real part below minus a thousandth of the largest one, at most so many, the fastest of them.
/// Empty if that would separate a pair, or eigenvalues that nearly have the same real part. Eigenvalues that differ by
/// less than 2% of the slowest rate are in one block, in which the matrix is triangular with small entries.
frame_plan stable_plan(const jet_matrix& linear, std::size_t most = static_cast<std::size_t>(-1));

}  // namespace libration::ode
