#include "frame_plan.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "../algebra/dense_matrix.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr double least_gap = 1e-3;
constexpr double worst_condition = 1e5;
constexpr double nearly_equal = 0.02;  // of the slowest rate
constexpr double small_entries = 0.05;
constexpr double beside_the_mean = 1e-3;
constexpr int subspace_steps = 60;
constexpr int most_reflections = 5;

using complex_columns = Eigen::MatrixXcd;
using eigen_index = Eigen::Index;

Eigen::MatrixXd midpoints(const jet_matrix& a) {
    const auto size = static_cast<eigen_index>(a.size());
    Eigen::MatrixXd result(size, size);
    for (eigen_index i = 0; i < size; ++i) {
        for (eigen_index j = 0; j < size; ++j) {
            result(i, j) = as_double(a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].value.re);
        }
    }
    return result;
}

double condition_of(const Eigen::MatrixXd& q) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(q);
    const auto& sizes = svd.singularValues();
    return sizes(0) / std::max(sizes(sizes.size() - 1), 1e-300);
}

// Rows as vectors.
std::vector<std::vector<std::complex<double>>> rows_of(const complex_columns& of) {
    std::vector<std::vector<std::complex<double>>> result;
    for (eigen_index i = 0; i < of.rows(); ++i) {
        auto& row = result.emplace_back();
        for (eigen_index j = 0; j < of.cols(); ++j) {
            row.push_back(of(i, j));
        }
    }
    return result;
}

// Schur vectors, so scaled that the triangular form has small entries outside of its diagonal. A pair, which the real form
// leaves as a block of 2, is turned such that both diagonal entries of the block are its real part.
template <class Schur, class Matrix>
complex_columns scaled_schur_vectors(const Matrix& of, double small) {
    const Schur schur(of);
    Matrix columns = schur.matrixU();
    const Matrix& t = schur.matrixT();
    for (eigen_index i = 0; i + 1 < of.rows(); ++i) {
        if (t(i + 1, i) != 0.) {
            const double twice = std::atan2(std::real(t(i + 1, i + 1) - t(i, i)), std::real(t(i, i + 1) + t(i + 1, i)));
            columns.applyOnTheRight(i, i + 1, Eigen::JacobiRotation<double>(std::cos(twice / 2), -std::sin(twice / 2)));
            const Matrix turned = columns.adjoint() * of * columns;
            if (std::abs(turned(i, i + 1)) < std::abs(turned(i + 1, i))) {
                columns.col(i).swap(columns.col(i + 1));
            }
        }
    }
    const Matrix triangular = columns.adjoint() * of * columns;
    const double largest =
        triangular.template triangularView<Eigen::StrictlyUpper>().toDenseMatrix().cwiseAbs().maxCoeff();
    const double ratio = std::min(1., small / largest);
    for (eigen_index j = 1; j < of.cols(); ++j) {
        columns.col(j) *= std::pow(ratio, static_cast<double>(j));
    }
    return columns.template cast<std::complex<double>>();
}

// Groups of eigenvalues, by the indices of all, of which none is near to one of another group.
std::vector<std::vector<eigen_index>> groups_of(const Eigen::VectorXcd& values, std::vector<eigen_index> left,
                                                double near) {
    std::vector<std::vector<eigen_index>> result;
    while (!left.empty()) {
        auto& group = result.emplace_back(1, left.front());
        left.erase(left.begin());
        for (std::size_t k = 0; k < group.size(); ++k) {
            const auto value = values(group[k]);
            const auto rest = std::stable_partition(left.begin(), left.end(),
                                                    [&](eigen_index j) { return std::abs(values(j) - value) >= near; });
            group.insert(group.end(), rest, left.end());
            left.erase(rest, left.end());
        }
    }
    return result;
}

struct eigenvectors {
    Eigen::VectorXcd values;
    complex_columns vectors;
};

