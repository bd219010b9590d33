#include "newton_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace libration::ode {

namespace {

using long_doubles = std::vector<long double>;

// A product of row operations that makes a matrix upper triangular up to the order of its columns.
long_doubles row_reduction(long_doubles a, std::size_t n) {
    long_doubles by(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        by[i * n + i] = 1;
    }
    for (std::size_t step = 0; step < n; ++step) {
        const auto begin = a.begin() + static_cast<std::ptrdiff_t>(step * n);
        const auto pivot =
            std::max_element(begin, a.end(), [](long double x, long double y) { return std::fabs(x) < std::fabs(y); });
        if (*pivot == 0) {
            break;
        }
        const auto place = static_cast<std::size_t>(pivot - a.begin());
        const std::size_t pivot_column = place % n;
        const auto row_of = [&](long_doubles& of, std::size_t i) {
            return of.begin() + static_cast<std::ptrdiff_t>(i * n);
        };
        for (long_doubles* each : {&a, &by}) {
            std::swap_ranges(row_of(*each, step), row_of(*each, step + 1), row_of(*each, place / n));
        }
        for (std::size_t i = step + 1; i < n; ++i) {
            const long double factor = a[i * n + pivot_column] / a[step * n + pivot_column];
            for (std::size_t j = 0; factor != 0 && j < n; ++j) {
                a[i * n + j] = j == pivot_column ? 0 : a[i * n + j] - factor * a[step * n + j];
                by[i * n + j] -= factor * by[step * n + j];
            }
        }
    }
    return by;
}

}  // namespace

// R times a matrix of so many columns.
std::vector<long double> newton_matrix::reduced(const long double* by_rows, std::size_t columns) const {
    long_doubles result(unknowns_ * columns, 0);
    for (std::size_t i = 0; i < unknowns_; ++i) {
        for (std::size_t k = 0; k < unknowns_; ++k) {
            const long double factor = reduction_[i * unknowns_ + k];
            for (std::size_t j = 0; factor != 0 && j < columns; ++j) {
                result[i * columns + j] += factor * by_rows[k * columns + j];
            }
        }
    }
    return result;
}

bool newton_matrix::factor(const long_doubles& integrals, const long_doubles& jacobians, std::size_t unknowns) {
    if (!std::ranges::all_of(jacobians, [](long double each) { return std::isfinite(each); })) {
        return false;
    }
    unknowns_ = unknowns;
    const std::size_t n = unknowns;
    const std::size_t nodes = jacobians.size() / (n * n);
    const std::size_t width = nodes * n;
    const auto middle = jacobians.begin() + static_cast<std::ptrdiff_t>(nodes / 2 * n * n);
    reduction_ = row_reduction(long_doubles(middle, middle + static_cast<std::ptrdiff_t>(n * n)), n);
    std::vector<double> matrix(width * width, 0);
    for (std::size_t k = 0; k < nodes; ++k) {
        const long_doubles here = reduced(&jacobians[k * n * n], n);
        for (std::size_t a = 0; a < n; ++a) {
            for (std::size_t c = 0; c < n; ++c) {
                const long double entry = here[a * n + c];
                for (std::size_t i = 0; entry != 0 && i < nodes; ++i) {
                    matrix[(i * n + a) * width + k * n + c] = static_cast<double>(-integrals[i * nodes + k] * entry);
                }
                matrix[(k * n + a) * width + k * n + c] =
                    static_cast<double>(reduction_[a * n + c] - integrals[k * nodes + k] * entry);
            }
        }
    }
    return lu_.factor(matrix, width);
}

std::vector<long double> newton_matrix::solved(const long_doubles& right) const {
    std::vector<double> rounded;
    rounded.reserve(right.size());
    for (std::size_t k = 0; k < right.size(); k += unknowns_) {
        for (const long double each : reduced(&right[k], 1)) {
            rounded.push_back(static_cast<double>(each));
        }
    }
    const std::vector<double> solution = lu_.solved(rounded);
    return {solution.begin(), solution.end()};
}

}  // namespace libration::ode
