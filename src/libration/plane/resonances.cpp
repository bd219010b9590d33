#include "libration/plane/resonances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libration/scalar/complex_functions.hpp"

namespace libration::ode {

namespace {

using number_pair = std::complex<double>;
using number_matrix = std::vector<std::vector<number_pair>>;

constexpr std::size_t most_analysed_unknowns = 12;
constexpr double largest_entry = 1e6;
constexpr int most_root_steps = 500;

// x^n + c_1 x^(n-1) + .. of det(x - a), the highest coefficient first [Faddeev, LeVerrier].
std::vector<number_pair> characteristic_polynomial(const number_matrix& a) {
    const std::size_t n = a.size();
    std::vector<number_pair> c{1};
    number_matrix m(n, std::vector<number_pair>(n));
    for (std::size_t k = 1; k <= n; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            m[i][i] += c.back();
        }
        number_matrix next(n, std::vector<number_pair>(n));
        number_pair trace = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t l = 0; l < n; ++l) {
                    next[i][j] += a[i][l] * m[l][j];
                }
            }
            trace += next[i][i];
        }
        c.push_back(-trace / static_cast<double>(k));
        m = std::move(next);
    }
    return c;
}

// All roots simultaneously [Weierstrass, Durand, Kerner].
std::vector<number_pair> roots_of(const std::vector<number_pair>& c) {
    const std::size_t n = c.size() - 1;
    double size = 1;
    for (std::size_t k = 1; k <= n; ++k) {
        size = std::max(size, 2 * std::pow(std::abs(c[k]), 1.0 / static_cast<double>(k)));
    }
    std::vector<number_pair> roots;
    for (std::size_t k = 0; k < n; ++k) {
        roots.push_back(size * std::pow(number_pair(0.4, 0.9), static_cast<double>(k)));
    }
    for (int iteration = 0; iteration < most_root_steps; ++iteration) {
        double change = 0;
        for (std::size_t i = 0; i < n; ++i) {
            number_pair value = c.front();
            for (std::size_t k = 1; k <= n; ++k) {
                value = value * roots[i] + c[k];
            }
            for (std::size_t j = 0; j < n; ++j) {
                value /= j == i ? number_pair(1) : roots[i] - roots[j];
            }
            roots[i] -= value;
            change = std::max(change, std::abs(value));
        }
        if (change < 1e-15 * size) {
            break;
        }
    }
    return roots;
}

}  // namespace

std::vector<std::complex<double>> resonances_at(const path_system& of, const complex_number<mpfr>& time,
                                                const std::vector<complex_number<mpfr>>& carried,
                                                const complex_number<mpfr>& tau,
                                                const std::vector<std::complex<double>>& exponents) {
    using complex = complex_number<mpfr>;
    const std::size_t size = exponents.size();
    if (size > most_analysed_unknowns || carried.size() != size) {
        return {};
    }
    // The first coefficient of a variation whose initial value is a unit vector is a column of the derivative.
    const tape varied = tape::about_points(with_variations(of.form.lifted));
    taylor_expansion<complex> expansion(varied, 1);
    solution_state<complex> state;
    for (complex& each : varied_values(of.form.lifted, time, carried)) {
        state.push_back({std::move(each)});
    }
    expansion.about(time, state);
    std::vector<std::complex<double>> p;
    for (const std::complex<double>& each : exponents) {
        const bool finite = each.real() >= 0 && std::abs(each.real() - std::round(each.real())) < 1e-9;
        p.push_back(finite ? std::complex<double>(0) : each);
    }
    const complex logarithm = log(tau);
    const std::size_t count = of.form.lifted.leaves.size();
    number_matrix k(size, std::vector<number_pair>(size));
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            const std::complex<double> power = 1.0 + p[j] - p[i];
            const complex factor = exp(logarithm * complex(mpfr(power.real()), mpfr(power.imag())));
            const complex entry = expansion.coefficients(static_cast<int>(count * (j + 1) + i))[1] * factor;
            k[i][j] = {static_cast<double>(entry.re), static_cast<double>(entry.im)};
            if (!(std::abs(k[i][j]) < largest_entry)) {
                return {};
            }
        }
        k[i][i] -= p[i];
    }
    std::vector<number_pair> roots = roots_of(characteristic_polynomial(k));
    std::ranges::sort(roots, [](const number_pair& a, const number_pair& b) {
        return std::abs(a.real() - b.real()) > 1e-6 ? a.real() < b.real() : a.imag() < b.imag();
    });
    return roots;
}

}  // namespace libration::ode
