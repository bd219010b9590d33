#include "linear_invariance.hpp"

#include <flint/fmpq_mat.h>

#include <utility>

#include "first_integrals.hpp"
#include "power_sum.hpp"

namespace libration::ode {

namespace {

// df_i/dy_j.
std::vector<std::vector<expression>> jacobian_of(const first_order_form& of) {
    std::vector<std::vector<expression>> result;
    for (const expression& slope : of.slopes) {
        auto& row = result.emplace_back();
        for (const expression& leaf : of.leaves) {
            row.push_back(partial(slope, leaf));
        }
    }
    return result;
}

// Whether sum_k r_k K_k is regular for fixed fractions r_k, which shows that the span contains a regular matrix.
bool spans_regular_matrix(const std::vector<std::vector<rational>>& kernel,
                          const std::vector<std::pair<std::size_t, std::size_t>>& places, std::size_t n) {
    fmpq_mat_t matrix;
    fmpq_mat_init(matrix, static_cast<slong>(n), static_cast<slong>(n));
    for (std::size_t p = 0; p < places.size(); ++p) {
        rational sum = 0;
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            sum += kernel[k][p] * rational(static_cast<long>(k * k + 3 * k + 1), static_cast<long>(k + 2));
        }
        const auto i = static_cast<slong>(places[p].first);
        const auto j = static_cast<slong>(places[p].second);
        fmpq_set_mpq(fmpq_mat_entry(matrix, i, j), sum.backend().data());
        fmpq_neg(fmpq_mat_entry(matrix, j, i), fmpq_mat_entry(matrix, i, j));
    }
    fmpq_t determinant;
    fmpq_init(determinant);
    fmpq_mat_det(determinant, matrix);
    const bool regular = fmpq_is_zero(determinant) == 0;
    fmpq_clear(determinant);
    fmpq_mat_clear(matrix);
    return regular;
}

}  // namespace

std::vector<std::vector<expression>> affine_symmetries_of(const first_order_form& of) {
    const std::size_t n = of.leaves.size();
    if (of.leaves.size() > most_unknowns_with_integrals) {
        return {};
    }
    try {
        power_sums sums;
        const auto jacobian = jacobian_of(of);
        std::vector<std::vector<power_sum>> rows;  // of A_ij, then of b_i
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j <= n; ++j) {
                auto& row = rows.emplace_back();
                for (std::size_t k = 0; k < n; ++k) {
                    expression entry = j < n ? jacobian[k][i] * of.leaves[j] : jacobian[k][i];
                    row.push_back(sums.of(k == i && j < n ? entry - of.slopes[j] : entry));
                }
            }
        }
        std::vector<std::vector<expression>> result;
        for (const auto& factors : sums.relations(rows)) {
            auto& field = result.emplace_back();
            for (std::size_t i = 0; i < n; ++i) {
                expression component;
                for (std::size_t j = 0; j <= n; ++j) {
                    component =
                        component + expression(factors[i * (n + 1) + j]) * (j < n ? of.leaves[j] : expression(1));
                }
                field.push_back(component);
            }
        }
        return result;
    } catch (const no_power_sum&) {
        return {};
    }
}

bool is_symplectic(const first_order_form& of) {
    const std::size_t n = of.leaves.size();
    if (of.leaves.size() > most_unknowns_with_integrals || n % 2 != 0) {
        return false;
    }
    try {
        power_sums sums;
        std::vector<std::vector<power_sum>> jacobian;
        for (const auto& row : jacobian_of(of)) {
            auto& converted = jacobian.emplace_back();
            for (const expression& each : row) {
                converted.push_back(sums.of(each));
            }
        }
        std::vector<std::pair<std::size_t, std::size_t>> places;
        std::vector<std::vector<power_sum>> rows;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                // E = e_i e_j^T - e_j e_i^T: E f' has row i = f'_j, row j = -f'_i; f'^T E is minus its transpose.
                places.emplace_back(i, j);
                std::vector<power_sum> entries(n * n);
                const auto add_to = [&](std::size_t row, std::size_t column, const power_sum& value, int sign) {
                    for (const auto& [product, factor] : value) {
                        auto& place = entries[row * n + column];
                        const auto found = place.try_emplace(product, 0).first;
                        found->second += sign * factor;
                        if (found->second == 0) {
                            place.erase(found);
                        }
                    }
                };
                for (std::size_t k = 0; k < n; ++k) {
                    add_to(i, k, jacobian[j][k], 1);
                    add_to(j, k, jacobian[i][k], -1);
                    add_to(k, i, jacobian[j][k], -1);
                    add_to(k, j, jacobian[i][k], 1);
                }
                rows.push_back(std::move(entries));
            }
        }
        return spans_regular_matrix(sums.relations(rows), places, n);
    } catch (const no_power_sum&) {
        return false;
    }
}

}  // namespace libration::ode
