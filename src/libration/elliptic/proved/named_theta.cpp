// Jacobi's theta functions at real z and real nome, by Arb.
#include "named_values.hpp"

#if __has_include(<flint/acb_modular.h>)
#include <flint/acb_modular.h>
#else
#include <acb_modular.h>
#endif

namespace libration::elliptic {

namespace {

// theta_1 .. theta_4 at zeta = z/pi and tau = i log(1/q)/pi, q > 0.
class theta_quadruple {
public:
    theta_quadruple(const ball& zeta, const ball& q) {
        acb_t at;
        acb_t tau;
        acb_init(at);
        acb_init(tau);
        for (acb_struct& each : values_) {
            acb_init(&each);
        }
        acb_set_arb(at, zeta.handle());
        arb_set(acb_imagref(tau), ball(-log(q) / pi<ball>()).handle());
        acb_modular_theta(&values_[0], &values_[1], &values_[2], &values_[3], at, tau, ball::working_bits());
        acb_clear(at);
        acb_clear(tau);
    }
    theta_quadruple(const theta_quadruple&) = delete;
    theta_quadruple& operator=(const theta_quadruple&) = delete;
    ~theta_quadruple() {
        for (acb_struct& each : values_) {
            acb_clear(&each);
        }
    }

    ball real(int j) const {
        ball result;
        arb_set(result.handle(), acb_realref(&values_[j - 1]));
        return result;
    }

private:
    acb_struct values_[4];
};

// Whether theta_1 or theta_2 vanishes there: at whole multiples of pi, and those and a half.
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
        throw error(error_kind::argument, "q", q.text, "is not between -1 and 1");
    }
    if (sign == 0) {
        return exact_value(j <= 2 ? 0 : 1);
    }
    if (sign < 0 && j <= 2) {
        throw error(error_kind::argument, "q", q.text, "is negative, where " + std::string(name) + " is not real");
    }
    if (vanishes(j, z)) {
        return exact_value(0);
    }
    j = sign < 0 ? 7 - j : j;  // theta_3(z, q) = theta_4(z, -q)
    const ball zeta = z.is_angle() ? from_rational<ball>(z.in_pi()) : ball(from_exact<ball>(z) / pi<ball>());
    return {theta_quadruple(zeta, abs(from_exact<ball>(q))).real(j)};
}

}  // namespace libration::elliptic
