// Matrices of balls by rows, and factorisations in double and long double for approximate solutions, on which no proof
// depends.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"
#include "libration/scalar/inner_product.hpp"

namespace libration::ode {

struct dense_matrix {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<ball> entries;

    dense_matrix() = default;
    dense_matrix(std::size_t r, std::size_t c) : rows(r), columns(c), entries(r * c) {}
    dense_matrix(std::size_t r, std::size_t c, std::vector<ball> by_rows)
        : rows(r), columns(c), entries(std::move(by_rows)) {}
    static dense_matrix unit(std::size_t size);

    ball& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
    const ball& operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
    std::vector<ball> column(std::size_t j) const;
    void set_column(std::size_t j, const std::vector<ball>& values);
    /// Rounds every entry to its midpoint.
    void keep_midpoints();
    /// A bound of all |entries|.
    magnitude largest() const;
};

/// In the working precision; sums are rounded once.
dense_matrix product(const dense_matrix& a, const dense_matrix& b);
std::vector<ball> product(const dense_matrix& a, const std::vector<ball>& x);
/// A matrix of balls that contains the inverse of every matrix of `a`; std::nullopt if one of them may be singular.
std::optional<dense_matrix> inverse(const dense_matrix& a);
/// The columns of a followed by those of b.
dense_matrix beside(const dense_matrix& a, const dense_matrix& b);

/// The midpoint as a floating-point number.
double as_double(const ball& x);
long double as_long_double(const ball& x);
/// The floating-point number, exactly; x must be finite.
ball exactly(double x);
ball exactly(long double x);

/// The factorisation with partial pivots of a square matrix of floating-point numbers, by Eigen.
template <class Real>
class real_lu {
public:
    real_lu();
    real_lu(real_lu&&) noexcept;
    real_lu& operator=(real_lu&&) noexcept;
    ~real_lu();
    /// Of a matrix by rows, each row divided by its largest entry. False if it is singular or not finite.
    bool factor(const std::vector<Real>& by_rows, std::size_t size);
    /// For so many right-hand sides, the columns of a matrix by rows.
    std::vector<Real> solved(const std::vector<Real>& right, std::size_t columns = 1) const;

private:
    struct parts;
    std::unique_ptr<parts> parts_;
};

}  // namespace libration::ode
