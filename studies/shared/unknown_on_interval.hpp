// The approximants from the series of an unknown, compared with the solution at times of an interval.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "problem/approximants_of_unknown.hpp"

namespace libration::studies {

using approximation = list_approximation;

/// One unknown: its approximants compared with the solution.
template <rounding_scalar T>
class unknown_on_interval {
public:
    /// A largest difference and the index of its time; inf if the approximant is not finite.
    struct largest_error {
        mpfr norm;
        std::size_t place = 0;
    };

    unknown_on_interval(const series_about_start<T>& of, const solution_on_interval& truth, int unknown)
        : values_(truth.values[static_cast<std::size_t>(unknown)]), approximants_(of, truth, unknown) {
        for (const mpfr& t : truth.times) {
            x_.push_back(approximants_.coordinate(t));
        }
    }

    /// Returns std::nullopt if there is no such approximant of this order.
    std::optional<largest_error> error_of(approximation method, int order) const {
        const auto found = approximants_.of(method, order);
        return found ? std::optional(largest(*found)) : std::nullopt;
    }

    /// The partial sum of an order at the time with that index.
    T partial_sum(int order, std::size_t place) const {
        return (*approximants_.of(approximation::series, order))(x_[place]);
    }

private:
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

    const std::vector<mpfr>& values_;
    approximants_of_unknown<T> approximants_;
    std::vector<T> x_;
};

/// The solution at the times and the series of all unknowns, computed in the precision in force.
struct interval_run {
    solution_on_interval truth;
    series_about_start<mpfr> series;
    std::vector<unknown_on_interval<mpfr>> unknowns;

    interval_run(const ode::explicit_system& system, const std::vector<ode::number>& times, int order)
        : truth(solve_on(system, times)), series(system, order) {
        for (int i = 0; i < static_cast<int>(system.unknowns().size()); ++i) {
            unknowns.emplace_back(series, truth, i);
        }
    }
};

/// The runs of one system in several precisions, each computed once.
class interval_runs {
public:
    interval_runs(const ode::explicit_system& system, const std::vector<ode::number>& times, int order)
        : system_(system), times_(times), order_(order) {}

    /// In the working precision in force, of so many digits.
    const interval_run& at(long digits) {
        auto& made = runs_[digits];
        if (!made) {
            made = std::make_unique<interval_run>(system_, times_, order_);
        }
        return *made;
    }

private:
    const ode::explicit_system& system_;
    const std::vector<ode::number>& times_;
    int order_;
    std::map<long, std::unique_ptr<interval_run>> runs_;
};

}  // namespace libration::studies
