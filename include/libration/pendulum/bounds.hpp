// Proved bounds of the Taylor coefficients from the top, of their tail, and of the resummation (theorems A and A2).
//
// Theorem A. Let w = theta' with its simple poles t_s, residues +-2i, and S4 = sum_s |t_s|^-4. Integrating w(z) z^-n
// over growing boxes of the period lattice that avoid the poles (w is bounded on them) gives a_n = -(1/n) sum_s r_s
// t_s^-n for n >= 3, hence |a_n| <= (2/n) R^(4-n) S4 for n >= 4, because |t_s|^-n <= R^(4-n) |t_s|^-4. From the top
// t_s = +-(2p+1) T* +- i (2q+1) K~', |t_s|^2 >= 2 (2p+1)(2q+1) T* K~', so S4 <= 4 (pi^2/8)^2/(4 T*^2 K~'^2) and
//     |a_n| <= (8 M/n) R^-n,   M = pi^4 R^4/(256 T*^2 K~'^2).
// Only every second a_n is nonzero, so on [0, t] the tail from N' >= 4 on is at most
//     (8 M/N') (t/R)^N' / (1 - (t/R)^2).
//
// Theorem A2. theta_N is the Hermite interpolation of theta by degree N + 2, so with u = t/T* its error for each
// monomial t^(N+1+j) is at most T*^(N+1+j) u^(N+1) (1-u)^2 j(j-1)/2; summing A over j with rho = T*/R,
//     ||theta - theta_N|| <= (8 M/(N+3)) rho^(N+3)/(1-rho)^3 max_u u^(N+1) (1-u)^2,  N >= 1,
// and the maximum is (2/(N+3))^2 ((N+1)/(N+3))^(N+1). (The inequality (1-u)^2 sum (j-1-i) u^i <= (1-u)^2 j(j-1)/2 is
// that of u <= 1 in each term, and j(j-1)/2 rho^j sums to rho^2/(1-rho)^3.)
#pragma once

#include <string>

#include "libration/pendulum/period.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// The constants of the theorems for one energy level. Not for E = 0 or 2.
template <scalar T>
struct top_bounds {
    T effective_period;  ///< T*
    T radius;            ///< R
    T rho;               ///< T*/R
    T prefactor;         ///< M
    int parity;          ///< 0 for libration (even powers), 1 for rotation (odd powers)

    static top_bounds of(const energy_level<T>& o) {
        using std::sqrt;
        const T period = pendulum::effective_period(o);
        const T height = singularity_height(o);
        const T square = period * period + height * height;
        const T half_turn_squared = pi<T>() * pi<T>();
        const T radius = sqrt(square);
        const T mean = half_turn_squared * square / (period * height * 16);
        return {period, radius, period / radius, mean * mean, o.regime == regime::rotation ? 1 : 0};
    }

    /// Bound of |a_n| R^n. Throws error for n < 4, to which the theorem does not apply.
    T coefficient(int n) const {
        if (n < 4) {
            throw error(error_kind::argument, "power", std::to_string(n), "is below 4, where theorem A begins");
        }
        return prefactor * 8 / n;
    }

    /// The first power after N that occurs in the series.
    int first_omitted(int order) const { return order + 1 + ((order + 1) % 2 == parity ? 0 : 1); }

    /// Bound of |theta - sigma_N| on [0, T*]. Throws error when the first omitted power is below 4.
    T series_norm(int order) const {
        using std::pow;
        const int first = first_omitted(order);
        return coefficient(first) * pow(rho, first) / (1 - rho * rho);
    }

    /// Bound of |theta - theta_N| on [0, T*]. Throws error when N < 1.
    T resummation_norm(int order) const {
        using std::pow;
        if (order < 1) {
            throw error(error_kind::argument, "order", std::to_string(order), "is below 1, where theorem A2 begins");
        }
        const T gap = 1 - rho;
        const T largest = pow(T(T(order + 1) / (order + 3)), order + 1) * 4 / (order + 3) / (order + 3);
        return coefficient(order + 3) * pow(rho, order + 3) / (gap * gap * gap) * largest;
    }
};

}  // namespace libration::pendulum
