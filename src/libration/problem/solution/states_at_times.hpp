// What solutions share that have states at times and neither derivatives nor a choice of methods.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/constant_value.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/ode/proved/proved_trajectory.hpp"
#include "libration/problem/answer.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "taylor_solution.hpp"

namespace libration {

/// The distance that has been integrated from a point, as a part of that to the last time.
inline ode::march_watch watch_of(const ode::number& point, const std::vector<ode::number>& times, const request& how) {
    if (!how.progress && !how.reached) {
        return {};
    }
    const precision_scope few(digits_beyond_result);
    const double origin = ode::constant_value<mpfr>::of(point).convert_to<double>();
    double whole = 0;
    for (const ode::number& each : times) {
        whole = std::max(whole, ode::constant_value<mpfr>::of(each).convert_to<double>() - origin);
    }
    return [&how, origin, whole](const ball& reached, long bits) {
        const double time = midpoint_of(reached).convert_to<double>();
        if (how.reached) {
            how.reached(time, bits);
        }
        if (how.progress && whole > 0) {
            how.progress(std::clamp((time - origin) / whole, 0.0, 1.0));
        }
    };
}

/// Throws error for derivatives, collocation and an observer of steps, with the reason `unsupported`.
inline void require_plain_states(const request& how, const std::string& unsupported) {
    if (!how.derivatives.empty()) {
        throw error(error_kind::argument, "derivatives", how.derivatives.front(), unsupported + ": leave it out");
    }
    if (how.integrator == ode::integrator_choice::collocation) {
        throw error(error_kind::argument, "integrator", "collocation", unsupported + ": use automatic or taylor");
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
