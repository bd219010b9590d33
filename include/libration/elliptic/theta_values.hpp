// Jacobi's theta functions of real argument at the small nome of a landen_nome, in balls.
#pragma once

#include <utility>

#include "libration/elliptic/landen_nome.hpp"

namespace libration::elliptic {

/// theta_2/(2 P^(1/4)) and theta_3 at one z; on request, theta_1/(2 P^(1/4)) and theta_4 [DLMF 20.2(i)].
struct theta_values {
    ball second;
    ball third;
    ball first;
    ball fourth;
};

/// The values at z with the given cosine; the first and the fourth only if the sine is given too. With e_n = 2 cos 2nz:
///   theta_3 = 1 + sum P^(n^2) e_n,             theta_4 = 1 + sum (-1)^n P^(n^2) e_n,
///   theta_2/(2 P^(1/4)) = cos z (1 + sum P^(n(n+1)) x_n),          x_n = e_n - x_{n-1}, x_0 = 1,
///   theta_1/(2 P^(1/4)) = sin z (1 + sum (-1)^n P^(n(n+1)) y_n),   y_n = e_n + y_{n-1}, y_0 = 1,
/// e_{n+1} = e_1 e_n - e_{n-1}. Cost: 3 products per term (4 with all), most of them in few bits. Errors: a few units
/// of the precision, relative to cos z in the second and to sin z in the first.
inline theta_values thetas_at(const landen_nome& nome, const ball& cosine, const ball* sine) {
    const long bits = nome.bits();
    const auto add = [bits](ball& to, const ball& x) { arb_add(to.handle(), to.handle(), x.handle(), bits); };
    ball e;  // e_n, to the number of bits required by its smaller power
    arb_mul(e.handle(), cosine.handle(), cosine.handle(), bits);
    arb_mul_2exp_si(e.handle(), e.handle(), 2);
    arb_sub_ui(e.handle(), e.handle(), 2, bits);
    const ball first_e = e;
    ball before(2);
    ball x(1);
    ball y(1);
    ball odd;
    theta_values sums{ball(1), ball(1), ball(1), ball()};
    for (int n = 1; n <= nome.terms(); ++n) {
        const long few = nome.deserved(n * (n + 1));
        const long some = nome.deserved(n * n);
        arb_sub(x.handle(), e.handle(), x.handle(), few);
        add(n % 2 == 0 ? sums.third : odd, landen_nome::product(e, nome.square_power(n), some));
        add(sums.second, landen_nome::product(x, nome.between_power(n), few));
        if (sine != nullptr) {
            arb_add(y.handle(), y.handle(), e.handle(), few);
            const ball term = landen_nome::product(y, nome.between_power(n), few);
            add(sums.first, n % 2 == 0 ? term : -term);
        }
        if (n < nome.terms()) {
            const long next = nome.deserved((n + 1) * (n + 1));
            ball after = landen_nome::product(first_e, e, next);
            arb_sub(after.handle(), after.handle(), before.handle(), next);
            before = std::exchange(e, std::move(after));
        }
    }
    if (sine != nullptr) {
        arb_sub(sums.fourth.handle(), sums.third.handle(), odd.handle(), bits);
        nome.widen_third(sums.fourth);
        nome.widen_second(sums.first);
        arb_mul(sums.first.handle(), sums.first.handle(), sine->handle(), bits);
    }
    add(sums.third, odd);
    nome.widen_third(sums.third);
    nome.widen_second(sums.second);
    arb_mul(sums.second.handle(), sums.second.handle(), cosine.handle(), bits);
    return sums;
}

}  // namespace libration::elliptic
