// Pade approximants on balls, which are proved to exist when they are returned.
#pragma once

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

#include "libration/approximant/pade.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration {

/// [L/M] of every series in the balls, the system solved by Arb. Returns std::nullopt if it cannot be proved to be
/// regular.
inline std::optional<pade_approximant<ball>> pade(const series::power_series<ball>& series, int numerator_degree,
                                                  int denominator_degree) {
    const auto solve = [](const std::vector<std::vector<ball>>& a, const std::vector<ball>& b) {
        const auto size = static_cast<slong>(b.size());
        arb_mat_t left;
        arb_mat_t right;
        arb_mat_init(left, size, size);
        arb_mat_init(right, size, 1);
        for (slong i = 0; i < size; ++i) {
            const auto row = static_cast<std::size_t>(i);
            for (slong j = 0; j < size; ++j) {
                arb_set(arb_mat_entry(left, i, j), a[row][static_cast<std::size_t>(j)].handle());
            }
            arb_set(arb_mat_entry(right, i, 0), b[row].handle());
        }
        std::optional<std::vector<ball>> solution;
        if (arb_mat_solve(right, left, right, ball::working_bits()) != 0) {
            solution.emplace(b.size());
            for (slong i = 0; i < size; ++i) {
                arb_set((*solution)[static_cast<std::size_t>(i)].handle(), arb_mat_entry(right, i, 0));
            }
        }
        arb_mat_clear(left);
        arb_mat_clear(right);
        return solution;
    };
    return pade_by(series, numerator_degree, denominator_degree, solve);
}

}  // namespace libration
