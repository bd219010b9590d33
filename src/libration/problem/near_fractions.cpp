#include "near_fractions.hpp"

#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"

namespace libration {

rational fraction_near(const ball& x) {
    rational result;
    const mpfr middle = midpoint_of(x);
    mpfr_get_q(result.backend().data(), handle(middle));
    return result;
}

rational rounded_to(const rational& x, const rational& unit) {
    return rational(nearest_integer(rational(x / unit))) * unit;
}

rational power_of_ten_below(const rational& x) {
    rational power(1);
    while (power > x) {
        power /= 10;
    }
    while (power * 10 <= x) {
        power *= 10;
    }
    return power;
}

ode::decimal_interval interval_about(const ball& value, const rational& reach) {
    const rational unit = power_of_ten_below(reach / 4);
    const rational middle = rounded_to(fraction_near(value), unit);
    const rational low = middle - 3 * unit;
    const rational high = middle + 3 * unit;
    return {low.str(), high.str(), low, high};
}

}  // namespace libration
