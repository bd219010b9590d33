// The progress of an integration from the initial point to the last of a list of times.
#pragma once

#include <algorithm>
#include <vector>

#include "libration/ode/constant_value.hpp"
#include "libration/ode/proved/proved_march.hpp"
#include "libration/problem/answer.hpp"
#include "libration/scalar/ball/predicates.hpp"
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

}  // namespace libration