// The QR algorithm of Eigen does not converge for some matrices with multiple eigenvalues, but it does for reflected ones.
eigenvectors eigenvectors_of(const Eigen::MatrixXd& a) {
    Eigen::MatrixXd reflection = Eigen::MatrixXd::Identity(a.rows(), a.cols());
    for (int k = 0; k < most_reflections; ++k) {
        const Eigen::EigenSolver<Eigen::MatrixXd> eigen(reflection * a * reflection);
        if (eigen.info() == Eigen::Success) {
            return {eigen.eigenvalues(), reflection.cast<std::complex<double>>() * eigen.eigenvectors()};
        }
        Eigen::VectorXd direction(a.rows());
        for (eigen_index i = 0; i < a.rows(); ++i) {
            direction(i) = std::cos(static_cast<double>((k + 1) * (i + 1)));  // in general position
        }
        direction.normalize();
        reflection = Eigen::MatrixXd::Identity(a.rows(), a.cols()) - 2 * direction * direction.transpose();
    }
    throw error(
        error_kind::undecided, error_subject::problem, "",
        "has an equilibrium at these limits whose eigenvalues are not found: the QR algorithm does not converge");
}

class plan_of_eigenvalues {
public:
    plan_of_eigenvalues(const Eigen::MatrixXd& a, const eigenvectors& eigen, const std::vector<bool>& taken)
        : a_(a), eigen_(eigen), taken_(taken) {}

    frame_plan result() {
        std::vector<eigen_index> left;
        double slowest = INFINITY;
        for (eigen_index j = 0; j < values().size(); ++j) {
            if (taken_[static_cast<std::size_t>(j)]) {
                left.push_back(j);
                slowest = std::min(slowest, -values()(j).real());
            }
        }
        slowest_ = slowest;
        const auto groups = groups_of(values(), left, nearly_equal * slowest);
        for (const bool real : {true, false}) {
            for (const auto& group : groups) {
                std::complex<double> mean;
                for (const eigen_index j : group) {
                    mean += values()(j) / static_cast<double>(group.size());
                }
                const bool is_real = std::ranges::any_of(group, [&](eigen_index j) {
                    return std::ranges::any_of(group,
                                               [&](eigen_index i) { return values()(i) == std::conj(values()(j)); });
                });
                if (is_real == real && (real || mean.imag() > 0)) {
                    add(group, real ? mean.real() : mean);
                }
            }
        }
        if (plan_.size() > 0) {
            complete();
        }
        return std::move(plan_);
    }

private:
    const Eigen::VectorXcd& values() const { return eigen_.values; }

    void add(const std::vector<eigen_index>& group, std::complex<double> mean) {
        frame_block block;
        for (std::size_t k = 0; k < group.size(); ++k) {
            block.columns.push_back(plan_.rates.size());
            plan_.rates.push_back(mean);
            if (mean.imag() > 0) {
                plan_.rates.push_back(std::conj(mean));
            }
        }
        const complex_columns space = group.size() == 1 ? complex_columns(eigen_.vectors.col(group.front()))
                                                        : subspace_at(mean, static_cast<eigen_index>(group.size()));
        const Eigen::ColPivHouseholderQR<complex_columns> qr(space.adjoint());
        complex_columns in_pivots(space.cols(), space.cols());
        for (eigen_index k = 0; k < space.cols(); ++k) {
            const eigen_index row = qr.colsPermutation().indices()(k);
            block.pivots.push_back(static_cast<std::size_t>(row));
            in_pivots.row(k) = space.row(row);
        }
        complex_columns basis = space * in_pivots.inverse();
        if (mean.imag() == 0) {
            basis = basis.real().eval().cast<std::complex<double>>();
        }
        const complex_columns mixture = mixture_of(block, basis, mean);
        block.basis = rows_of(basis.transpose());
        block.mixture = rows_of(mixture);
        const complex_columns columns = basis * mixture;
        for (eigen_index k = 0; k < columns.cols(); ++k) {
            columns_.emplace_back(columns.col(k).real());
            if (mean.imag() != 0) {
                columns_.emplace_back(columns.col(k).imag());
            }
        }
        plan_.blocks.push_back(std::move(block));
    }

