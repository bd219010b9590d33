// The largest errors of approximants of an equation at times of an interval, to digits on which two runs agree.
#pragma once

#include <vector>

#include "agreed_numbers.hpp"
#include "libration/scalar/dispatch.hpp"
#include "unknown_on_interval.hpp"

namespace libration::studies {

/// A norm: of which approximant of which unknown, and at which of the times.
struct found_norm {
    int order;
    approximation method;
    int unknown;
    mpfr norm;
    std::size_t place = 0;
    bool agreed = false;
    bool there = true;  ///< whether there is such an approximant
};

/// The requested norms of a system, and the number of their digits.
struct asked_norms {
    const ode::explicit_system& system;
    const std::vector<ode::number>& times;
    std::vector<int> unknowns;
    std::vector<approximation> methods;
};

/// The norms in mpfr: the solution and the coefficients are computed once per precision and shared by the orders.
class agreed_norms {
public:
    agreed_norms(asked_norms asked, int highest, long digits)
        : asked_(std::move(asked)), digits_(digits), runs_(asked_.system, asked_.times, highest) {}

    /// The norms of one order, unknown by unknown.
    std::vector<found_norm> of_order(int order) {
        std::vector<found_norm> norms;
        for (const int unknown : asked_.unknowns) {
            for (const approximation method : asked_.methods) {
                norms.push_back({order, method, unknown, mpfr(0)});
            }
        }
        const auto found = agreed_numbers(digits_, [&](long guard) {
            const precision_scope scope(digits_ + guard);
            const interval_run& here = runs_.at(digits_ + guard);
            std::vector<mpfr> values;
            for (found_norm& each : norms) {
                const auto error = here.unknowns[static_cast<std::size_t>(each.unknown)].error_of(each.method, order);
                each.there = error.has_value();
                each.place = error ? error->place : 0;
                values.push_back(error ? error->norm : mpfr(1));
            }
            return values;
        });
        for (std::size_t i = 0; i < norms.size(); ++i) {
            norms[i].norm = found[i].value;
            norms[i].agreed = found[i].agreed;
        }
        return norms;
    }

    /// The largest value of an unknown at the times.
    mpfr size_of(int unknown) {
        const precision_scope scope(digits_ + 20);
        mpfr largest(0);
        for (const mpfr& value : runs_.at(digits_ + 20).truth.values[static_cast<std::size_t>(unknown)]) {
            largest = std::max(largest, mpfr(abs(value)));
        }
        return largest;
    }

private:
    asked_norms asked_;
    long digits_;
    interval_runs runs_;
};

inline constexpr long digits_of_truth = 60;  ///< of the reference for fixed scalars

/// The norms of these orders in a fixed scalar, as it computes them.
template <fixed_scalar T>
std::vector<found_norm> norms_in(const asked_norms& asked, const std::vector<int>& orders) {
    const precision_scope scope(digits_of_truth);
    const auto truth = solve_on(asked.system, asked.times);
    const series_about_start<T> list(asked.system, *std::ranges::max_element(orders));
    std::vector<unknown_on_interval<T>> unknowns;
    for (const int unknown : asked.unknowns) {
        unknowns.emplace_back(list, truth, unknown);
    }
    std::vector<found_norm> norms;
    for (const int order : orders) {
        for (std::size_t i = 0; i < asked.unknowns.size(); ++i) {
            for (const approximation method : asked.methods) {
                const auto error = unknowns[i].error_of(method, order);
                norms.push_back({order, method, asked.unknowns[i], error ? error->norm : mpfr(0),
                                 error ? error->place : 0, false, error.has_value()});
            }
        }
    }
    return norms;
}

/// The norms of these orders in the arithmetic of a scalar: in mpfr correct to its digits.
inline std::vector<found_norm> norms_of(const asked_norms& asked, const std::vector<int>& orders,
                                        const scalar_spec& scalar) {
    return with_scalar(scalar, 0, [&]<class T>() {
        if constexpr (fixed_scalar<T>) {
            return norms_in<T>(asked, orders);
        } else {
            agreed_norms all(asked, *std::ranges::max_element(orders), scalar.digits);
            std::vector<found_norm> norms;
            for (const int order : orders) {
                const auto own = all.of_order(order);
                norms.insert(norms.end(), own.begin(), own.end());
            }
            return norms;
        }
    });
}

}  // namespace libration::studies
