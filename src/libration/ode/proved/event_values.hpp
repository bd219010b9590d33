// Values and bounds of events, and the precision up to which they are examined.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/text/printed_number.hpp"

namespace libration::ode {

// An event undecided with this number of bits, and this multiple of those of the first run, is rejected.
inline constexpr long most_undecided_bits = 4096;
inline constexpr long most_undecided_factor = 16;
inline constexpr long digits_of_bounds = 12;

// The value of each unknown that g = 0 determines by itself: that of a leaf in which g is linear, without other leaves.
inline std::vector<std::optional<number>> given_values(const explicit_system& system, const expression& g) {
    std::vector<std::optional<number>> values;
    for (const unknown_function& each : system.unknowns()) {
        for (int j = 0; j < each.order; ++j) {
            const expression leaf = unknown(each.name, j);
            const expression factor = partial(g, leaf);
            values.emplace_back();
            if (factor.kind() != node_kind::constant || factor.is(0)) {
                continue;  // g is not linear in it, and may have no value where the leaf is 0
            }
            const expression rest = replaced(g, [&](const expression& other) -> std::optional<expression> {
                return same_form(other, leaf) ? std::optional(expression()) : std::nullopt;
            });
            if (rest.kind() == node_kind::constant) {
                values.back() = -(rest.constant() / factor.constant());
            }
        }
    }
    return values;
}

// An exact number, rounded down or up.
inline std::string bound_text(const ball& exact, mpfr_rnd_t rounding) {
    const mpfr value = midpoint_of(exact);
    return value == 0 ? "0" : parts_of(value, digits_of_bounds, rounding).text();
}

// Decimals between which every number of the ball lies.
inline std::string bounds_text(const ball& x) {
    return "[" + bound_text(lower_bound(x), MPFR_RNDD) + ", " + bound_text(upper_bound(x), MPFR_RNDU) + "]";
}

}  // namespace libration::ode