    // The invariant subspace of the eigenvalues near a number, by inverse iteration.
    complex_columns subspace_at(std::complex<double> mean, eigen_index size) const {
        const complex_columns shifted =
            a_.cast<std::complex<double>>() -
            (mean + beside_the_mean * slowest_) * complex_columns::Identity(a_.rows(), a_.cols());
        const Eigen::FullPivLU<complex_columns> lu(shifted);
        complex_columns space(a_.rows(), size);
        for (eigen_index i = 0; i < space.rows(); ++i) {
            for (eigen_index j = 0; j < size; ++j) {
                space(i, j) = std::cos(static_cast<double>(1 + i + i * j + 3 * j * j));  // in general position
            }
        }
        for (int k = 0; k < subspace_steps; ++k) {
            const Eigen::HouseholderQR<complex_columns> qr(lu.solve(space));
            space = qr.householderQ() * complex_columns::Identity(a_.rows(), size);
        }
        return space;
    }

    complex_columns mixture_of(const frame_block& block, const complex_columns& basis,
                               std::complex<double> mean) const {
        const eigen_index size = basis.cols();
        const complex_columns image = a_.cast<std::complex<double>>() * basis;
        complex_columns inner(size, size);
        for (eigen_index k = 0; k < size; ++k) {
            inner.row(k) = image.row(static_cast<eigen_index>(block.pivots[static_cast<std::size_t>(k)]));
        }
        const complex_columns unit = complex_columns::Identity(size, size);
        const double small = small_entries * slowest_ / static_cast<double>(size);
        if ((inner - mean * unit).cwiseAbs().maxCoeff() < small) {
            return unit;
        }
        return mean.imag() == 0
                   ? scaled_schur_vectors<Eigen::RealSchur<Eigen::MatrixXd>>(Eigen::MatrixXd(inner.real()), small)
                   : scaled_schur_vectors<Eigen::ComplexSchur<complex_columns>>(inner, small);
    }

    // The eigenvectors of the other eigenvalues if they are well-conditioned, otherwise an orthonormal complement.
    void complete() {
        const eigen_index size = a_.rows();
        const auto first = static_cast<eigen_index>(plan_.size());
        Eigen::MatrixXd q(size, size);
        for (eigen_index j = 0; j < first; ++j) {
            q.col(j) = columns_[static_cast<std::size_t>(j)].normalized();
        }
        Eigen::MatrixXd other = q;
        eigen_index next = first;
        for (eigen_index j = 0; j < size; ++j) {
            if (!taken_[static_cast<std::size_t>(j)]) {
                const bool second = values()(j).imag() < 0;
                other.col(next) = second ? Eigen::VectorXd(eigen_.vectors.col(j).imag())
                                         : Eigen::VectorXd(eigen_.vectors.col(j).real());
                ++next;
            }
        }
        if (!other.allFinite() || condition_of(other) > worst_condition) {
            const Eigen::HouseholderQR<Eigen::MatrixXd> qr(q.leftCols(first));
            const Eigen::MatrixXd whole = qr.householderQ();
            other.rightCols(size - first) = whole.rightCols(size - first);
        }
        for (eigen_index j = first; j < size; ++j) {
            auto& column = plan_.others.emplace_back();
            for (eigen_index i = 0; i < size; ++i) {
                column.push_back(other(i, j));
            }
        }
    }

    const Eigen::MatrixXd& a_;
    const eigenvectors& eigen_;
    const std::vector<bool>& taken_;
    double slowest_ = 0;
    frame_plan plan_;
    std::vector<Eigen::VectorXd> columns_;  // real and imaginary parts
};

}  // namespace

frame_plan stable_plan(const jet_matrix& linear, std::size_t most) {
    const Eigen::MatrixXd a = midpoints(linear);
    const eigenvectors eigen = eigenvectors_of(a);
    const Eigen::VectorXd parts = eigen.values.real();
    const double gap = least_gap * parts.cwiseAbs().maxCoeff();
    std::vector<double> sorted(parts.begin(), parts.end());
    std::ranges::sort(sorted);
    double below = -gap;
    if (most < sorted.size() && most > 0) {
        const double between = (sorted[most - 1] + sorted[most]) / 2;
        if (between < below && sorted[most] - sorted[most - 1] < gap) {
            return {};
        }
        below = std::min(below, between);
    }
    std::vector<bool> taken;
    for (const double part : parts) {
        taken.push_back(part < below);
    }
    return plan_of_eigenvalues(a, eigen, taken).result();
}

}  // namespace libration::ode
