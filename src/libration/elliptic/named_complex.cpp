// The twelve functions of Jacobi at complex arguments, by the addition theorem and Jacobi's imaginary transformation.
#include <array>

#include "named_values.hpp"

namespace libration::elliptic {

namespace {

complex_parts quotient_of(const complex_parts& a, const complex_parts& b, const ball& squared) {
    return {(a.real * b.real + a.imaginary * b.imaginary) / squared,
            (a.imaginary * b.real - a.real * b.imaginary) / squared};
}

// sn, cn, dn and 1, times c1^2 + m s^2 s1^2.
struct scaled_triple {
    std::array<complex_parts, 4> values;

    const complex_parts& of_letter(char letter) const {
        return values[letter == 's' ? 0U : letter == 'c' ? 1U : letter == 'd' ? 2U : 3U];
    }
};

scaled_triple triple_at_complex(const exact& x, const exact& y, const real_parameter& p) {
    const auto [s, c, d] = triple_at(x, p);
    const auto [s1, c1, d1] = triple_at(y, real_parameter::from_parameter(p.complement()));
    const auto m = from_exact<ball>(p.m());
    return {{complex_parts{s * d1, c * d * s1 * c1}, complex_parts{c * c1, -(s * d * s1 * d1)},
             complex_parts{d * c1 * d1, -(m * s * c * s1)}, complex_parts{c1 * c1 + m * s * s * s1 * s1, ball(0)}}};
}

}  // namespace

std::optional<complex_parts> complex_quotient(std::string_view name, const exact& x, const exact& y,
                                              const real_parameter& parameter) {
    const named_function* const function = find_function(name);
    if (function == nullptr || function->value != quotient_value) {
        throw error(error_kind::argument, "function", std::string(name), "has real arguments only");
    }
    const char above = letter_at(name[0], parameter.where());
    const char below = letter_at(name[1], parameter.where());
    if (above == below) {
        return complex_parts{ball(1), ball(0)};
    }
    const scaled_triple at = triple_at_complex(x, y, parameter);
    const complex_parts& divisor = at.of_letter(below);
    const ball squared = divisor.real * divisor.real + divisor.imaginary * divisor.imaginary;
    if (is_exact_zero(squared)) {
        return std::nullopt;
    }
    return quotient_of(at.of_letter(above), divisor, squared);
}

}  // namespace libration::elliptic
