// The order in which an integration reaches the times of a list, and how far it came.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "../equation/bound_text.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

/// The indices of times, ascending. Throws error of the kind argument for a time before the initial point; `why` it has
/// to be after it.
inline std::vector<std::size_t> ascending(const std::vector<number>& times, const number& point,
                                          const std::string& why) {
    const precision_scope scope(40);
    std::vector<mpfr> gone;
    for (const number& each : times) {
        gone.push_back(constant_value<mpfr>::of(each - point));
        if (gone.back() < 0) {
            throw error(error_kind::argument, error_subject::time, text_of_time(each),
                        "is before the initial point, " + why + ": choose times after it");
        }
    }
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Times that are not distinguished by the digits of `gone` are compared exactly.
    const mpfr doubt = ldexp(mpfr(1), -100);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const mpfr difference = gone[a] - gone[b];
        return abs(difference) > doubt * (gone[a] + gone[b]) ? difference < 0 : (times[a] - times[b]).sign() < 0;
    });
    return order;
}

/// The fraction of the interval from the initial point to the farthest time that an integration has covered.
inline double part_of_way(const number& point, const ball& reached, const number& farthest) {
    const precision_scope scope(20);
    const mpfr whole = abs(constant_value<mpfr>::of(farthest - point));
    return whole == 0 ? 1
                      : mpfr(abs(midpoint_of(reached - constant_value<ball>::of(point))) / whole).convert_to<double>();
}

}  // namespace libration::ode
