#include "surd_matrix.hpp"

#include <algorithm>

namespace libration::ode {

std::vector<std::size_t> reduce_rows(surd_matrix& a, std::size_t columns) {
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < columns && pivots.size() < a.size(); ++column) {
        const std::size_t row = pivots.size();
        std::size_t from = row;
        while (from < a.size() && a[from][column].is_zero()) {
            ++from;
        }
        if (from == a.size()) {
            continue;
        }
        std::swap(a[row], a[from]);
        const quadratic_number pivot = a[row][column];
        for (quadratic_number& each : a[row]) {
            each = each / pivot;
        }
        for (std::size_t i = 0; i < a.size(); ++i) {
            const quadratic_number factor = a[i][column];
            for (std::size_t k = 0; i != row && !factor.is_zero() && k < a[i].size(); ++k) {
                a[i][k] = a[i][k] - factor * a[row][k];
            }
        }
        pivots.push_back(column);
    }
    return pivots;
}

std::vector<std::vector<quadratic_number>> null_space(surd_matrix a, std::size_t columns) {
    const auto pivots = reduce_rows(a, columns);
    std::vector<std::vector<quadratic_number>> basis;
    for (std::size_t column = 0; column < columns; ++column) {
        if (std::ranges::find(pivots, column) != pivots.end()) {
            continue;
        }
        std::vector<quadratic_number> x(columns);
        x[column] = quadratic_number(rational(1));
        for (std::size_t row = 0; row < pivots.size(); ++row) {
            x[pivots[row]] = quadratic_number() - a[row][column];
        }
        basis.push_back(std::move(x));
    }
    return basis;
}

surd_matrix inverse_of(const surd_matrix& a) {
    surd_matrix both = a;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both[i].resize(2 * a.size());
        both[i][a.size() + i] = quadratic_number(rational(1));
    }
    reduce_rows(both, a.size());
    surd_matrix result;
    for (const auto& row : both) {
        result.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(a.size()), row.end());
    }
    return result;
}

rational_polynomial characteristic_of(const std::vector<std::vector<rational>>& k) {
    const std::size_t n = k.size();
    std::vector<rational> c(n + 1);
    c[n] = 1;
    std::vector<std::vector<rational>> power(n, std::vector<rational>(n));
    for (std::size_t step = 1; step <= n; ++step) {
        std::vector<std::vector<rational>> next(n, std::vector<rational>(n));
        for (std::size_t i = 0; i < n; ++i) {
            power[i][i] += c[n - step + 1];
        }
        rational trace = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t l = 0; l < n; ++l) {
                    next[i][j] += k[i][l] * power[l][j];
                }
            }
            trace += next[i][i];
        }
        c[n - step] = -trace / static_cast<int>(step);
        power = std::move(next);
    }
    return rational_polynomial(std::move(c));
}

std::optional<rational> rational_root(const rational& x) {
    if (x < 0) {
        return std::nullopt;
    }
    const integer a = sqrt(numerator(x));
    const integer b = sqrt(denominator(x));
    const rational root(a, b);
    return root * root == x ? std::optional(root) : std::nullopt;
}

}  // namespace libration::ode
