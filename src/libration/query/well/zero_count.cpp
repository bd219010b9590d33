#include "zero_count.hpp"

#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr long most_bisections = 14;

// In a part [k, k + 1] 2^-level of the step. `sign` is that just after its beginning, and becomes that at its end.
std::optional<long> zeros_in_part(const linear_series& solution, long k, long level, int& sign) {
    const ball part = ldexp(hull(ball(k), ball(k + 1)), -level);
    if (!contains_zero(solution.value(part))) {
        return 0;
    }
    if (!contains_zero(solution.slope(part))) {
        const ball end = solution.value(ldexp(ball(k + 1), -level));
        if (contains_zero(end)) {
            return std::nullopt;
        }
        const int after = arb_is_positive(end.handle()) != 0 ? 1 : -1;
        const long zeros = after == sign ? 0 : 1;
        sign = after;
        return zeros;
    }
    if (level >= most_bisections) {
        return std::nullopt;
    }
    const auto first = zeros_in_part(solution, 2 * k, level + 1, sign);
    const auto second = first ? zeros_in_part(solution, 2 * k + 1, level + 1, sign) : std::nullopt;
    return second ? std::optional(*first + *second) : std::nullopt;
}

}  // namespace

std::optional<long> zeros_in_step(const linear_series& solution, int sign) {
    return zeros_in_part(solution, 0, 0, sign);
}

}  // namespace libration::ode
