// Elementary functions with known singularities: poles, logarithms and branch points, single, in pairs and close to
// each other.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "libration/convergence/elementary_series.hpp"
#include "libration/convergence/known_singularity.hpp"

namespace libration::convergence::tournament {

/// A position on the real axis, as a fraction.
inline std::function<complex_number<mpfr>()> real_point(const rational& at) {
    return [at] { return complex_number<mpfr>{from_rational<mpfr>(at), mpfr(0)}; };
}

/// c + i sqrt(1 - c^2) on the unit circle.
inline std::function<complex_number<mpfr>()> unit_point(const rational& c) {
    return [c] {
        return complex_number<mpfr>{from_rational<mpfr>(c), mpfr(sqrt(from_rational<mpfr>(rational(1 - c * c))))};
    };
}

/// (1 - t)^nu for a rational nu.
inline std::function<series::power_series<mpfr>(int)> power_of_linear(const rational& nu) {
    return [nu](int order) { return binomial_series(from_rational<mpfr>(nu), order); };
}

/// (1 - 2 c t + t^2)^nu for rational c and nu.
inline std::function<series::power_series<mpfr>(int)> power_of_quadratic(const rational& c, const rational& nu) {
    return
        [c, nu](int order) { return quadratic_power_series(from_rational<mpfr>(c), from_rational<mpfr>(nu), order); };
}

/// One singularity at 1, or two of them on the real axis.
template <rounding_scalar T>
std::vector<known_series<T>> on_the_real_axis() {
    using enum singularity_kind;
    using terms = std::vector<weighted_singularity<mpfr>>;
    const auto one = real_point(1);
    return {
        singular_series<T>("log(1-t)",
                           [](int n) {
                               return logarithm_series(terms{{1, 1}}, n);
                           },
                           {one, 1, logarithm, 0}),
        singular_series<T>("(1-t)^(1/3)", power_of_linear({1, 3}), {one, 1, algebraic, rational(1, 3)}),
        singular_series<T>("(1-t)^(-5/2)", power_of_linear({-5, 2}), {one, 1, algebraic, rational(-5, 2)}),
        singular_series<T>("(1-t)^(1/2)+3-2t+t^5",
                           [](int n) {
                               auto a = binomial_series(mpfr(mpfr(1) / 2), std::max(n, 5));
                               a[0] += 3;
                               a[1] -= 2;
                               a[5] += 1;
                               return a.truncated(n);
                           },
                           {one, 1, algebraic, rational(1, 2)}),
        singular_series<T>("1/(1-t)^2", power_of_linear(-2), {one, 1, pole, -2}),
        singular_series<T>("1/(1-t)+1/(1-t/1.05)",
                           [](int n) {
                               return pole_series(terms{{1, 1}, {1, mpfr(21) / 20}}, n);
                           },
                           {one, 1, pole, -1}),
        singular_series<T>("log(1-t)+3log(1+t/1.02)",
                           [](int n) {
                               return logarithm_series(terms{{1, 1}, {3, mpfr(-51) / 50}}, n);
                           },
                           {one, 1, logarithm, 0}),
        singular_series<T>("1e-6log(1-t)+log(1+t/1.25)",
                           [](int n) {
                               return logarithm_series(terms{{mpfr(1) / 1'000'000, 1}, {1, mpfr(-5) / 4}}, n);
                           },
                           {one, 1, logarithm, 0}),
        singular_series<T>("(1-t)^(1/3)(1+t)^(-1/2)",
                           [](int n) { return opposite_powers_series(mpfr(mpfr(1) / 3), mpfr(mpfr(-1) / 2), n); },
                           {one, 2, algebraic, rational(1, 3)}),
        singular_series<T>("e^t/(1-t/50)",
                           [](int n) {
                               const auto e = exponential_series<mpfr>(n);
                               return series_by_steps(n, mpfr(1),
                                                      [&](const mpfr& a, int k) { return mpfr(a / 50 + e[k]); });
                           },
                           {real_point(50), 1, pole, -1}),
    };
}

/// Conjugate and opposite pairs.
template <rounding_scalar T>
std::vector<known_series<T>> pairs() {
    using enum singularity_kind;
    const auto i = unit_point(0);
    const auto half_pi = [] { return complex_number<mpfr>{mpfr(pi<mpfr>() / 2), mpfr(0)}; };
    const auto two_pi_i = [] { return complex_number<mpfr>{mpfr(0), mpfr(pi<mpfr>() * 2)}; };
    return {
        singular_series<T>("1/(1+t^2)", power_of_quadratic(0, -1), {i, 2, pole, -1}),
        singular_series<T>("1/(1+t+t^2)", power_of_quadratic({-1, 2}, -1), {unit_point({-1, 2}), 2, pole, -1}),
        singular_series<T>("tan t", tangent_series<mpfr>, {half_pi, 2, pole, -1}),
        singular_series<T>("sec t", secant_series<mpfr>, {half_pi, 2, pole, -1}),
        singular_series<T>("t/(e^t-1)", bernoulli_series<mpfr>, {two_pi_i, 2, pole, -1}),
        singular_series<T>(
            "arctan t",
            [](int n) { return integral(quadratic_power_series(mpfr(0), mpfr(-1), n), mpfr(0)).truncated(n); },
            {i, 2, logarithm, 0}),
        singular_series<T>("arcsin t",
                           [](int n) {
                               const mpfr root = mpfr(-1) / 2;
                               return integral(opposite_powers_series(root, root, n), mpfr(0)).truncated(n);
                           },
                           {real_point(1), 2, algebraic, rational(1, 2)}),
    };
}

/// (1 - 2 c t + t^2)^nu and its logarithm, singular at e^(+-i phi), cos phi = c.
template <rounding_scalar T>
std::vector<known_series<T>> generating_functions() {
    using enum singularity_kind;
    struct typed {
        const char* text;
        rational value;
    };
    std::vector<known_series<T>> all;
    all.reserve(12);
    for (const typed& c : {typed{"0.3", {3, 10}}, typed{"0.9", {9, 10}}, typed{"-0.4", {-2, 5}}}) {
        const std::string where = std::string(" c=") + c.text;
        for (const typed& nu : {typed{"(-1/2)", {-1, 2}}, typed{"(1/2)", {1, 2}}, typed{"(1/3)", {1, 3}}}) {
            all.push_back(singular_series<T>(std::string("(1-2ct+t^2)^") + nu.text + where,
                                             power_of_quadratic(c.value, nu.value),
                                             {unit_point(c.value), 2, algebraic, nu.value}));
        }
        all.push_back(
            singular_series<T>("log(1-2ct+t^2)" + where,
                               [c](int n) { return quadratic_logarithm_series(from_rational<mpfr>(c.value), n); },
                               {unit_point(c.value), 2, logarithm, 0}));
    }
    return all;
}

}  // namespace libration::convergence::tournament
