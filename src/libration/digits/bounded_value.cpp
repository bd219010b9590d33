#include "libration/digits/bounded_value.hpp"

#include <optional>
#include <string>

namespace libration {

mpfr value_within_bound(long digits, long lost, const std::function<bounded_value()>& compute) {
    const growing_digits runs{digits, lost + 10, lost + most_bound_digits};
    return with_growing_precision(
        runs, std::to_string(digits) + " digits", [&](const precision_run& /*run*/) -> std::optional<mpfr> {
            const bounded_value at = compute();
            // A hundredth of a unit in the last digit: rounding to nearest then stays within one.
            const bool enough = at.error <= abs(at.value) * pow(mpfr(10), static_cast<int>(-digits - 2));
            return enough && at.value != 0 ? std::optional(at.value) : std::nullopt;
        });
}

}  // namespace libration
