#include "dense_matrix.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libration/scalar/ball/predicates.hpp"

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

namespace libration::ode {

dense_matrix dense_matrix::unit(std::size_t size) {
    dense_matrix result(size, size);
    for (std::size_t i = 0; i < size; ++i) {
        result(i, i) = ball(1);
    }
    return result;
}

std::vector<ball> dense_matrix::column(std::size_t j) const {
    std::vector<ball> result;
    for (std::size_t i = 0; i < rows; ++i) {
        result.push_back((*this)(i, j));
    }
    return result;
}

void dense_matrix::set_column(std::size_t j, const std::vector<ball>& values) {
    for (std::size_t i = 0; i < rows; ++i) {
        (*this)(i, j) = values[i];
    }
}

void dense_matrix::keep_midpoints() {
    for (ball& each : entries) {
        mag_zero(arb_radref(each.handle()));
    }
}

magnitude dense_matrix::largest() const {
    magnitude result;
    for (const ball& each : entries) {
        result = std::max(result, magnitude(each));
    }
    return result;
}

dense_matrix product(const dense_matrix& a, const dense_matrix& b) {
    dense_matrix result(a.rows, b.columns);
    const int step = static_cast<int>(b.columns);
    for (std::size_t i = 0; i < a.rows; ++i) {
        for (std::size_t j = 0; j < b.columns; ++j) {
            result(i, j) =
                inner_product(&a.entries[i * a.columns], 1, &b.entries[j], step, static_cast<int>(a.columns));
        }
    }
    return result;
}

std::vector<ball> product(const dense_matrix& a, const std::vector<ball>& x) {
    std::vector<ball> result;
    for (std::size_t i = 0; i < a.rows; ++i) {
        result.push_back(inner_product(&a.entries[i * a.columns], 1, x.data(), 1, static_cast<int>(a.columns)));
    }
    return result;
}

std::optional<dense_matrix> inverse(const dense_matrix& a) {
    const auto size = static_cast<slong>(a.rows);
    arb_mat_t of;
    arb_mat_t result;
    arb_mat_init(of, size, size);
    arb_mat_init(result, size, size);
    for (slong i = 0; i < size; ++i) {
        for (slong j = 0; j < size; ++j) {
            arb_set(arb_mat_entry(of, i, j), a(static_cast<std::size_t>(i), static_cast<std::size_t>(j)).handle());
        }
    }
    std::optional<dense_matrix> found;
    if (arb_mat_inv(result, of, ball::working_bits()) != 0) {
        found.emplace(a.rows, a.rows);
        for (slong i = 0; i < size; ++i) {
            for (slong j = 0; j < size; ++j) {
                arb_swap((*found)(static_cast<std::size_t>(i), static_cast<std::size_t>(j)).handle(),
                         arb_mat_entry(result, i, j));
            }
        }
    }
    arb_mat_clear(of);
    arb_mat_clear(result);
    if (found && !std::ranges::all_of(found->entries, [](const ball& each) { return is_finite(each); })) {
        return std::nullopt;
    }
    return found;
}

dense_matrix beside(const dense_matrix& a, const dense_matrix& b) {
    const std::size_t rows = std::max(a.rows, b.rows);
    dense_matrix result(rows, a.columns + b.columns);
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < a.columns; ++j) {
            result(i, j) = a(i, j);
        }
        for (std::size_t j = 0; j < b.columns; ++j) {
            result(i, a.columns + j) = b(i, j);
        }
    }
    return result;
}

double as_double(const ball& x) { return arf_get_d(arb_midref(x.handle()), ARF_RND_NEAR); }

long double as_long_double(const ball& x) {
    const double first = as_double(x);
    if (!std::isfinite(first)) {
        return static_cast<long double>(first);
    }
    ball rest;
    arf_set_d(arb_midref(rest.handle()), first);
    arf_sub(arb_midref(rest.handle()), arb_midref(x.handle()), arb_midref(rest.handle()), 64, ARF_RND_DOWN);
    return static_cast<long double>(first) + static_cast<long double>(as_double(rest));
}

ball exactly(double x) {
    ball result;
    arb_set_d(result.handle(), x);
    return result;
}

ball exactly(long double x) {
    const auto first = static_cast<double>(x);
    ball result;
    arf_set_d(arb_midref(result.handle()), first);
    ball rest;
    arf_set_d(arb_midref(rest.handle()), static_cast<double>(x - static_cast<long double>(first)));
    arb_add(result.handle(), result.handle(), rest.handle(), ARF_PREC_EXACT);
    return result;
}

template <class Real>
struct real_lu<Real>::parts {
    using matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::PartialPivLU<matrix> lu;
    std::vector<Real> scales;
};

template <class Real>
real_lu<Real>::real_lu() : parts_(std::make_unique<parts>()) {}
template <class Real>
real_lu<Real>::real_lu(real_lu&&) noexcept = default;
template <class Real>
real_lu<Real>& real_lu<Real>::operator=(real_lu&&) noexcept = default;
template <class Real>
real_lu<Real>::~real_lu() = default;

template <class Real>
bool real_lu<Real>::factor(const std::vector<Real>& by_rows, std::size_t size) {
    const auto n = static_cast<Eigen::Index>(size);
    typename parts::matrix a = Eigen::Map<const typename parts::matrix>(by_rows.data(), n, n);
    parts_->scales.resize(size);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Real largest = a.row(i).cwiseAbs().maxCoeff();
        if (!(largest > 0) || !std::isfinite(largest)) {
            return false;
        }
        parts_->scales[static_cast<std::size_t>(i)] = 1 / largest;
        a.row(i) /= largest;
    }
    parts_->lu.compute(a);
    const auto pivots = parts_->lu.matrixLU().diagonal();
    return pivots.allFinite() && (pivots.array() != 0).all();
}

template <class Real>
std::vector<Real> real_lu<Real>::solved(const std::vector<Real>& right, std::size_t columns) const {
    const auto rows = static_cast<Eigen::Index>(parts_->scales.size());
    const auto width = static_cast<Eigen::Index>(columns);
    typename parts::matrix b = Eigen::Map<const typename parts::matrix>(right.data(), rows, width);
    for (Eigen::Index i = 0; i < rows; ++i) {
        b.row(i) *= parts_->scales[static_cast<std::size_t>(i)];
    }
    const typename parts::matrix x = parts_->lu.solve(b);
    return {x.data(), x.data() + rows * width};
}

template class real_lu<double>;
template class real_lu<long double>;

}  // namespace libration::ode
