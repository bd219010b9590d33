// One panel of a motion between the bottom and the top: theta and omega as short polynomials, and the
// panel that contains a time.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "libration/pendulum/sampling_constants.hpp"
#include "libration/scalar/scalar.hpp"
#include "libration/series/jet.hpp"

namespace libration::pendulum {

/// The number of powers kept per panel, an even number: 4.7 bits each; the bound 8/n R^-n of a coefficient [THEOREMS A]
/// and the derivative's n need 3 more than the digits.
template <fixed_scalar T>
inline constexpr std::size_t panel_terms = std::same_as<T, double>                              ? double_panel_terms
                                           : std::same_as<T, long double>&& LDBL_MANT_DIG == 64 ? 16
                                                                                                : 26;

/// The number of them that are kept in T: the powers from the 14th on are below 2^-66 of the value, and if 26 are kept,
/// double has enough digits for those and is forty times faster.
template <fixed_scalar T>
inline constexpr std::size_t panel_head = panel_terms<T> == 26 ? 14 : panel_terms<T>;

/// A panel: theta_0, theta'_0, theta_1, theta'_1, ... of the polynomials of theta and d theta/dx in x - centre; two
/// neighbouring powers of both are one vector of four.
template <fixed_scalar T>
struct alignas(64) panel {
    struct nothing {};
    static constexpr std::size_t tail_size = 2 * (panel_terms<T> - panel_head<T>);

    std::array<T, 2 * panel_head<T>> head{};
    [[no_unique_address]] std::conditional_t<tail_size == 0, nothing, std::array<double, tail_size>> tail{};

    void set(std::size_t power, const T& theta, const T& slope) {
        if (power < panel_head<T>) {
            head[2 * power] = theta;
            head[2 * power + 1] = slope;
        } else if constexpr (tail_size > 0) {
            const std::size_t slot = 2 * (power - panel_head<T>);
            tail[slot] = static_cast<double>(theta);
            tail[slot + 1] = static_cast<double>(slope);
        }
    }

    /// theta and its slope at x = centre + step, even and odd powers in parallel.
    [[gnu::always_inline]] series::jet<T> at(const T& step) const {
        const T square = step * step;
        constexpr std::size_t last = 2 * panel_head<T> - 4;
        std::array<T, 4> sum{head[last], head[last + 1], head[last + 2], head[last + 3]};
        if constexpr (tail_size > 0) {
            std::array<double, 4> small{};
            add_powers<tail_size>(small, tail.data(), static_cast<double>(square));
            for (std::size_t lane = 0; lane < 4; ++lane) {
                sum[lane] += square * small[lane];
            }
        }
        add_powers<last>(sum, head.data(), square);
        return {sum[0] + step * sum[2], sum[1] + step * sum[3]};
    }

private:
    // Horner's rule for four polynomials in the square, down to the first of `count` coefficients.
    template <std::size_t count, class F>
    [[gnu::always_inline]] static void add_powers(std::array<F, 4>& sum, const F* coefficients, const F& square) {
        for (std::size_t left = count; left > 0;) {
            left -= 4;
            for (std::size_t lane = 0; lane < 4; ++lane) {
                sum[lane] = sum[lane] * square + coefficients[left + lane];
            }
        }
    }
};

/// The location of x: the panel and its centre.
struct panel_place {
    std::size_t index;
    double centre;
};

/// The location of x >= 0, by a few operations on the bits of z. A z that rounds across an edge is harmless: the
/// polynomials of neighbours agree there.
inline panel_place place_of(double x) {
    constexpr int below = DBL_MANT_DIG - 1 - panel_octave_bits;
    constexpr std::uint64_t first = std::uint64_t{DBL_MAX_EXP - 1} << panel_octave_bits;
    const auto bits = std::bit_cast<std::uint64_t>(1 + x);
    const std::uint64_t leading = bits >> below;
    const std::uint64_t middle = (leading << below) | (std::uint64_t{1} << (below - 1));
    return {static_cast<std::size_t>(leading - first), std::bit_cast<double>(middle) - 1};
}

}  // namespace libration::pendulum
