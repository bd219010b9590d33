// The six-term test of Chang and Corliss: a conjugate pair of nearest singularities from six successive coefficients.
//
// f = (1 - s w + d w^2)^nu, w = x^stride, satisfies (1 - s w + d w^2) x f' = stride nu (-s w + 2 d w^2) f, so that with
// m = n/stride, n = first + stride k,
//     m c_k = s (m - 1 - nu) c_{k-1} - d (m - 2 - 2 nu) c_{k-2}.
// Four such equations are linear in s, s nu, d and d nu taken as independent [ChangCorliss1980]. Then f is any solution
// of (1 - s w + d w^2) w f' = (q w + r w^2) f, with an exponent at each of the two roots. Exact for this f and for the
// logarithms A log(1 - w/w0) and its conjugate; with other factors the error falls like 1/n^2, that of nu like 1/n.
// Fails if more singularities are nearest (successive results differ) or only one is (the equations are singular).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/algebra/linear_system.hpp"
#include "libration/convergence/conjugate_pair.hpp"
#include "libration/convergence/settling.hpp"

namespace libration::convergence {

namespace fitting {

template <rounding_scalar T>
struct six_term_solution {
    pair_quadratic<T> pair;
    complex_number<T> position;  ///< in w
    T radius;
    T exponent;
};

/// From the six coefficients that end at c_k; std::nullopt if the equations are singular.
template <rounding_scalar T>
std::optional<six_term_solution<T>> solve_six_terms(const strided_series<T>& series, const scaled_coefficients<T>& c,
                                                    int last) {
    std::vector<std::vector<T>> a;
    std::vector<T> b;
    a.reserve(4);
    b.reserve(4);
    for (int k = last - 3; k <= last; ++k) {
        const T m = T(series.power(k)) / series.stride();
        a.push_back({T(c[k - 1] * m), T(-c[k - 1]), T(-c[k - 2] * m), c[k - 2]});
        b.push_back(T(c[k] * m));
    }
    if (const auto solution = solve_linear(std::move(a), std::move(b), T(epsilon<T>() * 64))) {
        const std::vector<T>& x = *solution;
        if (x[2] == 0 || !is_a_number(x[3])) {
            return std::nullopt;
        }
        const pair_quadratic<T> pair{x[0], x[2]};
        const complex_number<T> w = pair.nearest_root();
        // x = (s, s (1 + nu), d, d (2 + 2 nu)), so q + r w = s - x_1 - (2 d - x_3) w; nu is its quotient by -s + 2 d w.
        const auto above = complex_number<T>{x[0] - x[1], T(0)} - w * T(x[2] * 2 - x[3]);
        const auto below = w * T(x[2] * 2) - complex_number<T>{x[0], T(0)};
        return six_term_solution<T>{pair, w, modulus_of(w), (above / below).re};
    }
    return std::nullopt;
}

}  // namespace fitting

/// From the last six coefficients. The uncertainty is that of the settling over the last quarter, plus at least the
/// effect of rounding the coefficients. Needs twelve coefficients. O(N).
template <rounding_scalar T>
radius_estimate<T> six_term_test(const strided_series<T>& c) {
    constexpr int safety = 4;
    const std::string method = "six-term";
    if (c.last() + 1 < fewest_for_pairs) {
        return too_short<T>(method, fewest_for_pairs, c.last() + 1);
    }
    const scaled_coefficients<T> scaled(c);
    std::vector<T> radii;
    std::vector<T> exponents;
    std::optional<fitting::six_term_solution<T>> solution;
    const int window = settling_window(c.last() + 1 - 5);
    radii.reserve(static_cast<std::size_t>(window));
    exponents.reserve(static_cast<std::size_t>(window));
    for (int k = c.last() - window + 1; k <= c.last(); ++k) {
        solution = fitting::solve_six_terms(c, scaled, k);
        if (!solution) {
            return no_estimate<T>(method, "its equations are singular: no pair of singularities");
        }
        radii.push_back(solution->radius);
        exponents.push_back(solution->exponent);
    }
    if (solution->position.im == 0) {
        return no_estimate<T>(method, "its roots are real: no conjugate pair of singularities");
    }
    if (!solution->pair.conjugate(c.last())) {
        return no_estimate<T>(method,
                              "its roots are not distinguished from real ones: no conjugate pair of singularities");
    }
    const auto radius = settled_range(radii);
    const auto exponent = settled_range(exponents);
    if (radius.scatters()) {
        return no_estimate<T>(method, "successive results differ between " + radius.range() + ": no single pair");
    }
    radius_estimate<T> result;
    result.method = method;
    result.radius = radius.value;
    result.uncertainty = radius.uncertainty() + radius.value * epsilon<T>() * (safety * (c.last() + 1));
    result.position = solution->position;
    result.count = 2;
    result.exponent = exponent.value;
    result.exponent_uncertainty = exponent.uncertainty() + epsilon<T>() * safety * (c.last() + 1) * (c.last() + 1);
    return if_settled(in_variable(std::move(result), c.stride()));
}

}  // namespace libration::convergence
