#include "libration/elliptic/exact_functions.hpp"

#include <algorithm>

namespace libration::elliptic {

int infinite_sign(const exact& phi, const exact_parameter& p) {
    if (!p.complement().is_zero()) {
        return 0;
    }
    const int sign = sign_of_exact(phi);
    const exact quarter_turn{rational(1, 2), unit::pi, "pi/2"};
    return sign_of_exact(sign < 0 ? quarter_turn + phi : quarter_turn - phi) > 0 ? 0 : sign;
}

long digits_before_point(const exact& argument) {
    if (argument.is_zero()) {
        return 0;
    }
    const precision_scope rough(20);
    return decimal_digits(std::max(0L, binary_exponent(from_exact<mpfr>(argument))));
}

}  // namespace libration::elliptic
