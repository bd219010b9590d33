#include "fast_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "../../algebra/rounded_matrix.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

namespace libration::ode {

namespace {

constexpr double turns_per_decay = 2;

// Eigenvalues with left (by rows) and right eigenvectors (by columns).
class eigensystem {
public:
    explicit eigensystem(std::size_t size) : size_(static_cast<slong>(size)), values_(_acb_vec_init(size_)) {
        acb_mat_init(left_, size_, size_);
        acb_mat_init(right_, size_, size_);
    }
    eigensystem(const eigensystem&) = delete;
    eigensystem& operator=(const eigensystem&) = delete;
    ~eigensystem() {
        _acb_vec_clear(values_, size_);
        acb_mat_clear(left_);
        acb_mat_clear(right_);
    }

    bool compute(const dense_matrix& of, long bits) {
        if (of.rows >= least_size_in_double) {
            return compute_in_double(of) && acb_mat_approx_inv(left_, right_, bits) != 0;
        }
        acb_mat_t a;
        acb_mat_init(a, size_, size_);
        for (slong i = 0; i < size_; ++i) {
            for (slong j = 0; j < size_; ++j) {
                const ball& entry = of(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
                arf_set(arb_midref(acb_realref(acb_mat_entry(a, i, j))), arb_midref(entry.handle()));
            }
        }
        // The left eigenvectors are the rows of an inverse: acb_mat_approx_eig_qr of Arb 2.23 leaks memory if it
        // computes them.
        const bool done = acb_mat_approx_eig_qr(values_, nullptr, right_, a, nullptr, 0, bits) != 0 &&
                          acb_mat_approx_inv(left_, right_, bits) != 0;
        acb_mat_clear(a);
        return done;
    }
    bool compute_in_double(const dense_matrix& of) {
        const std::vector<double> entries = in_double(of.entries);
        using row_major = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        const Eigen::Map<const row_major> a(entries.data(), size_, size_);
        if (!a.allFinite()) {
            return false;
        }
        const Eigen::EigenSolver<Eigen::MatrixXd> eigen(a);
        if (eigen.info() != Eigen::Success) {
            return false;
        }
        const auto vectors = eigen.eigenvectors();
        for (slong j = 0; j < size_; ++j) {
            acb_set_d_d(values_ + j, eigen.eigenvalues()[j].real(), eigen.eigenvalues()[j].imag());
            for (slong i = 0; i < size_; ++i) {
                acb_set_d_d(acb_mat_entry(right_, i, j), vectors(i, j).real(), vectors(i, j).imag());
            }
        }
        return true;
    }
    std::complex<double> value(std::size_t k) const {
        acb_srcptr z = values_ + k;
        return {arf_get_d(arb_midref(acb_realref(z)), ARF_RND_NEAR),
                arf_get_d(arb_midref(acb_imagref(z)), ARF_RND_NEAR)};
    }
    // The real part, and for `pair` the imaginary part, of an eigenvector divided by its largest component.
    void append(ball_columns& to, std::size_t k, bool of_left, bool pair, long bits) const {
        const auto n = static_cast<slong>(k);
        const auto entry = [&](slong i) -> acb_srcptr {
            return of_left ? acb_mat_entry(left_, n, i) : acb_mat_entry(right_, i, n);
        };
        slong largest = 0;
        magnitude most;
        for (slong i = 0; i < size_; ++i) {
            mag_t size;
            mag_init(size);
            acb_get_mag(size, entry(i));
            if (mag_cmp(size, most.handle()) > 0) {
                ball as_ball;
                arf_set_mag(arb_midref(as_ball.handle()), size);
                most = magnitude(as_ball);
                largest = i;
            }
            mag_clear(size);
        }
        std::vector<ball> real;
        std::vector<ball> imaginary;
        acb_t quotient;
        acb_init(quotient);
        for (slong i = 0; i < size_; ++i) {
            acb_div(quotient, entry(i), entry(largest), bits);
            arb_get_mid_arb(real.emplace_back().handle(), acb_realref(quotient));
            arb_get_mid_arb(imaginary.emplace_back().handle(), acb_imagref(quotient));
        }
        acb_clear(quotient);
        to.push_back(std::move(real));
        if (pair) {
            to.push_back(std::move(imaginary));
        }
    }

private:
    slong size_;
    acb_ptr values_;
    acb_mat_t left_{}, right_{};
};

bool is_fast(const std::complex<double>& value, double limit) {
    return value.real() < -limit || (value.real() < limit / 5 && std::fabs(value.imag()) > turns_per_decay * limit);
}

// The position of the largest gap between fast and slow eigenvalues; the gap without fast ones counts up to 3 limits.
double limit_of(const std::vector<std::complex<double>>& values, double slowest_fast) {
    std::vector<double> tried{slowest_fast, 3 * slowest_fast};
    for (const auto& each : values) {
        if (std::abs(each) > slowest_fast && std::abs(each) < 3 * slowest_fast) {
            tried.push_back(std::abs(each) * 1.0001);
        }
    }
    std::ranges::sort(tried);
    double widest = 0;
    double best = slowest_fast;
    for (const double limit : tried) {
        double below = slowest_fast / 3;
        double above = 3 * slowest_fast;
        for (const auto& each : values) {
            (is_fast(each, limit) ? above : below) =
                is_fast(each, limit) ? std::min(above, std::abs(each)) : std::max(below, std::abs(each));
        }
        if (above / below > widest * 1.0001) {
            widest = above / below;
            best = limit;
        }
    }
    return best;
}

magnitude squared_length(const std::vector<ball>& v) {
    magnitude sum;
    for (const ball& each : v) {
        sum.add_product(magnitude(each), magnitude(each));
    }
    return sum;
}

ball along(const std::vector<ball>& a, const std::vector<ball>& b) {
    return midpoint_alone(inner_product(a.data(), 1, b.data(), 1, static_cast<int>(a.size())));
}

void remove(std::vector<ball>& from, const std::vector<ball>& unit) {
    const ball part = along(from, unit);
    for (std::size_t i = 0; i < from.size(); ++i) {
        from[i] = midpoint_alone(from[i] - part * unit[i]);
    }
}

void normalise(std::vector<ball>& v) {
    ball length = midpoint_alone(sqrt(along(v, v)));
    if (contains_zero(length)) {
        length = ball(1);
    }
    for (ball& each : v) {
        each = midpoint_alone(each / length);
    }
}

}  // namespace

void extend_orthonormal(ball_columns& basis, ball_columns candidates, std::size_t count, bool pivots) {
    for (auto& each : candidates) {
        for (const auto& unit : basis) {
            remove(each, unit);
        }
    }
    for (std::size_t k = 0; k < count && !candidates.empty(); ++k) {
        auto longest = candidates.begin();
        if (pivots) {
            longest = std::ranges::max_element(
                candidates, [](const auto& a, const auto& b) { return squared_length(a) < squared_length(b); });
        }
        std::vector<ball> unit = std::move(*longest);
        candidates.erase(longest);
        normalise(unit);
        for (const auto& each : basis) {
            remove(unit, each);
        }
        normalise(unit);
        for (auto& each : candidates) {
            remove(each, unit);
        }
        basis.push_back(std::move(unit));
    }
}

dense_matrix divided_modes::basis() const {
    dense_matrix result(size(), size());
    for (std::size_t k = 0; k < size(); ++k) {
        result.set_column(k, k < slow.size() ? slow[k] : fast[k - slow.size()]);
    }
    return result;
}

std::optional<divided_modes> modes_of(const dense_matrix& j, long bits, double slowest_fast) {
    const std::size_t size = j.rows;
    eigensystem eigen(size);
    if (!eigen.compute(j, bits)) {
        return std::nullopt;
    }
    std::vector<std::complex<double>> values;
    values.reserve(size);
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (const std::size_t k : order) {
        values.push_back(eigen.value(k));
    }
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return std::abs(values[a]) > std::abs(values[b]); });
    const double limit = limit_of(values, slowest_fast);
    divided_modes result;
    ball_columns left;
    for (const std::size_t k : order) {
        const bool pair = std::fabs(values[k].imag()) > 1e-12 * std::abs(values[k]);
        if (is_fast(values[k], limit) && !(pair && values[k].imag() < 0)) {
            eigen.append(result.fast, k, false, pair, bits);
            eigen.append(left, k, true, pair, bits);
            result.fast_blocks.push_back(pair ? 2 : 1);
        }
    }
    ball_columns complement;
    extend_orthonormal(complement, left, left.size(), true);
    ball_columns units;
    for (std::size_t k = 0; k < size; ++k) {
        units.push_back(dense_matrix::unit(size).column(k));
    }
    extend_orthonormal(complement, std::move(units), size - left.size(), true);
    result.slow.assign(complement.begin() + static_cast<std::ptrdiff_t>(left.size()), complement.end());
    const dense_matrix all = result.basis();
    const bool finite = std::ranges::all_of(all.entries, [](const ball& each) { return is_finite(each); });
    return finite && result.size() == size ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace libration::ode
