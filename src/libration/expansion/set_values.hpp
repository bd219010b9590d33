// Initial values of the polynomial form from values of the given unknowns, and radii to try in theorem T.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/tail_bound.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

// The percentages of R that are tried, in descending order: bounds are sharper near R but need not exist there.
inline constexpr std::array<unsigned long, 7> tried_parts{92, 85, 75, 60, 45, 30, 15};
// Then about 2^-1, 2^-3, 2^-7, .. 2^-63 times the last one, for smooth solutions of stiff equations; down to 2^-32767
// if the coefficients give no estimate.
inline constexpr int tried_powers = 6;
inline constexpr int tried_powers_without_estimate = 15;

// A lower bound of |x|.
inline magnitude least_size_of(const ball& x) { return magnitude::below(x); }
inline magnitude least_size_of(const complex_number<ball>& x) {
    return std::max(magnitude::below(x.re), magnitude::below(x.im));
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

// log2 of a radius that no coefficient limits.
inline constexpr double no_radius = std::numeric_limits<double>::infinity();

// log2 of the largest radius that is tried if no coefficient limits it, relative to the scale of the series.
inline constexpr double largest_tried = 1'000;

// The number of first and of last powers of a series from which its radius is estimated.
inline constexpr std::size_t powers_of_estimate = 4;

// A power and log2 |a_n|, to within 1.
struct power_size {
    int power;
    long exponent;
};

// log2 of the radius of convergence of a series by its coefficients: the least over the last powers n of the largest
// over the first powers m of log2(|a_m|/|a_n|)/(n - m). Coefficients 0 do not count, so that missing powers have no
// effect; neither has the unit of the unknown. no_radius if all coefficients of the first or of the second half are 0.
// The size of a coefficient that does not count is 0.
template <class R, class SizeOf>
double estimated_radius(const R* coefficients, int order, const SizeOf& size_of_coefficient) {
    std::array<power_size, powers_of_estimate> first{};
    std::size_t count = 0;
    for (int m = 0; m <= order / 2 && count < powers_of_estimate; ++m) {
        if (const magnitude size = size_of_coefficient(coefficients[m]); !size.is_zero() && size.is_finite()) {
            first[count++] = {m, size.exponent()};
        }
    }
    double least = no_radius;
    std::size_t seen = 0;
    for (int n = order; count > 0 && n > order / 2 && seen < powers_of_estimate; --n) {
        const magnitude size = size_of_coefficient(coefficients[n]);
        if (size.is_zero() || !size.is_finite()) {
            continue;
        }
        ++seen;
        double largest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < count; ++i) {
            largest =
                std::max(largest, static_cast<double>(first[i].exponent - size.exponent()) / (n - first[i].power));
        }
        least = std::min(least, largest);
    }
    return least;
}

// The least of the radii of the first unknowns; by upper bounds of the coefficients if all of them may be 0, as for a
// wide set.
template <field R>
double estimated_radius(const taylor_expansion<R>& of, std::size_t unknowns) {
    const auto least_by = [&](const auto& size) {
        double least = no_radius;
        for (std::size_t i = 0; i < unknowns; ++i) {
            least = std::min(least, estimated_radius(of.coefficients(static_cast<int>(i)), of.order(), size));
        }
        return least;
    };
    const double certain = least_by([](const R& a) { return least_size_of(a); });
    return certain < no_radius ? certain : least_by([](const R& a) { return size_of(a); });
}

// log2 of the distance over which a series changes as a whole: the largest |a_m/a_n|^(1/(n - m)) with n > m, a_m the
// first nonzero coefficient; at least 1.
template <field R>
double scale_of_series(const R* coefficients, int order) {
    std::optional<power_size> first;
    double scale = 0;
    for (int n = 0; n <= order; ++n) {
        const magnitude size = least_size_of(coefficients[n]);
        if (size.is_zero() || !size.is_finite()) {
            continue;
        }
        if (first) {
            scale = std::max(scale, static_cast<double>(first->exponent - size.exponent()) / (n - first->power));
        } else {
            first = {n, size.exponent()};
        }
    }
    return scale;
}

// The first bound that bound_at(radius) returns for decreasing radii; if that radius is far below the estimate, the
// largest possible one within a factor of 2.
template <class BoundAt>
std::optional<tail_bound> first_tail(double log_of_radius, const BoundAt& bound_at) {
    for (const unsigned long part : tried_parts) {
        if (auto bound = bound_at(power_of_two(log_of_radius) * magnitude::of(part * 328, -15))) {
            return bound;
        }
    }
    double failed = log_of_radius - 3;
    double distance = 1;
    std::optional<tail_bound> found;
    const int powers = log_of_radius < largest_tried ? tried_powers : tried_powers_without_estimate;
    for (int power = 0; power < powers && !found; ++power, distance *= 2) {
        found = bound_at(power_of_two(failed - distance));
        failed -= found ? 0 : distance;
    }
    for (double within = distance / 2; found && within > 1; within /= 2) {
        if (auto larger = bound_at(power_of_two(failed - within / 2))) {
            found = std::move(larger);
        } else {
            failed -= within / 2;
        }
    }
    return found;
}

template <field R>
std::optional<tail_bound> tail_near(const tape& of, const taylor_expansion<R>& expansion, const R& point,
                                    double log_of_radius) {
    if (log_of_radius == no_radius) {
        log_of_radius = largest_tried;
        for (std::size_t i = 0; i < of.orders().size(); ++i) {
            log_of_radius = std::max(
                log_of_radius,
                largest_tried + scale_of_series(expansion.coefficients(static_cast<int>(i)), expansion.order()));
        }
    }
    const series_sizes sizes = sizes_of(of, expansion, point, expansion.order());
    return first_tail(log_of_radius, [&](const magnitude& radius) { return bounded_tail(of, sizes, radius); });
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

// The initial values of a system, with so many bits.
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
