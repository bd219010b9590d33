#include "rounded_matrix.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace libration::ode {

namespace {

using row_major = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// More than the operations of Eigen add to those of a sum of products.
constexpr std::size_t operations_of_eigen = 3;
// Of one sum of two doubles, which underflow does not change.
constexpr double unit_of_sum = 0x1p-53;

// Upper bounds of the lengths of rows or columns.
std::vector<double> lengths(const rounded_matrix& shape, const std::vector<double>& of, bool by_rows) {
    std::vector<double> result(by_rows ? shape.rows : shape.columns, 0);
    for (std::size_t i = 0; i < shape.rows; ++i) {
        for (std::size_t j = 0; j < shape.columns; ++j) {
            const double x = of[i * shape.columns + j];
            result[by_rows ? i : j] += x * x;
        }
    }
    for (double& each : result) {
        each = upper_bound_of_sum(std::sqrt(upper_bound_of_sum(each)));
    }
    return result;
}

template <class Operation>
rounded_matrix combined(rounded_matrix a, const rounded_matrix& b, Operation operation) {
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        a.values[i] = operation(a.values[i], b.values[i]);
        a.errors[i] = upper_bound_of_sum(a.errors[i] + b.errors[i] + unit_of_sum * std::fabs(a.values[i]));
    }
    return a;
}

}  // namespace

rounded_matrix::rounded_matrix(std::size_t r, std::size_t c, const std::vector<ball>& entries) : rounded_matrix(r, c) {
    ball difference;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        values[i] = as_double(entries[i]);
        if (!std::isfinite(values[i])) {
            errors[i] = HUGE_VAL;
            continue;
        }
        arb_sub(difference.handle(), entries[i].handle(), exactly(values[i]).handle(), MAG_BITS);
        errors[i] = upper_bound_of_sum(magnitude(difference).above());
    }
}

ball rounded_matrix::entry(std::size_t i, std::size_t j) const {
    return widened(exactly(values[i * columns + j]), magnitude::at_least(errors[i * columns + j], 0));
}

dense_matrix rounded_matrix::balls() const {
    dense_matrix result(rows, columns);
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            result(i, j) = entry(i, j);
        }
    }
    return result;
}

rounded_matrix rounded_matrix::part(std::size_t begin, std::size_t count) const {
    rounded_matrix result(count, columns);
    const auto first = static_cast<std::ptrdiff_t>(begin * columns);
    std::copy_n(values.begin() + first, count * columns, result.values.begin());
    std::copy_n(errors.begin() + first, count * columns, result.errors.begin());
    return result;
}

rounded_matrix product(const rounded_matrix& a, const rounded_matrix& b) {
    rounded_matrix result(a.rows, b.columns);
    result.values = product(a.values, b.values, a.rows, b.columns);
    const auto terms = static_cast<double>(a.columns + operations_of_eigen);
    const double relative = terms * 0x1.001p-53;
    const auto rows = lengths(a, a.values, true);
    const auto rows_of_errors = lengths(a, a.errors, true);
    const auto columns = lengths(b, b.values, false);
    const auto columns_of_errors = lengths(b, b.errors, false);
    for (std::size_t i = 0; i < a.rows; ++i) {
        const double of_rounded = upper_bound_of_sum(relative * rows[i] + rows_of_errors[i]);
        const double whole = upper_bound_of_sum(rows[i] + rows_of_errors[i]);
        for (std::size_t j = 0; j < b.columns; ++j) {
            result.errors[i * b.columns + j] =
                upper_bound_of_sum(of_rounded * columns[j] + whole * columns_of_errors[j]);
        }
    }
    return result;
}

rounded_matrix sum(rounded_matrix a, const rounded_matrix& b) {
    return combined(std::move(a), b, [](double x, double y) { return x + y; });
}

rounded_matrix difference(rounded_matrix a, const rounded_matrix& b) {
    return combined(std::move(a), b, [](double x, double y) { return x - y; });
}

std::vector<double> in_double(const std::vector<ball>& entries) {
    std::vector<double> result;
    result.reserve(entries.size());
    for (const ball& each : entries) {
        result.push_back(as_double(each));
    }
    return result;
}

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b, std::size_t rows,
                            std::size_t columns) {
    const auto r = static_cast<Eigen::Index>(rows);
    const auto c = static_cast<Eigen::Index>(columns);
    const auto inner = rows == 0 ? 0 : static_cast<Eigen::Index>(a.size()) / r;
    std::vector<double> result(rows * columns);
    Eigen::Map<row_major>(result.data(), r, c).noalias() =
        Eigen::Map<const row_major>(a.data(), r, inner) * Eigen::Map<const row_major>(b.data(), inner, c);
    return result;
}

}  // namespace libration::ode
