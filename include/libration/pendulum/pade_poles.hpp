// The poles of Pade approximants of omega about the top of a motion, which converge to the lattice of singularities.
//
// omega is odd in t for libration and even for rotation: in s = (t/R)^2, R omega / x (x = t/R) and R omega are
// power series in s, meromorphic, with one simple pole at the square of each pair +-t_s of singularities. A
// residue rho of the approximant in s is one of omega in t of rho/2 (libration) or rho/(2 x) (rotation), which
// should be +-2i [DLMF 22.4].
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/algebra/polynomial_roots.hpp"
#include "libration/approximant/pade.hpp"
#include "libration/pendulum/lattice_points.hpp"
#include "libration/pendulum/resummation.hpp"

namespace libration::pendulum {

/// One of the four mirror images +-re +- i im of a pole, the one with re, im >= 0, relative to the top.
template <scalar T>
struct pade_pole {
    complex_number<T> time;
    complex_number<T> residue;
    complex_number<T> nearest;  ///< the singularity nearest to it, odd multiples of T* and K~'
    T distance;                 ///< from that singularity
};

/// The poles of one approximant by growing |time|.
template <scalar T>
struct pade_poles {
    int numerator_degree;
    int denominator_degree;
    std::vector<pade_pole<T>> poles;
};

/// theta about the top: a_n R^n, n = 0 .. N, with R the radius of convergence.
template <scalar T>
series::power_series<T> theta_in_radii(const fundamental_arc<T>& arc, const T& radius, int order) {
    return taylor_coefficients(arc.start(), order, radius);
}

/// The series in s = (t/R)^2 from theta's coefficients a_n R^n about the top.
template <scalar T>
series::power_series<T> speed_in_square(const series::power_series<T>& theta, regime r) {
    const int first = r == regime::rotation ? 1 : 2;
    std::vector<T> c;
    c.reserve(static_cast<std::size_t>(theta.order()) / 2 + 1);
    for (int n = first; n <= theta.order(); n += 2) {
        c.push_back(theta[n] * n);
    }
    return series::power_series<T>(std::move(c));
}

/// The poles of a Pade approximant of the series in s, as times. std::nullopt if the roots of the denominator did not
/// converge or are not real or in conjugate pairs, which a higher precision remedies.
template <rounding_scalar T>
std::optional<std::vector<pade_pole<T>>> poles_in_time(const pade_approximant<T>& approximant, regime r,
                                                       const T& radius, const singularity_lattice<T>& lattice) {
    using std::abs;
    const polynomial_roots<T> roots = roots_of(approximant.denominator);
    std::vector<pade_pole<T>> found;
    found.reserve(roots.all.size());
    std::size_t seen = 0;
    for (const polynomial_root<T>& root : roots.all) {
        const bool real = abs(root.at.im) <= root.error_bound;
        if (!real && root.at.im < 0) {
            continue;
        }
        seen += real ? 1 : 2;
        const complex_number<T> s{root.at.re, real ? T(0) : root.at.im};
        const complex_number<T> x = square_root(s);
        const auto above = evaluate(approximant.numerator, s).value;
        const auto residue = above / evaluate(approximant.denominator, s).slope;
        const auto in_time = r == regime::rotation ? residue / (x * T(2)) : residue * (T(1) / 2);
        const complex_number<T> time = x * radius;
        const complex_number<T> nearest = nearest_singularity(lattice, time);
        found.push_back({time, in_time, nearest, modulus_of(time - nearest)});
    }
    if (!roots.converged || seen != roots.all.size()) {
        return std::nullopt;
    }
    // In double, so that rounding does not separate the equal moduli of E = 1; those are ordered by height.
    const auto place = [](const pade_pole<T>& p) {
        return std::pair(convert<double>(modulus_of(p.time)), convert<double>(p.time.im));
    };
    std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    return found;
}

/// The approximant [L/M] from the series to t^N, L + M + 1 the number of its coefficients and M <= L + 1 as large as
/// possible, or the next smaller M for which it exists up to `negligible` (at E = 1 every second coefficient is 0);
/// M = 0 is the series itself, which has no pole. std::nullopt as in poles_in_time(). Throws error at E = 2.
template <rounding_scalar T>
std::optional<pade_poles<T>> poles_of_speed(const motion& m, int order, const T& negligible) {
    const fundamental_arc<T> arc = arc_of<T>(m);
    const singularity_lattice<T> lattice = *singularities<T>(m);
    const T radius = modulus_of(complex_number<T>{lattice.effective_period, lattice.height});
    const auto theta = theta_in_radii(arc, radius, order);
    const auto speed = order < 2 ? series::power_series<T>() : speed_in_square(theta, arc.level().regime);
    for (int down = (speed.order() + 1) / 2; down >= 1; --down) {
        const int up = speed.order() - down;
        // A denominator of a lower degree is that of another approximant.
        if (const auto approximant = pade(speed, up, down, negligible);
            approximant && approximant->denominator[down] != 0) {
            const auto found = poles_in_time(*approximant, arc.level().regime, radius, lattice);
            return found ? std::optional(pade_poles<T>{up, down, *found}) : std::nullopt;
        }
    }
    return pade_poles<T>{speed.order(), 0, {}};
}

/// The distance from the first singularity, T* + i K~', to the nearest of the poles assigned to it; std::nullopt if
/// there is none.
template <rounding_scalar T>
std::optional<T> distance_from_first(const pade_poles<T>& found, const singularity_lattice<T>& lattice) {
    std::optional<T> least;
    for (const pade_pole<T>& p : found.poles) {
        const bool first = p.nearest.re < lattice.effective_period * 2 && p.nearest.im < lattice.height * 2;
        if (first && (!least || p.distance < *least)) {
            least = p.distance;
        }
    }
    return least;
}

}  // namespace libration::pendulum
