// Jacobi's functions by Arb's theta functions: a method that shares only Arb's arithmetic with the Landen descents.
#pragma once

#if __has_include(<flint/acb_modular.h>)
#include <flint/acb.h>
#include <flint/acb_elliptic.h>
#include <flint/acb_modular.h>
#else
#include <acb.h>
#include <acb_elliptic.h>
#include <acb_modular.h>
#endif

#include <array>

#include "libration/elliptic/jacobi.hpp"
#include "libration/scalar/ball/ball.hpp"

namespace libration::tests {

/// theta_1 .. theta_4 at the argument pi x and the nome e^(-pi t), x real.
inline std::array<ball, 4> arb_thetas(const ball& x, const ball& t) {
    std::array<acb_struct, 4> values;
    acb_t argument;
    acb_t tau;
    acb_init(argument);
    acb_init(tau);
    for (acb_struct& each : values) {
        acb_init(&each);
    }
    arb_set(acb_realref(argument), x.handle());
    arb_set(acb_imagref(tau), t.handle());
    acb_modular_theta(values.data(), &values[1], &values[2], &values[3], argument, tau, ball::working_bits());
    std::array<ball, 4> result;
    for (std::size_t i = 0; i < 4; ++i) {
        arb_set(result[i].handle(), acb_realref(&values[i]));
        acb_clear(&values[i]);
    }
    acb_clear(argument);
    acb_clear(tau);
    return result;
}

/// agm(1, x).
inline ball arb_mean(const ball& x) {
    ball result;
    arb_agm(result.handle(), ball(1).handle(), x.handle(), ball::working_bits());
    return result;
}

/// The functions of one modulus [DLMF 20.9.1-2, 22.2.4-6].
class arb_jacobi {
public:
    /// k and k', both positive.
    arb_jacobi(const ball& k, const ball& complement)
        : period_(pi<ball>() / (arb_mean(complement) * 2)),
          ratio_(arb_mean(complement) / arb_mean(k)),
          at_zero_(arb_thetas(ball(0), ratio_)) {}

    /// K, and K'/K.
    const ball& period() const { return period_; }
    const ball& ratio() const { return ratio_; }

    /// cd, sd and nd, which have no common zero and no poles near real arguments, at 2 K x.
    std::array<ball, 3> over_dn(const ball& x) const {
        const auto [first, second, third, fourth] = arb_thetas(x, ratio_);
        const auto& [none, b, c, d] = at_zero_;
        return {c * second / (b * third), c * c * first / (b * d * third), c * fourth / (d * third)};
    }

    elliptic::jacobi_values<ball> operator()(const ball& u) const {
        const auto [first, second, third, fourth] = arb_thetas(ball(u / (period_ * 2)), ratio_);
        const auto& [none, b, c, d] = at_zero_;
        return {c * first / (b * fourth), d * second / (b * fourth), d * third / (c * fourth)};
    }

private:
    ball period_;
    ball ratio_;
    std::array<ball, 4> at_zero_;
};

/// F(phi, k) by Carlson's R_F, |phi| <= pi/2.
inline ball arb_incomplete(const ball& phi, const ball& parameter) {
    acb_t angle;
    acb_t m;
    acb_t value;
    acb_init(angle);
    acb_init(m);
    acb_init(value);
    arb_set(acb_realref(angle), phi.handle());
    arb_set(acb_realref(m), parameter.handle());
    acb_elliptic_f(value, angle, m, 0, ball::working_bits());
    ball result;
    arb_set(result.handle(), acb_realref(value));
    acb_clear(angle);
    acb_clear(m);
    acb_clear(value);
    return result;
}

}  // namespace libration::tests
