// The approximants that the series of an unknown about the start makes, against the solution at times of an interval.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libration/approximant/endpoint_approximant.hpp"
#include "libration/approximant/pade.hpp"
#include "solution_on_interval.hpp"

namespace libration::studies::of_equation {

/// What a list of coefficients is made into.
enum class approximation { series, pade, endpoint };

inline std::string name_of(approximation method) {
    return method == approximation::series ? "series" : method == approximation::pade ? "pade" : "endpoint";
}

/// One unknown: its approximants against the solution.
template <rounding_scalar T>
class unknown_on_interval {
public:
    /// A largest difference and the place of its time; inf where the approximant is not finite.
    struct largest_error {
        mpfr norm;
        std::size_t place = 0;
    };

    unknown_on_interval(const series_about_start<T>& of, const solution_on_interval& truth, int unknown)
        : truth_(truth),
          values_(truth.values[static_cast<std::size_t>(unknown)]),
          stride_(of.tape.stride()),
          first_(std::max(0, of.tape.residue_of(unknown))),
          scaled_(of.expansion.series_of(unknown)) {
        const int root = of.tape.root();
        unit_ = root_of(truth.one_sided || root == 1 ? truth.reach() : mpfr(abs(truth.reach())), root);
        T power(1);
        for (int n = 0; n <= scaled_.order(); ++n, power *= unit_) {
            scaled_[n] *= power;
        }
        for (const mpfr& t : truth.times) {
            x_.push_back(T(root_of(mpfr(t - truth.start), root) / unit_));
        }
        if (truth.one_sided) {
            const auto i = static_cast<std::size_t>(unknown);
            end_ = {narrow<T>(values_[truth.far]), narrow<T>(mpfr(truth.slopes[i] * truth.reach() * root))};
        }
    }

    /// Nothing where there is no such approximant of this order.
    std::optional<largest_error> error_of(approximation method, int order) const {
        switch (method) {
            case approximation::series: {
                const auto sum = cut(order);
                return largest([&](const T& x) { return evaluate_value(sum, x); });
            }
            case approximation::pade: return error_of_pade(order);
            default: break;
        }
        if (!truth_.one_sided) {
            return std::nullopt;
        }
        const endpoint_approximant<T> approximant(cut(order), end_);
        return largest([&](const T& x) { return approximant.value(x); });
    }

    /// The partial sum of an order at the time of that place.
    T partial_sum(int order, std::size_t place) const { return evaluate_value(cut(order), x_[place]); }

private:
    // The real root; of a negative number there is an odd one alone.
    static T root_of(const mpfr& x, int root) {
        if (root > 1 && x < 0) {
            throw error(error_kind::argument, "time", "", "is before the start, where the solution is not real");
        }
        return narrow<T>(root == 1 ? x : mpfr(pow(x, mpfr(mpfr(1) / root))));
    }

    series::power_series<T> cut(int order) const {
        const auto& all = scaled_.coefficients();
        return series::power_series<T>({all.begin(), all.begin() + std::ptrdiff_t{order} + 1});
    }

    // [m/m] of the list without what symmetry leaves out, in powers of x^stride, m the half of its last power; of
    // smaller degrees where that does not exist.
    std::optional<largest_error> error_of_pade(int order) const {
        std::vector<T> part;
        for (int n = first_; n <= order; n += stride_) {
            part.push_back(scaled_[n]);
        }
        if (part.empty()) {
            return std::nullopt;
        }
        const series::power_series<T> list(std::move(part));
        for (int m = list.order() / 2; m >= 0; --m) {
            if (const auto found = pade(list, m, m)) {
                return largest([&](const T& x) {
                    const T z = integer_power(x, stride_);
                    const T quotient = evaluate_value(found->numerator, z) / evaluate_value(found->denominator, z);
                    return T(integer_power(x, first_) * quotient);
                });
            }
        }
        return std::nullopt;
    }

    static T integer_power(const T& x, int n) {
        T power(1);
        for (int i = 0; i < n; ++i) {
            power *= x;
        }
        return power;
    }

    template <class F>
    largest_error largest(const F& f) const {
        largest_error found{mpfr(0), 0};
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const mpfr difference = abs(mpfr(widen(f(x_[i])) - values_[i]));
            if (mpfr_number_p(handle(difference)) == 0) {
                return {mpfr("inf"), i};
            }
            if (difference > found.norm) {
                found = {difference, i};
            }
        }
        return found;
    }

    const solution_on_interval& truth_;
    const std::vector<mpfr>& values_;
    int stride_;
    int first_;
    series::power_series<T> scaled_;
    T unit_ = T(1);
    std::vector<T> x_;
    std::vector<T> end_;
};

}  // namespace libration::studies::of_equation
