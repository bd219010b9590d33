#include "libration/elliptic/exact_functions.hpp"

#include <algorithm>
#include <optional>

#include "libration/digits/growing_precision.hpp"

namespace libration {

namespace {

// More than a number can be typed with.
constexpr long most_digits_typed = 500'000;

// Whether |phi|, a fraction, is below pi/2. Error of the difference: half a unit of each of the three roundings.
bool below_quarter_turn(const exact& phi) {
    return with_growing_precision({0, 50, most_digits_typed}, "whether " + phi.text + " is below pi/2",
                                  [&](const precision_run& /*run*/) -> std::optional<bool> {
                                      const mpfr size = abs(from_exact<mpfr>(phi));
                                      const mpfr rest = size - pi<mpfr>() / 2;
                                      const bool decided = abs(rest) > epsilon<mpfr>() * (size + 2) * 2;
                                      return decided ? std::optional(rest < 0) : std::nullopt;
                                  });
}

}  // namespace

int infinite_sign(const exact& phi, const exact_parameter& p) {
    if (p.complement() != 0) {
        return 0;
    }
    const bool below = phi.measure == unit::one ? below_quarter_turn(phi) : abs(phi.in_pi()) < rational(1, 2);
    return below ? 0 : phi.coefficient.sign();
}

long digits_before_point(const exact& argument) {
    if (argument.is_zero()) {
        return 0;
    }
    const precision_scope rough(20);
    return decimal_digits(std::max(0L, binary_exponent(from_exact<mpfr>(argument))));
}

}  // namespace libration
