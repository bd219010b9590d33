// theta and omega between the bottom and the top as short polynomials on panels: a value costs a look-up and some products.
//
// With x the time since the bottom in a unit u, a power of two, and z = 1 + x, the panels are the sixteenths of the
// octaves [1,2), [2,4), ... of z, so that the leading bits of z are the number of its panel. From the centre of a panel
// the nearest singularity is at R >= sqrt(x^2 + K~'^2/u^2) and u <= (2/pi) min(K~', T*), so the half width of a panel is
// below R/26 (largest at z = 4), and a power of theta in x brings 4.7 bits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/swing.hpp"
#include "libration/series/jet.hpp"

namespace libration {

/// A scalar with at least 11 bits more than T, in which the centres of the panels are computed.
template <fixed_scalar T>
struct finer_scalar {
    using type = mpfr;
};
template <>
struct finer_scalar<double> {
    using type = std::conditional_t<LDBL_MANT_DIG == 64, long double, quad>;
};
template <>
struct finer_scalar<long double> {
    using type = std::conditional_t<LDBL_MANT_DIG == 64, quad, mpfr>;
};
template <fixed_scalar T>
using finer_t = typename finer_scalar<T>::type;

/// x rounded once, without the detour through mpfr where the machine can do it.
template <fixed_scalar T, rounding_scalar F>
T rounded_to(const F& x) {
    if constexpr (std::same_as<F, mpfr>) {
        return narrow<T>(x);
    } else {
        return static_cast<T>(x);
    }
}

/// How many powers of a panel are kept, an even number: 4.7 bits each; the bound 8/n R^-n of a coefficient [THEOREMS A]
/// and the derivative's n take 3 more than the digits.
template <fixed_scalar T>
inline constexpr std::size_t panel_terms = std::same_as<T, double>                              ? 12
                                           : std::same_as<T, long double>&& LDBL_MANT_DIG == 64 ? 16
                                                                                                : 26;

/// How many of them are kept in T: the powers from the 14th on are below 2^-66 of the value, and where 26 are kept, double
/// has digits enough for those and is forty times faster.
template <fixed_scalar T>
inline constexpr std::size_t panel_head = panel_terms<T> == 26 ? 14 : panel_terms<T>;

/// A panel: theta_0, theta'_0, theta_1, theta'_1, ... of the polynomials of theta and d theta/dx in x - centre; two
/// neighbouring powers of both are one vector of four.
template <fixed_scalar T>
struct alignas(64) panel {
    std::array<T, 2 * panel_head<T>> head{};
    std::array<double, 2 * (panel_terms<T> - panel_head<T>)> tail{};

    void set(std::size_t power, const T& theta, const T& slope) {
        if (power < panel_head<T>) {
            head[2 * power] = theta;
            head[2 * power + 1] = slope;
        } else {
            const std::size_t slot = 2 * (power - panel_head<T>);
            tail[slot] = static_cast<double>(theta);
            tail[slot + 1] = static_cast<double>(slope);
        }
    }

