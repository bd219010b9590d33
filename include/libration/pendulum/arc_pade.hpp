// Pade approximants of theta from the top.
//
// In s = x^2, x = t/T*, theta = a_0 + x^p g(s) with p = 0 or 1, and g has logarithmic branch points at the squares of
// the lattice. Rate: the approximants [n/n] converge in capacity off the cuts of least capacity that join the branch
// points, the error decreasing like exp(-2 n G), G the Green function at 1/s of the complement of the cuts
// [Stahl1997]; there is no closed form for this lattice. The measured rate is between that of the series and that
// of the uniform resummation, and it tends to 1 at E = 2. In capacity only: a pole may be on [0, 1],
// and there is no bound of the error.
#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "libration/algebra/first_root.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/pendulum/resummation.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// a_0 + x^p P(x^2)/Q(x^2), p = 0 or 1.
template <rounding_scalar T>
class arc_pade {
public:
    arc_pade(T constant, int parity, pade_approximant<T> in_square)
        : constant_(std::move(constant)), parity_(parity), in_square_(std::move(in_square)) {}

    const pade_approximant<T>& in_square() const { return in_square_; }

    /// The least x of [0, 1] where Q is 0: the approximant has no norm then. std::nullopt if there is none.
    std::optional<T> first_pole() const {
        using std::sqrt;
        const auto square = first_root(in_square_.denominator);
        return square ? std::optional<T>(sqrt(*square)) : std::nullopt;
    }

    /// Value and derivative at x.
    series::jet<T> operator()(const T& x) const {
        const T square = x * x;
        const series::jet<T> g = in_square_(square);
        if (parity_ == 0) {
            return {constant_ + g.value, g.slope * x * 2};
        }
        return {constant_ + g.value * x, g.value + g.slope * square * 2};
    }

private:
    T constant_;
    int parity_;
    pade_approximant<T> in_square_;
};

/// The approximant from `count` coefficients of powers of t that are nonzero by symmetry: [L/M] with M as large as
/// possible up to half of the degrees in s, or the next smaller M for which it exists (at E = 1 every second
/// coefficient is 0); M = 0 is the series. The system loses about 3/2 digits per degree of Q. O(count^3). Throws
/// error when count < 1.
template <rounding_scalar T>
arc_pade<T> pade_from_top(const fundamental_arc<T>& arc, int count) {
    if (count < 1) {
        throw error(error_kind::argument, "number of coefficients", std::to_string(count),
                    "of a Pade approximant is below 1");
    }
    const int parity = arc.level().regime == regime::rotation ? 1 : 0;
    const series::power_series<T> a = arc_series(arc, 2 * count - parity);
    std::vector<T> g;
    g.reserve(static_cast<std::size_t>(count) + 1);
    for (int n = parity; n <= a.order(); n += 2) {
        g.push_back(n == 0 ? T(0) : a[n]);
    }
    const series::power_series<T> in_square(std::move(g));
    for (int down = in_square.order() / 2; down > 0; --down) {
        if (auto found = pade(in_square, in_square.order() - down, down)) {
            return {a[0], parity, *std::move(found)};
        }
    }
    return {a[0], parity, *pade(in_square, in_square.order(), 0)};
}

}  // namespace libration::pendulum
