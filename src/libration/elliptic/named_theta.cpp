// Jacobi's theta functions at real z and real nome, by Arb.
#include <array>

#include "libration/elliptic/on_real_line.hpp"
#include "named_values.hpp"

#if __has_include(<flint/acb_modular.h>)
#include <flint/acb.h>
#include <flint/acb_modular.h>
#else
#include <acb.h>
#include <acb_modular.h>
#endif

namespace libration::elliptic {

namespace {

// theta_1 .. theta_4 at zeta = z/pi and tau = i log(1/q)/pi, q > 0.
class theta_quadruple {
public:
    theta_quadruple(const ball& zeta, const ball& q) {
        const on_real_line at(zeta);
        on_real_line tau(ball(-log(q) / pi<ball>()));
        acb_mul_onei(tau.handle(), tau.handle());
        auto& [first, second, third, fourth] = values_;
        acb_modular_theta(first.handle(), second.handle(), third.handle(), fourth.handle(), at.handle(), tau.handle(),
                          ball::working_bits());
    }

    ball real(int j) const { return values_.at(static_cast<std::size_t>(j - 1)).real(); }

private:
    std::array<on_real_line, 4> values_;
};

// Whether theta_1 or theta_2 vanishes there: at integer multiples of pi, and at half-integer multiples.
bool vanishes(int j, const exact& z) {
    if (j > 2 || !(z.is_zero() || z.is_angle())) {
        return false;
    }
    const rational halves = z.is_zero() ? rational(0) : rational(z.in_pi() * 2);
    return denominator(halves) == 1 && (numerator(halves) % 2 != 0) == (j == 2);
}

}  // namespace

true_value theta_value(std::string_view name, const function_arguments& at) {
    int j = name.back() - '0';
    const exact& z = *at.argument;
    const exact& q = at.parameter.m();
    const int sign = sign_of_exact(q);
    if (sign_of_exact(exactly(1) - q * exactly(sign < 0 ? -1 : 1)) <= 0) {
        throw error(error_kind::argument, error_subject::nome, q.text, "is not between -1 and 1");
    }
    if (sign == 0) {
        return exact_value(j <= 2 ? 0 : 1);
    }
    if (sign < 0 && j <= 2) {
        throw error(error_kind::argument, error_subject::nome, q.text,
                    "is negative, where " + std::string(name) + " is not real");
    }
    if (vanishes(j, z)) {
        return exact_value(0);
    }
    j = sign < 0 ? 7 - j : j;  // theta_3(z, q) = theta_4(z, -q)
    const ball zeta = z.is_angle() ? from_rational<ball>(z.in_pi()) : ball(from_exact<ball>(z) / pi<ball>());
    return {theta_quadruple(zeta, abs(from_exact<ball>(q))).real(j)};
}

}  // namespace libration::elliptic
