// theta and omega between the bottom and the top as short polynomials on panels: a value costs a look-up and some
// products.
//
// With x the time since the bottom in a unit u, a power of two, and z = 1 + x, the panels are the sixteenths of the
// octaves [1,2), [2,4), ... of z, so that the leading bits of z are the number of its panel. From the centre of a panel
// the nearest singularity is at R >= sqrt(x^2 + K~'^2/u^2) and u <= (2/pi) min(K~', T*), so the half width of a panel
// is below R/26 (largest at z = 4), and a power of theta in x contributes 4.7 bits.
#pragma once

#include <cfloat>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/half_cycle.hpp"
#include "libration/pendulum/half_cycle_panel.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

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

/// x rounded once, directly rather than through mpfr if the hardware supports it.
template <fixed_scalar T, rounding_scalar F>
T rounded_to(const F& x) {
    if constexpr (std::same_as<F, mpfr>) {
        return narrow<T>(x);
    } else {
        return static_cast<T>(x);
    }
}

/// The panels of one motion from the bottom to the top. If after some time the digits of T cannot distinguish the state
/// from rest on top, they end there. Not more than 110 panels.
template <fixed_scalar T>
class half_cycle_panels {
public:
    /// The motion's times are counted in its own units (seconds if it has a length and a gravity). Cost: a Jacobi
    /// function and a Taylor series of panel_terms powers each. Throws error of the kind range if the square of the
    /// unit is outside the range of T (E above 10^307 in double), and as energies.
    explicit half_cycle_panels(const motion& m) {
        using std::ldexp;
        using W = finer_t<T>;
        const precision_scope scope(decimal_digits(digits<T>() + 64));
        const half_cycle<W> half(m);
        const W seconds = time_unit<W>(m);
        const long exponent = unit_exponent(half, seconds);
        if (!holds_exponent<T>(2 * exponent) || !holds_exponent<T>(-2 * exponent)) {
            throw error(error_kind::range, "time to the top", "", "is outside the range of this scalar");
        }
        unit_ = ldexp(T(1), static_cast<int>(exponent));
        const W scale = ldexp(W(1), static_cast<int>(exponent)) / seconds;
        end_ = half.constant() ? T(0) : rounded_to<T>(W(last_time(half) / scale));
        const std::size_t count = place_of(static_cast<double>(end_)).index + 1;
        panels_.reserve(count);
        for (double x = 0; panels_.size() < count;) {
            const double centre = place_of(x).centre;
            panels_.push_back(expanded(half, centre, scale));
            x = 2 * centre - x;
        }
    }

    /// u, a power of two.
    const T& unit() const { return unit_; }
    /// The largest x; beyond it theta and omega are constant.
    const T& end() const { return end_; }
    std::size_t size() const { return panels_.size(); }
    const panel<T>* data() const { return panels_.data(); }
    const panel<T>& operator[](std::size_t index) const { return panels_[index]; }

private:
    using finer = finer_t<T>;

    static long unit_exponent(const half_cycle<finer>& half, const finer& seconds) {
        finer reach = half.constant() ? finer(2) : half.height();
        if (half.has_top() && half.effective_period() < reach) {
            reach = half.effective_period();
        }
        // Slightly enlarged: u = 1 where K~' is pi/2 up to rounding.
        const finer largest = reach * seconds * 2 / pi<finer>();
        return binary_exponent(finer(largest + largest / 1024)) - 1;
    }

    // T* and 2^-20 of it, for times that round into the other side; but at most the time after which the distance
    // to the top, 4 e^-t, is below an eighth of an epsilon.
    static finer last_time(const half_cycle<finer>& half) {
        const finer settled = finer((digits<T>() + 6) * 7) / 10;
        const finer rise = half.effective_period() + half.effective_period() / (1 << 20);
        return half.has_top() && rise < settled ? rise : settled;
    }

    static panel<T> expanded(const half_cycle<finer>& half, double centre, const finer& scale) {
        const auto down = [](const finer& x) { return rounded_to<T>(x); };
        const pendulum_state<finer> at = half.at(finer(scale * centre));
        const taylor_start<T> start{{down(at.theta), down(at.omega), down(at.half_sine), down(at.half_cosine)},
                                    {down(half.pair().energy), down(half.pair().gap)}};
        series::power_series<T> theta = taylor_coefficients(start, static_cast<int>(panel_terms<T>), down(scale));
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

}  // namespace libration::pendulum
