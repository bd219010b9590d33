// What solutions share that have states at times.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/constant_value.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/answer.hpp"
#include "libration/query/flow_derivatives.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "taylor_solution.hpp"

namespace libration {

/// The distance that has been integrated from a point, as a part of that to the farthest time.
inline ode::march_watch watch_of(const ode::number& point, const std::vector<ode::number>& times, const request& how) {
    if (!how.progress && !how.reached) {
        return {};
    }
    const precision_scope few(digits_beyond_result);
    const auto origin = ode::constant_value<mpfr>::of(point).convert_to<double>();
    double whole = 0;
    for (const ode::number& each : times) {
        whole = std::max(whole, std::abs(ode::constant_value<mpfr>::of(each).convert_to<double>() - origin));
    }
    return [&how, origin, whole](const ball& reached, long bits) {
        const auto time = midpoint_of(reached).convert_to<double>();
        if (how.reached) {
            how.reached(time, bits);
        }
        if (how.progress && whole > 0) {
            how.progress(std::clamp(std::abs(time - origin) / whole, 0.0, 1.0));
        }
    };
}

/// The columns of states: the quantities and, after them, the derivatives of each.
inline std::vector<std::string> names_of_states(const std::vector<std::string>& quantities, const std::string& variable,
                                                const request& how) {
    std::vector<std::string> names = quantities;
    for (const std::string& quantity : quantities) {
        for (const std::string& number : how.derivatives) {
            names.push_back(derivative_name(quantity, variable, number));
        }
    }
    return names;
}

/// Values and derivatives in the order of these columns.
inline ode::partial_trajectory in_columns(ode::partial_derivatives found, std::size_t columns) {
    for (std::size_t i = 0; i < found.by.size(); ++i) {
        auto& values = found.trajectory.states[i];
        if (values.empty()) {
            continue;
        }
        for (auto& row : found.by[i]) {
            std::ranges::move(row, std::back_inserter(values));
        }
        values.resize(columns);
    }
    return std::move(found.trajectory);
}

/// Throws error for derivatives of values that are not proved.
inline void require_proof_of_derivatives(const request& how) {
    if (!how.derivatives.empty() && how.scalar.kind != scalar_kind::proved) {
        throw error(error_kind::argument, error_subject::derivatives, how.derivatives.front(),
                    "is for proved digits, and these are rounded: use the scalar ball:D");
    }
}

/// Throws error for collocation, the comparison system and an observer of steps, with the reason `unsupported`.
inline void require_plain_states(const request& how, const std::string& unsupported) {
    const bool compares = how.integrator == ode::integrator_choice::comparison;
    if (compares || how.integrator == ode::integrator_choice::collocation) {
        throw error(error_kind::argument, error_subject::integrator, compares ? "comparison" : "collocation",
                    unsupported + ": use automatic or taylor");
    }
    if (how.observer) {
        throw error(error_kind::argument, "observer", "of steps", unsupported + ": leave it out");
    }
}

/// Throws error unless the decimals that both proofs found agree.
inline void require_agreement(const ode::partial_trajectory& one, const ode::partial_trajectory& other,
                              const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < one.states.size(); ++i) {
        for (std::size_t k = 0; k < std::min(one.states[i].size(), other.states[i].size()); ++k) {
            const auto& a = one.states[i][k].decimal;
            const auto& b = other.states[i][k].decimal;
            if (a && b) {
                require_agreement(*a, *b, names[k]);
            }
        }
    }
}

}  // namespace libration
