#include "decay_basis.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "../integration/collocation/fast_modes.hpp"

namespace libration::ode {

namespace {

constexpr long bits_of_modes = 128;
// Eigenvalues with a smaller real part count as those of decaying modes.
constexpr double least_decay = 1e-250;

}  // namespace

std::optional<block_basis> basis_of_eigenvectors(const dense_matrix& of) {
    const auto modes = modes_of(of, bits_of_modes, least_decay);
    if (!modes || !modes->slow.empty()) {
        return std::nullopt;
    }
    return block_basis{modes->basis(), modes->fast_blocks};
}

std::optional<block_basis> scaled_schur_basis(const dense_matrix& of) {
    const auto size = static_cast<Eigen::Index>(of.rows);
    Eigen::MatrixXd a(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j < size; ++j) {
            a(i, j) = as_double(of(static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
        }
    }
    if (!a.allFinite()) {
        return std::nullopt;
    }
    const Eigen::RealSchur<Eigen::MatrixXd> schur(a);
    if (schur.info() != Eigen::Success) {
        return std::nullopt;
    }
    const Eigen::MatrixXd& t = schur.matrixT();
    const double slowest = -t.diagonal().maxCoeff();
    if (!(slowest > 0)) {
        return std::nullopt;
    }
    const double beside = t.cwiseAbs().maxCoeff();
    const double ratio = std::min(0.5, slowest / (4 * static_cast<double>(size) * beside));
    block_basis result{dense_matrix(of.rows, of.rows), {}};
    double scale = 1;
    for (Eigen::Index k = 0; k < size; k += static_cast<Eigen::Index>(result.blocks.back())) {
        const bool pair = k + 1 < size && t(k + 1, k) != 0;
        // A pair has the form a, b; c, a: the quotient of its scales is such that b and c become equally large.
        const double quotient = pair ? std::sqrt(std::fabs(t(k + 1, k) / t(k, k + 1))) : 1;
        const std::array<double, 2> scales{scale * std::min(1., 1 / quotient), scale * std::min(1., quotient)};
        for (Eigen::Index i = 0; i < size; ++i) {
            for (Eigen::Index j = 0; j < (pair ? 2 : 1); ++j) {
                result.columns(static_cast<std::size_t>(i), static_cast<std::size_t>(k + j)) =
                    exactly(schur.matrixU()(i, k + j) * scales[static_cast<std::size_t>(j)]);
            }
        }
        result.blocks.push_back(pair ? 2 : 1);
        scale = std::min(scales[0], scales[1]) * ratio;
    }
    return result;
}

}  // namespace libration::ode
