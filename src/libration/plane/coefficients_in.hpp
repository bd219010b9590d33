// The coefficients of an expression as a polynomial in one of its leaves.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "libration/equation/expression.hpp"

namespace libration::ode {

// Those of y^0 .. y^most in f, expressions without y; std::nullopt if f is not shown to be such a polynomial.
inline std::optional<std::vector<expression>> coefficients_in(const expression& f, const expression& y, int most) {
    std::vector<expression> derived{f};
    for (int k = 0; k <= most; ++k) {
        derived.push_back(partial(derived.back(), y));
    }
    if (!derived.back().is(0)) {
        return std::nullopt;
    }
    std::vector<expression> coefficients;
    int factorial = 1;
    for (int k = 0; k <= most; ++k) {
        const expression at_zero = replaced(derived[static_cast<std::size_t>(k)], [&](const expression& leaf) {
            return same_form(leaf, y) ? std::optional(expression(0)) : std::nullopt;
        });
        coefficients.push_back(at_zero / factorial);
        factorial *= k + 1;
    }
    return coefficients;
}

}  // namespace libration::ode
