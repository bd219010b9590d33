// All complex roots of a real polynomial at once, by the Aberth-Ehrlich iteration.
//
// Newton's step z - p/p' applied to p divided by the linear factors of the current guesses of the other roots
// [Aberth1973]: with
// n_i = p/p' at z_i,
//     z_i <- z_i - n_i / (1 - n_i sum_{j != i} 1/(z_i - z_j)),
// cubic at simple roots, linear at multiple ones. It starts from circles whose radii are the slopes of the Newton
// polygon of the coefficients, the upper hull of (i, log2 |a_i|) [Bini1996]: within a factor of the moduli of the
// roots, however widely they spread. The working precision limits the accuracy: |p(z)| is known to about eps sum |a_i|
// |z|^i, and a root of multiplicity m to eps^(1/m); the error bounds returned with the roots include this.
#pragma once

#include <cstddef>
#include <vector>

#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/power_series.hpp"

namespace libration {

/// A root and n (|p| + rounding)/|p'| there: the disk of this radius about it contains an exact root [Henrici, 6.4].
template <rounding_scalar T>
struct polynomial_root {
    complex_number<T> at;
    T error_bound;
    bool settled = false;  ///< |p| is not above its rounding error: no step can improve the root
};

/// The roots in no particular order, and how the iteration ended.
template <rounding_scalar T>
struct polynomial_roots {
    std::vector<polynomial_root<T>> all;
    int steps = 0;
    bool converged = false;  ///< every root settled within the allowed number of steps
};

/// p, p' and a bound on the rounding error of p at one complex point.
template <rounding_scalar T>
struct polynomial_value {
    complex_number<T> value;
    complex_number<T> slope;
    T rounding;
};

/// By Horner's rule, with eps 4 n sum |a_i| |z|^i for the rounding. O(n).
template <rounding_scalar T>
polynomial_value<T> evaluate(const series::power_series<T>& p, const complex_number<T>& z) {
    using std::abs;
    const T size = modulus_of(z);
    polynomial_value<T> at{{p[p.order()]}, {T(0)}, abs(p[p.order()])};
    for (int n = p.order() - 1; n >= 0; --n) {
        at.slope = at.slope * z + at.value;
        at.value = at.value * z;
        at.value.re += p[n];
        at.rounding = at.rounding * size + abs(p[n]);
    }
    at.rounding *= epsilon<T>() * (4 * p.order());
    return at;
}

/// The corners of the upper hull of the points (i, log2 |a_i|), a_i != 0, to the accuracy of binary exponents.
template <rounding_scalar T>
std::vector<int> newton_polygon(const series::power_series<T>& p) {
    std::vector<int> hull;
    hull.reserve(p.coefficients().size());
    const auto height = [&](int i) { return binary_exponent(p[i]); };
    for (int i = 0; i <= p.order(); ++i) {
        if (p[i] == 0) {
            continue;
        }
        const auto is_below = [&](int a, int b) {  // b is on or below the line from a to i
            return (height(b) - height(a)) * (i - a) <= (height(i) - height(a)) * (b - a);
        };
        while (hull.size() >= 2 && is_below(hull[hull.size() - 2], hull.back())) {
            hull.pop_back();
        }
        hull.push_back(i);
    }
    return hull;
}

/// b - a guesses on the circle |z| = |a_a/a_b|^(1/(b-a)) for each edge (a, b) of the polygon; rotated, so that a
/// symmetry of the polynomial does not keep them together.
template <rounding_scalar T>
std::vector<polynomial_root<T>> first_guesses(const series::power_series<T>& p) {
    using std::cos;
    using std::pow;
    using std::sin;
    std::vector<polynomial_root<T>> guesses;
    guesses.reserve(static_cast<std::size_t>(p.order()));
    const std::vector<int> corners = newton_polygon(p);
    for (std::size_t e = 1; e < corners.size(); ++e) {
        const int count = corners[e] - corners[e - 1];
        const auto drop = static_cast<int>(binary_exponent(p[corners[e - 1]]) - binary_exponent(p[corners[e]]));
        const T radius = pow(T(2), T(T(drop) / count));
        for (int i = 0; i < count; ++i) {
            const T angle = pi<T>() * (2 * i) / count + T(7) / 10 + T(static_cast<int>(e)) / 3;
            guesses.push_back({{radius * cos(angle), radius * sin(angle)}, T(0)});
        }
    }
    return guesses;
}

/// One step of one root against all others; the root is settled if its value is below the rounding error.
template <rounding_scalar T>
void improve_root(const series::power_series<T>& p, std::vector<polynomial_root<T>>& roots, std::size_t i) {
    polynomial_root<T>& root = roots[i];
    const polynomial_value<T> at = evaluate(p, root.at);
    const T slope = modulus_of(at.slope);
    const T value = modulus_of(at.value);
    root.settled = value <= at.rounding;
    root.error_bound = slope == 0 ? modulus_of(root.at) : T((value + at.rounding) * p.order() / slope);
    if (root.settled || slope == 0) {
        return;
    }
    complex_number<T> others{T(0)};
    for (std::size_t j = 0; j < roots.size(); ++j) {
        const complex_number<T> apart = root.at - roots[j].at;
        if (j != i && (apart.re != 0 || apart.im != 0)) {
            others = others + complex_number<T>{T(1)} / apart;
        }
    }
    const complex_number<T> newton = at.value / at.slope;
    const complex_number<T> step = newton / (complex_number<T>{T(1)} - newton * others);
    root.at = root.at - step;
}

/// The n roots of a_0 + ... + a_n z^n with multiplicity; roots at 0 are exact. At most `steps` rounds of O(n^2)
/// operations; the default is 100 and four per bit, which double roots need. The powers |a_i| |z|^i must be within the
/// range of a fixed scalar. Throws error if a_n = 0.
template <rounding_scalar T>
polynomial_roots<T> roots_of(const series::power_series<T>& polynomial, int steps = 100 + 4 * digits<T>()) {
    if (polynomial[polynomial.order()] == 0) {
        throw error(error_kind::argument, "leading coefficient", "0", "lowers the degree of the polynomial");
    }
    int zeros = 0;
    while (polynomial[zeros] == 0) {
        ++zeros;
    }
    const auto first = polynomial.coefficients().begin() + zeros;
    const series::power_series<T> p(std::vector<T>(first, polynomial.coefficients().end()));
    polynomial_roots<T> found{first_guesses(p)};
    found.converged = p.order() == 0;
    while (!found.converged && found.steps < steps) {
        ++found.steps;
        found.converged = true;
        for (std::size_t i = 0; i < found.all.size(); ++i) {
            if (!found.all[i].settled) {
                improve_root(p, found.all, i);
                found.converged = found.converged && found.all[i].settled;
            }
        }
    }
    found.all.insert(found.all.end(), static_cast<std::size_t>(zeros), {{T(0)}, T(0), true});
    return found;
}

}  // namespace libration
