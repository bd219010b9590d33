// Series with known radii, the problems of the radius tournament: elementary and special functions with isolated
// singularities, entire functions, natural boundaries, and a divergent series.
#pragma once

#include <vector>

#include "libration/convergence/known_elementary_series.hpp"
#include "libration/convergence/special_series.hpp"
#include "libration/problem/known/blasius_series.hpp"

namespace libration::convergence {

namespace tournament {

/// Special functions and solutions of differential equations.
template <rounding_scalar T>
std::vector<known_series<T>> special_functions() {
    using enum singularity_kind;
    const auto minus_one_over_e = [] { return complex_number<mpfr>{mpfr(-exp(mpfr(-1))), mpfr(0)}; };
    const auto at_sixty_degrees = [] {
        const auto radius = from_exact<mpfr>(read_exact(blasius_radius));
        return complex_number<mpfr>{mpfr(radius / 2), mpfr(radius * sqrt(mpfr(3)) / 2)};
    };
    return {
        singular_series<T>("Catalan numbers", catalan_series<mpfr>, {real_point({1, 4}), 1, algebraic, rational(1, 2)}),
        singular_series<T>("Lambert W", lambert_series<mpfr>, {minus_one_over_e, 1, algebraic, rational(1, 2)}),
        singular_series<T>("K(m)", parameter_series_of_k<mpfr>, {real_point(1), 1, logarithm, 0}),
        singular_series<T>("digamma(1+t)", digamma_series<mpfr>, {real_point(-1), 1, pole, -1}),
        singular_series<T>("inverse Langevin", inverse_langevin_series<mpfr>,
                           {inverse_langevin_singularity<mpfr>, 4, algebraic, rational(1, 2)}),
        singular_series<T>("Blasius", blasius_series<mpfr>, {at_sixty_degrees, 3, pole, -1}),
    };
}

/// sum_{k >= 1} t^(n_k), n_k = power(k) increasing.
template <rounding_scalar T, class Power>
series::power_series<T> gap_series(Power power, int order) {
    auto a = series::power_series<T>::zero(order);
    for (int k = 1; power(k) <= order; ++k) {
        a[power(k)] = T(1);
    }
    return a;
}

/// Without isolated singularities: entire functions, natural boundaries [Hadamard1892; Fabry1896], and a divergent
/// series.
template <rounding_scalar T>
std::vector<known_series<T>> without_singularity() {
    return {
        entire_series<T>("e^t", exponential_series<mpfr>),
        entire_series<T>("cos t", cosine_series<mpfr>),
        entire_series<T>("J0(t)", bessel_series<mpfr>),
        entire_series<T>("Ai(t)", airy_series<mpfr>),
        bounded_series<T>("sum t^(2^k)", [](int n) { return gap_series<mpfr>([](int k) { return 1 << k; }, n); }),
        bounded_series<T>("sum t^(k^2)", [](int n) { return gap_series<mpfr>([](int k) { return k * k; }, n); }),
        divergent_series<T>(
            "sum n! t^n",
            [](int n) { return series_by_steps(n, mpfr(1), [](const mpfr& a, int k) { return mpfr(a * k); }); }),
    };
}

}  // namespace tournament

/// All of them. Radius and position are correct to an eps, those of the Blasius layer to 100 digits at most.
template <rounding_scalar T>
std::vector<known_series<T>> all_known_series() {
    auto all = tournament::on_the_real_axis<T>();
    for (const auto& family : {tournament::pairs<T>(), tournament::generating_functions<T>(),
                               tournament::special_functions<T>(), tournament::without_singularity<T>()}) {
        all.insert(all.end(), family.begin(), family.end());
    }
    return all;
}

}  // namespace libration::convergence