    /// theta and its slope at x = centre + step, even and odd powers side by side.
    [[gnu::always_inline]] jet<T> at(const T& step) const {
        const T square = step * step;
        constexpr std::size_t last = 2 * panel_head<T> - 4;
        std::array<T, 4> sum{head[last], head[last + 1], head[last + 2], head[last + 3]};
        if constexpr (panel_head<T> < panel_terms<T>) {
            std::array<double, 4> small{};
            add_powers<2 * (panel_terms<T> - panel_head<T>)>(small, tail.data(), static_cast<double>(square));
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

/// Where x is: the panel and its centre.
struct panel_place {
    std::size_t index;
    double centre;
};

/// The place of x >= 0, a few operations on the bits of z. A z that rounds across an edge does no harm: the polynomials
/// of neighbours agree there.
inline panel_place place_of(double x) {
    constexpr int octave_bits = 4;
    constexpr int below = DBL_MANT_DIG - 1 - octave_bits;
    constexpr std::uint64_t first = std::uint64_t{DBL_MAX_EXP - 1} << octave_bits;
    const auto bits = std::bit_cast<std::uint64_t>(1 + x);
    const std::uint64_t leading = bits >> below;
    const std::uint64_t middle = (leading << below) | (std::uint64_t{1} << (below - 1));
    return {static_cast<std::size_t>(leading - first), std::bit_cast<double>(middle) - 1};
}

/// The panels of one motion from the bottom to the top. Where the way takes longer than all digits of T can tell the state
/// from rest on top, they end there. Not more than 110 panels.
template <fixed_scalar T>
class swing_panels {
public:
    /// The motion's times are counted in its own units (seconds where it has a length and a gravity). Cost: a Jacobi
    /// function and a Taylor series of panel_terms powers each. Throws std::range_error where the square of the unit
    /// leaves the range of T (E above 10^307 in double), and as energies.
    explicit swing_panels(const motion& m) {
        using std::ldexp;
        using W = finer_t<T>;
        const precision_scope scope(decimal_digits(digits<T>() + 64));
        const swing<W> way(m);
        const W seconds = time_unit<W>(m);
        const long exponent = unit_exponent(way, seconds);
        if (!holds_exponent<T>(2 * exponent) || !holds_exponent<T>(-2 * exponent)) {
            throw std::range_error("the time to the top is outside the range of this scalar");
        }
        unit_ = ldexp(T(1), static_cast<int>(exponent));
        const W scale = ldexp(W(1), static_cast<int>(exponent)) / seconds;
        end_ = way.constant() ? T(0) : rounded_to<T>(W(last_time(way) / scale));
        const std::size_t count = place_of(static_cast<double>(end_)).index + 1;
        panels_.reserve(count);
        for (double x = 0; panels_.size() < count;) {
            const double centre = place_of(x).centre;
            panels_.push_back(expanded(way, centre, scale));
            x = 2 * centre - x;
        }
    }

    /// u, a power of two.
    const T& unit() const { return unit_; }
    /// The largest x; theta and omega stay what they are there.
    const T& end() const { return end_; }
    std::size_t size() const { return panels_.size(); }
    const panel<T>& operator[](std::size_t index) const { return panels_[index]; }

private:
    using finer = finer_t<T>;

    static long unit_exponent(const swing<finer>& way, const finer& seconds) {
        finer reach = way.constant() ? finer(2) : way.height();
        if (way.has_top() && way.effective_period() < reach) {
            reach = way.effective_period();
        }
        // A few digits more than none: u = 1 where K~' is pi/2 up to rounding.
        const finer largest = reach * seconds * 2 / pi<finer>();
        return binary_exponent(finer(largest + largest / 1024)) - 1;
    }

    // T* and 2^-20 of it, for times that round into the other side; but no more than the time after which the distance to
    // the top, 4 e^-t, is below an eighth of an epsilon.
    static finer last_time(const swing<finer>& way) {
        const finer settled = finer((digits<T>() + 6) * 7) / 10;
        const finer way_up = way.effective_period() + way.effective_period() / (1 << 20);
        return way.has_top() && way_up < settled ? way_up : settled;
    }

    static panel<T> expanded(const swing<finer>& way, double centre, const finer& scale) {
        const auto down = [](const finer& x) { return rounded_to<T>(x); };
        const pendulum_state<finer> at = way.at(finer(scale * centre));
        const taylor_start<T> start{{down(at.theta), down(at.omega), down(at.half_sine), down(at.half_cosine)},
                                    {down(way.pair().energy), down(way.pair().gap)}};
        power_series<T> theta = taylor_coefficients(start, static_cast<int>(panel_terms<T>), down(scale));
        theta[1] = down(finer(at.omega * scale));
        panel<T> result;
        for (std::size_t n = 0; n < panel_terms<T>; ++n) {
            const int power = static_cast<int>(n);
            result.set(n, theta[power], T(theta[power + 1] * (power + 1)));
        }
        return result;
    }

    T unit_ = T(1);
    T end_ = T(0);
    std::vector<panel<T>> panels_;
};

}  // namespace libration
