// The solution about a point of the complex t-plane in rounded arithmetic, and the nearest singularity estimated from
// its coefficients. Nothing here is proved.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/expansion/taylor_expansion.hpp"

namespace libration::ode {

/// A system for paths in the plane: its polynomial form, which continues multivalued functions along the path. The
/// initial point may be regular singular; throws error if the series there is in powers of a root, or if there are such
/// functions.
struct path_system {
    explicit path_system(const explicit_system& system);

    path_form form;
    tape points;
    number origin;
    /// Number of unknowns and lower derivatives of the given system; they are the first of the carried unknowns, in
    /// order.
    std::size_t given = 0;
    /// Their initial values.
    std::vector<number> starts;
    /// The indices of the unknowns themselves among them.
    std::vector<std::size_t> functions;
    /// The series about the initial point if that is singular: in the given unknowns and orders.
    std::optional<tape> singular;
    /// The polynomial form whose unknowns are all carried, if they are.
    std::optional<polynomial_form> first;
};

/// The nearest singularity as estimated from ratios of coefficients.
template <rounding_scalar T>
struct nearest_estimate {
    complex_number<T> distance;  ///< from the point of the series
    double agreement;            ///< the relative difference of two estimates
};

/// The Taylor polynomials of the carried unknowns about t0 + offset.
template <rounding_scalar T>
class local_series {
public:
    using complex = complex_number<T>;

    local_series(const path_system& of, int order)
        : of_(&of), expansion_(of.points, order), origin_(constant_value<T>::of(of.origin)) {}

    /// Expands about the initial point.
    void about_start() {
        if (of_->singular) {
            about_singular_start();
            return;
        }
        std::vector<complex> values;
        for (const number& each : of_->starts) {
            values.push_back(constant_value<complex>::of(each));
        }
        if (of_->first) {
            values = of_->form.given_of(lifted_values(*of_->first, complex(origin_), values));
        }
        about(complex(0), values);
    }

    /// Expands about a point from the carried unknowns there; not for a singular initial point.
    void about(const complex& offset, const std::vector<complex>& values) {
        at_singular_start_.clear();
        offset_ = offset;
        const complex time = complex(origin_) + offset;
        solution_state<complex> state;
        for (complex& each : lifted_values(of_->form.lifted, time, values)) {
            state.push_back({std::move(each)});
        }
        expansion_.about(time, state);
    }

    const complex& offset() const { return offset_; }
    int order() const { return expansion_.order(); }
    /// Number of carried unknowns, and how many of them, the first ones, are given.
    std::size_t carried() const { return of_->form.lifted.given; }
    std::size_t given() const { return of_->given; }
    const complex* coefficients(std::size_t unknown) const {
        return at_singular_start_.empty() ? expansion_.coefficients(static_cast<int>(unknown))
                                          : at_singular_start_[unknown].data();
    }

    /// The carried unknowns at t0 + offset.
    std::vector<complex> values_at(const complex& offset) const {
        const complex distance = offset - offset_;
        std::vector<complex> values;
        for (std::size_t i = 0; i < carried(); ++i) {
            const complex* const a = coefficients(i);
            complex sum = a[order()];
            for (int n = order() - 1; n >= 0; --n) {
                sum = sum * distance + a[n];
            }
            values.push_back(std::move(sum));
        }
        return values;
    }

    /// log2 of the radius of convergence of the given unknowns, by the slope of log |a_n| between the middle and the
    /// end; infinity if the series terminates. A symmetry may leave only every `stride`-th coefficient.
    double log_of_radius(int stride = 1) const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < given(); ++i) {
            const auto end = largest_in(i, order() - std::max(3, stride), order());
            const auto middle = largest_in(i, order() / 2 - std::max(3, stride), order() / 2);
            if (end.first >= 0 && middle.first >= 0 && end.first > middle.first) {
                least = std::min(least, (middle.second - end.second) / (end.first - middle.first));
            }
        }
        return least;
    }

    /// If one algebraic singularity z is nearest, (n + 1) a_{n+1}/a_n = (n - alpha)/z for y ~ (1 - s/z)^alpha: the
    /// differences of neighbours are 1/z, correct to O(n^-2), from which one step of Richardson's extrapolation over n
    /// and n/2 removes the first term. Of the unknowns at these indices the one with the best agreement is used.
    /// Returns std::nullopt if there is no agreement, and ignores unknowns whose last coefficients are rounding errors
    /// of those of the others.
    std::optional<nearest_estimate<T>> nearest(const std::vector<std::size_t>& of) const {
        std::optional<nearest_estimate<T>> best;
        const bool is_part = of.size() < given();
        const double radius = is_part ? log_of_radius() : 0;
        for (const std::size_t i : of) {
            if (is_part && is_rounding(i, radius)) {
                continue;
            }
            const auto found = nearest_by(i);
            if (found && (!best || found->agreement < best->agreement)) {
                best = found;
            }
        }
        return best;
    }

    /// alpha of unknown i for a singularity at `distance` from the point, extrapolated once over n and n/2, n + 1 the
    /// index of the last coefficient used.
    complex exponent(std::size_t unknown, const complex& distance, int last) const {
        const auto at = [&](int n) {
            const complex ratio = ratio_of(unknown, n);
            return complex(T(n)) - ratio * distance;
        };
        const int n = last - 1;
        const int half = last / 2;
        return (at(n) * T(n) - at(half) * T(half)) / T(n - half);
    }

    /// log2 of the largest |a_n| r^n of an unknown, log2 r given; -infinity if all coefficients are 0.
    double log_of_size(std::size_t unknown, double log_of_radius) const {
        double largest = -std::numeric_limits<double>::infinity();
        for (int n = 0; n <= order(); ++n) {
            largest = std::max(largest, log_of(coefficients(unknown)[n]) + n * log_of_radius);
        }
        return largest;
    }

