// Matrices of upper bounds by rows, and norms of their blocks.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

using bound_matrix = std::vector<magnitude>;

/// Rows or columns that are bounded jointly, in the Euclidean norm.
struct column_block {
    std::size_t begin, size;
};

inline bound_matrix sum_of_bounds(bound_matrix a, const bound_matrix& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        a[k] += b[k];
    }
    return a;
}

/// Of a, size by size, and b, size by width.
inline bound_matrix product_of_bounds(const bound_matrix& a, const bound_matrix& b, std::size_t size,
                                      std::size_t width) {
    bound_matrix result(size * width);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            if (a[i * size + k].is_zero()) {
                continue;
            }
            for (std::size_t j = 0; j < width; ++j) {
                result[i * width + j].add_product(a[i * size + k], b[k * width + j]);
            }
        }
    }
    return result;
}

inline std::vector<column_block> blocks_of(const std::vector<std::size_t>& sizes) {
    std::vector<column_block> result;
    std::size_t begin = 0;
    for (const std::size_t each : sizes) {
        result.push_back({begin, each});
        begin += each;
    }
    return result;
}

/// At least the Euclidean norm of a part of a vector, and of a block of a matrix.
inline magnitude norm_of(const magnitude* values, column_block rows) {
    magnitude result = values[rows.begin];
    for (std::size_t i = 1; i < rows.size; ++i) {
        result = hypotenuse(result, values[rows.begin + i]);
    }
    return result;
}
inline magnitude norm_of(const bound_matrix& a, std::size_t width, column_block rows, column_block columns) {
    magnitude result;
    for (std::size_t i = 0; i < rows.size; ++i) {
        const magnitude row = norm_of(&a[(rows.begin + i) * width], columns);
        result = rows.size == 1 ? row : hypotenuse(result, row);
    }
    return result;
}

}  // namespace libration::ode
