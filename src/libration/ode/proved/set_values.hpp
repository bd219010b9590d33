// Starts of the lifted system from values of the given unknowns, and radii that theorem T is tried with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "libration/ode/lifted_system.hpp"
#include "libration/ode/proved/tail_bound.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

// R in parts that are tried, from the largest on: bounds are sharper near R, and exist further away.
inline constexpr std::array<unsigned long, 7> tried_parts{92, 85, 75, 60, 45, 30, 15};
// Then halves of the last one: the last coefficients say too much where the solution is nearly a polynomial.
inline constexpr int tried_halves = 16;

inline long exponent_of(const magnitude& x) { return x.is_zero() ? std::numeric_limits<int>::min() : x.exponent(); }

// 2^x rounded to 16 bits; how x comes about is no matter of the proof.
inline magnitude power_of_two(double x) {
    const double whole = std::floor(x);
    return magnitude::of(static_cast<unsigned long>(std::exp2(x - whole + 15)), static_cast<long>(whole) - 15);
}

inline double log_of(const magnitude& x) {
    const long exponent = exponent_of(x);
    const double mantissa = mag_get_d((x * magnitude::of(1, -exponent)).handle());
    return std::log2(mantissa) + static_cast<double>(exponent);
}

template <field R>
magnitude largest_of(const std::vector<R>& values) {
    magnitude result;
    for (const R& each : values) {
        result = std::max(result, size_of(each));
    }
    return result;
}

template <field R>
solution_state<R> as_state(const std::vector<R>& values) {
    solution_state<R> state;
    for (const R& each : values) {
        state.push_back({each});
    }
    return state;
}

// log2 of a radius that is none: the last coefficients are 0.
inline constexpr double no_radius = 1'000;

// log2 of the radius of convergence as the last coefficients have it; no_radius where they are all 0.
template <field R>
double estimated_radius(const taylor_expansion<R>& of, std::size_t unknowns, const magnitude& size) {
    double least = no_radius;
    for (int n = of.order() - 1; n <= of.order(); ++n) {
        magnitude largest;
        for (std::size_t i = 0; i < unknowns; ++i) {
            largest = std::max(largest, size_of(of.coefficients(static_cast<int>(i))[n]));
        }
        if (!largest.is_zero() && largest.is_finite()) {
            least = std::min(least, (log_of(size) - log_of(largest)) / n);
        }
    }
    return least;
}

// The first bound that bound_at(radius) gives, radius by radius.
template <class BoundAt>
std::optional<tail_bound> first_tail(double log_of_radius, const BoundAt& bound_at) {
    magnitude radius;
    for (const unsigned long part : tried_parts) {
        radius = power_of_two(log_of_radius) * magnitude::of(part * 328, -15);
        if (std::optional<tail_bound> bound = bound_at(radius)) {
            return bound;
        }
    }
    for (int half = 0; half < tried_halves; ++half) {
        radius *= magnitude::of(1, -1);
        if (std::optional<tail_bound> bound = bound_at(radius)) {
            return bound;
        }
    }
    return std::nullopt;
}

template <field R>
std::optional<tail_bound> tail_near(const tape& of, const taylor_expansion<R>& expansion, const R& point,
                                    double log_of_radius) {
    return first_tail(log_of_radius,
                      [&](const magnitude& radius) { return bounded_tail(of, expansion, point, radius); });
}

// n (n - 1) .. (n - l + 1)
inline ball falling(int n, int l) {
    ball product(1);
    for (int j = 0; j < l; ++j) {
        product *= n - j;
    }
    return product;
}

inline bool is_finite(const complex_number<ball>& z) { return is_finite(z.re) && is_finite(z.im); }

template <field R>
bool all_finite(const std::vector<R>& values) {
    return std::ranges::all_of(values, [](const R& each) { return is_finite(each); });
}

// The starts of a system, to so many bits.
inline std::vector<ball> enclosed_start(const explicit_system& system, long bits) {
    const precision_scope scope(decimal_digits(bits));
    std::vector<ball> values;
    for (const auto& of_unknown : system.starts()) {
        for (const number& each : of_unknown) {
            values.push_back(constant_value<ball>::of(each));
        }
    }
    return values;
}

}  // namespace libration::ode