private:
    // The number of bits of a scalar that may be lost to rounding errors in the recurrences of a series.
    static constexpr double rounded_bits = 12;

    // Whether the last coefficients, in units of the radius of all unknowns, are below the rounding errors of the first
    // ones: then the ratios are those of rounding errors, which grow like the coefficients of the other unknowns.
    bool is_rounding(std::size_t unknown, double log_of_radius) const {
        const double last = std::max(log_of(coefficients(unknown)[order()]) + order() * log_of_radius,
                                     log_of(coefficients(unknown)[order() - 1]) + (order() - 1) * log_of_radius);
        const auto rounding = static_cast<double>(binary_exponent(T(epsilon<T>())));
        return last < log_of_size(unknown, log_of_radius) + rounding + rounded_bits;
    }

    void about_singular_start() {
        const tape& of = *of_->singular;
        int highest = 0;
        for (const int q : of.orders()) {
            highest = std::max(highest, q);
        }
        taylor_expansion<T> series(of, order() + highest);
        series.about_start();
        at_singular_start_.clear();
        for (std::size_t i = 0; i < of.orders().size(); ++i) {
            const T* const first = series.coefficients(static_cast<int>(i));
            std::vector<T> a(first, first + order() + highest + 1);
            for (int l = 0; l < of.orders()[i]; ++l) {
                at_singular_start_.emplace_back(a.begin(), a.begin() + order() + 1);
                for (std::size_t n = 1; n < a.size(); ++n) {
                    a[n - 1] = a[n] * static_cast<int>(n);
                }
                a.back() = T(0);
            }
        }
        offset_ = complex(0);
    }

    // (n + 1) a_{n+1}/a_n.
    complex ratio_of(std::size_t unknown, int n) const {
        const complex* const a = coefficients(unknown);
        return a[n + 1] / a[n] * T(n + 1);
    }

    static double log_of(const complex& z) {
        const long exponent = std::max(binary_exponent(z.re), binary_exponent(z.im));
        if (exponent == exponent_of_zero) {
            return -std::numeric_limits<double>::infinity();
        }
        using std::ldexp;
        const T scaled = modulus_of(
            complex{T(ldexp(z.re, static_cast<int>(-exponent))), T(ldexp(z.im, static_cast<int>(-exponent)))});
        return std::log2(static_cast<double>(scaled)) + static_cast<double>(exponent);
    }

    // The index and log2 of the largest coefficient of degree from < n <= to.
    std::pair<int, double> largest_in(std::size_t unknown, int from, int to) const {
        std::pair<int, double> found{-1, -std::numeric_limits<double>::infinity()};
        for (int n = std::max(1, from + 1); n <= to; ++n) {
            const double size = log_of(coefficients(unknown)[n]);
            if (size > found.second) {
                found = {n, size};
            }
        }
        return found;
    }

    std::optional<nearest_estimate<T>> nearest_by(std::size_t unknown) const {
        const complex* const a = coefficients(unknown);
        const int n = order() - 1;
        const int half = order() / 2;
        for (const int k : {n + 1, n, n - 1, n - 2, half + 1, half, half - 1}) {
            if (a[k].re == 0 && a[k].im == 0) {
                return std::nullopt;
            }
        }
        const complex last = ratio_of(unknown, n) - ratio_of(unknown, n - 1);
        const complex before = ratio_of(unknown, n - 1) - ratio_of(unknown, n - 2);
        const complex middle = ratio_of(unknown, half) - ratio_of(unknown, half - 1);
        const T of_n(static_cast<double>(n) * n);
        const T of_half(static_cast<double>(half) * half);
        const complex inverse = (last * of_n - middle * of_half) / T(of_n - of_half);
        const T size = modulus_of(inverse);
        if (!(size > 0)) {
            return std::nullopt;
        }
        const auto spread = static_cast<double>(T(modulus_of(last - before) / size));
        const auto correction = static_cast<double>(T(modulus_of(last - inverse) / size));
        return nearest_estimate<T>{complex(T(1)) / inverse, std::max(spread * n / 8, correction)};
    }

    const path_system* of_;
    taylor_expansion<complex> expansion_;
    T origin_;
    complex offset_;
    std::vector<std::vector<complex>> at_singular_start_;  ///< the coefficients there, otherwise empty
};

}  // namespace libration::ode
