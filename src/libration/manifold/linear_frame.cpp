#include "linear_frame.hpp"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "libration/algebra/ball_matrix.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "linear_steps.hpp"

namespace libration::ode {

namespace {

constexpr double least_gap = 1e-3;
constexpr double worst_condition = 1e5;
constexpr int most_eigenvector_steps = 40;
constexpr int most_eigenvector_boxes = 12;

Eigen::MatrixXd midpoints(const jet_matrix& a) {
    const auto size = static_cast<Eigen::Index>(a.size());
    Eigen::MatrixXd result(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j < size; ++j) {
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

// The eigenvectors of the other eigenvalues if they are well-conditioned, otherwise an orthonormal complement.
void complete(frame_plan& plan, const Eigen::EigenSolver<Eigen::MatrixXd>& eigen, const std::vector<bool>& taken) {
    const Eigen::Index size = eigen.eigenvalues().size();
    const auto first = static_cast<Eigen::Index>(plan.size());
    Eigen::MatrixXd q(size, size);
    for (Eigen::Index j = 0; j < first; ++j) {
        const std::size_t of = static_cast<std::size_t>(plan.ends_pair(static_cast<std::size_t>(j)) ? j - 1 : j);
        for (Eigen::Index i = 0; i < size; ++i) {
            const auto entry = plan.vectors[of][static_cast<std::size_t>(i)];
            q(i, j) = static_cast<Eigen::Index>(of) == j ? entry.real() : entry.imag();
        }
        q.col(j) /= q.col(j).norm();
    }
    Eigen::MatrixXd other = q;
    Eigen::Index next = first;
    for (Eigen::Index j = 0; j < size; ++j) {
        if (!taken[static_cast<std::size_t>(j)]) {
            const bool second = eigen.eigenvalues()(j).imag() < 0;
            other.col(next) = second ? Eigen::VectorXd(eigen.eigenvectors().col(j).imag())
                                     : Eigen::VectorXd(eigen.eigenvectors().col(j).real());
            ++next;
        }
    }
    if (!other.allFinite() || condition_of(other) > worst_condition) {
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(q.leftCols(first));
        const Eigen::MatrixXd whole = qr.householderQ();
        other.rightCols(size - first) = whole.rightCols(size - first);
    }
    for (Eigen::Index j = first; j < size; ++j) {
        auto& column = plan.others.emplace_back();
        for (Eigen::Index i = 0; i < size; ++i) {
            column.push_back(other(i, j));
        }
    }
}

complex_jet midpoint_jet(const complex_jet& x) {
    return complex_ball(exact_midpoint(x.value.re), exact_midpoint(x.value.im));
}

complex_jet without_slopes(const complex_jet& x) { return x.value; }

// A v = d v with v = 1 at the pivot, where z has d in its place.
class eigenpair {
public:
    eigenpair(const jet_matrix& a, std::size_t pivot) : a_(a), pivot_(pivot) {}

    std::vector<complex_jet> value(const std::vector<complex_jet>& z) const {
        std::vector<complex_jet> v = vector_of(z);
        std::vector<complex_jet> result = product(a_, v);
        for (std::size_t i = 0; i < v.size(); ++i) {
            result[i].add_product(-z[pivot_], v[i]);
        }
        return result;
    }
    jet_matrix derivative(const std::vector<complex_jet>& z) const {
        const std::vector<complex_jet> v = vector_of(z);
        jet_matrix result = a_;
        for (std::size_t i = 0; i < v.size(); ++i) {
            for (complex_jet& each : result[i]) {
                each = without_slopes(each);
            }
            result[i][i] -= z[pivot_];
            result[i][pivot_] = -v[i];
        }
        return result;
    }
    std::vector<complex_jet> vector_of(std::vector<complex_jet> z) const {
        z[pivot_] = real_jet(ball(1));
        return z;
    }
    std::optional<std::vector<complex_jet>> enclosed(std::vector<complex_jet> z) const {
        if (!improve(z)) {
            return std::nullopt;
        }
        const auto near = inverse(derivative(z));
        if (!near) {
            return std::nullopt;
        }
        jet_matrix by = *near;
        for (auto& row : by) {
            std::ranges::transform(row, row.begin(), midpoint_jet);
        }
        std::vector<complex_jet> step = product(by, value(z));
        std::vector<magnitude> radii;
        for (complex_jet& each : step) {
            each = without_slopes(each);
            radii.push_back(size_of_complex(each.value).shifted(2) + magnitude::of(1, -2 * ball::working_bits()));
        }
        for (int k = 0; k < most_eigenvector_boxes; ++k) {
            if (auto found = in_box(z, by, step, radii)) {
                return with_slopes(*std::move(found));
            }
            for (magnitude& each : radii) {
                each = each.shifted(2);
            }
        }
        return std::nullopt;
    }

private:
    bool improve(std::vector<complex_jet>& z) const {
        magnitude last;
        for (int k = 0; k < most_eigenvector_steps; ++k) {
            const auto by = inverse(derivative(z));
            if (!by) {
                return k > 0;
            }
            const auto step = product(*by, value(z));
            magnitude size;
            for (std::size_t i = 0; i < z.size(); ++i) {
                const complex_jet now = midpoint_jet(step[i]);
                size = std::max(size, size_of_complex(now.value));
                z[i] = midpoint_jet(z[i] - now);
            }
            if (size.is_zero() || (k > 2 && !(size.shifted(1) < last)) || !size.is_finite()) {
                break;
            }
            last = size;
        }
        return true;
    }

    std::optional<std::vector<complex_jet>> in_box(const std::vector<complex_jet>& z, const jet_matrix& by,
                                                   const std::vector<complex_jet>& step,
                                                   const std::vector<magnitude>& radii) const {
        std::vector<complex_jet> box = z;
        for (std::size_t i = 0; i < z.size(); ++i) {
            box[i] = complex_ball(widened(z[i].value.re, radii[i]), widened(z[i].value.im, radii[i]));
        }
        const jet_matrix rest = product(by, derivative(box));
        std::vector<complex_jet> found;
        for (std::size_t i = 0; i < z.size(); ++i) {
            magnitude reach;
            for (std::size_t j = 0; j < z.size(); ++j) {
                const complex_ball entry = complex_ball(ball(i == j ? 1 : 0), ball(0)) - rest[i][j].value;
                reach.add_product(size_of_complex(entry), radii[j]);
            }
            if (!(size_of_complex(step[i].value) + reach < radii[i])) {
                return std::nullopt;
            }
            const complex_ball at = z[i].value - step[i].value;
            found.emplace_back(complex_ball(widened(at.re, reach), widened(at.im, reach)));
        }
        return found;
    }

    std::optional<std::vector<complex_jet>> with_slopes(std::vector<complex_jet> z) const {
        const auto by = inverse(derivative(z));
        if (!by) {
            return std::nullopt;
        }
        const auto change = product(*by, value(z));  // the slopes of A alone
        for (std::size_t i = 0; i < z.size(); ++i) {
            for (const complex_ball& each : change[i].slopes) {
                z[i].slopes.push_back(-each);
            }
        }
        return z;
    }

    const jet_matrix& a_;
    std::size_t pivot_;
};

}  // namespace

frame_plan stable_plan(const jet_matrix& linear, std::size_t most) {
    const Eigen::EigenSolver<Eigen::MatrixXd> eigen(midpoints(linear));
    const auto& values = eigen.eigenvalues();
    frame_plan plan;
    std::vector<bool> taken(static_cast<std::size_t>(values.size()));
    const double gap = least_gap * values.real().cwiseAbs().maxCoeff();
    std::vector<double> parts(taken.size());
    for (std::size_t j = 0; j < parts.size(); ++j) {
        parts[j] = values(static_cast<Eigen::Index>(j)).real();
    }
    std::ranges::sort(parts);
    double below = -gap;
    if (most < parts.size() && most > 0) {
        const double between = (parts[most - 1] + parts[most]) / 2;
        if (between < below && parts[most] - parts[most - 1] < gap) {
            return plan;
        }
        below = std::min(below, between);
    }
    for (const bool real : {true, false}) {
        for (Eigen::Index j = 0; j < values.size(); ++j) {
            if (!(values(j).real() < below) || (values(j).imag() == 0) != real) {
                continue;
            }
            taken[static_cast<std::size_t>(j)] = true;
            Eigen::Index pivot = 0;
            const Eigen::VectorXcd column = eigen.eigenvectors().col(j);
            column.cwiseAbs().maxCoeff(&pivot);
            plan.rates.push_back(values(j));
            plan.pivots.push_back(plan.ends_pair(plan.size() - 1) ? plan.pivots.back()
                                                                  : static_cast<std::size_t>(pivot));
            auto& vector = plan.vectors.emplace_back();
            for (Eigen::Index i = 0; i < values.size(); ++i) {
                vector.push_back(column(i) / column(static_cast<Eigen::Index>(plan.pivots.back())));
            }
        }
    }
    if (plan.size() > 0) {
        complete(plan, eigen, taken);
    }
    return plan;
}

std::optional<linear_frame> enclosed_frame(const jet_matrix& linear, const frame_plan& plan) {
    const std::size_t size = linear.size();
    linear_frame result{jet_matrix(size, std::vector<complex_jet>(size)), {}};
    const complex_jet scale = real_jet(magnitude::of(1, plan.log2_scale).exact());
    for (std::size_t j = 0; j < plan.size(); ++j) {
        if (plan.ends_pair(j)) {
            result.rates.push_back(conjugate(result.rates.back()));
            for (std::size_t i = 0; i < size; ++i) {
                result.columns[i][j] = conjugate(result.columns[i][j - 1]);
            }
            continue;
        }
        std::vector<complex_jet> z;
        for (const auto& each : plan.vectors[j]) {
            z.emplace_back(complex_ball(exactly(each.real()), exactly(each.imag())));
        }
        z[plan.pivots[j]] = complex_ball(exactly(plan.rates[j].real()), exactly(plan.rates[j].imag()));
        const eigenpair pair(linear, plan.pivots[j]);
        const auto found = pair.enclosed(z);
        if (!found) {
            return std::nullopt;
        }
        result.rates.push_back((*found)[plan.pivots[j]]);
        const auto column = pair.vector_of(*found);
        for (std::size_t i = 0; i < size; ++i) {
            result.columns[i][j] = column[i] * scale;
        }
    }
    for (std::size_t j = plan.size(); j < size; ++j) {
        for (std::size_t i = 0; i < size; ++i) {
            result.columns[i][j] = real_jet(exactly(plan.others[j - plan.size()][i]));
        }
    }
    return result;
}

}  // namespace libration::ode
