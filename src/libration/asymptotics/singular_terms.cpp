#include "libration/asymptotics/singular_terms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libration/plane/frobenius_series.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_bounds = 30;

// z^n by repeated squaring.
complex_ball whole_power_of(const complex_ball& z, long n) {
    flint_complex result;
    acb_pow_si(result.handle(), flint_complex(z).handle(), n, ball::working_bits());
    return result.number();
}

ball with_mirror_image(const complex_ball& z, bool real) { return real ? z.re : ball(z.re * 2); }

ball ball_quotient(long numerator, long denominator) { return ball(numerator) / ball(denominator); }

// The first index above J without the factor q.
int index_beyond(int terms, int q) { return (terms + 1) % q != 0 ? terms + 1 : terms + 2; }

ball gamma_of(const ball& x) {
    ball result;
    arb_gamma(result.handle(), x.handle(), ball::working_bits());
    return result;
}

ball inverse_gamma_of(const ball& x) {
    ball result;
    arb_rgamma(result.handle(), x.handle(), ball::working_bits());
    return result;
}

ball log_gamma_of(const ball& x) {
    ball result;
    arb_lgamma(result.handle(), x.handle(), ball::working_bits());
    return result;
}

}  // namespace

ball gamma_quotient(long n, int j, int q) {
    return exp(ball(log_gamma_of(ball(n) - ball_quotient(j, q)) - log_gamma_of(ball(n + 1))));
}

ball pole_coefficient(const pole_terms& of, long n) {
    const complex_ball inverse = complex_ball(1) / of.place;
    complex_ball power = whole_power_of(inverse, n + 1);
    ball binomial(1);
    complex_ball sum(0);
    for (std::size_t j = 1; j <= of.principal.size(); ++j) {
        const complex_ball term = of.principal[j - 1] * power * binomial;
        sum = j % 2 == 0 ? sum + term : sum - term;
        binomial = binomial * (n + static_cast<long>(j)) / static_cast<long>(j);
        power = power * inverse;
    }
    return with_mirror_image(sum, of.real);
}

branch_terms::branch_terms(algebraic_point of, double rho) : of_(std::move(of)) {
    const precision_scope few(digits_of_bounds);
    arb_set_d(rho_.handle(), rho);
    modulus_ = modulus_in_balls(of_.place);
    d_ = rho_ / modulus_ - 1;
    const ball reach = pow(of_.reach, of_.sheets);
    if (!certainly_less(ball(0), d_) || !certainly_less(d_, reach)) {
        throw precision_exhausted("the end of a slit");
    }
    for (int j = -of_.pole; j <= of_.last(); ++j) {
        const ball turn = pi<ball>() * j / of_.sheets;
        sizes_.push_back(j % of_.sheets == 0
                             ? ball(0)
                             : upper_bound(ball(modulus_in_balls(of_.coefficient(j)) * abs(sin(turn)) / pi<ball>())));
    }
}

long branch_terms::first(int terms) const {
    const precision_scope few(digits_of_bounds);
    const int q = of_.sheets;
    const ball beyond = upper_bound(ball(ball_quotient(terms, q) * (d_ + 1) / d_));
    const double least =
        std::max(arf_get_d(arb_midref(beyond.handle()), ARF_RND_UP), static_cast<double>(index_beyond(terms, q)) / q);
    return static_cast<long>(std::floor(least)) + 1;
}

ball branch_terms::coefficient(long n, int terms) const {
    const int q = of_.sheets;
    complex_ball sum(0);
    for (int first = -of_.pole; first < q - of_.pole && first <= terms; ++first) {
        if (first % q == 0 && first >= 0) {
            continue;
        }
        ball factor = gamma_quotient(n, first, q) * inverse_gamma_of(-ball_quotient(first, q));
        for (int j = first; j <= terms; j += q) {
            sum = sum + of_.coefficient(j) * factor;
            const ball next = ball_quotient(j + q, q);
            factor = factor * (-next) / (ball(n) - next);
        }
    }
    return with_mirror_image(sum * whole_power_of(complex_ball(1) / of_.place, n), of_.real);
}

// sum over j <= J of |c_j| |sin pi a|/pi I_a(n) (1 + d)^n
ball branch_terms::circle_terms(long n, int terms) const {
    const int q = of_.sheets;
    ball sum(0);
    for (int j = -of_.pole; j <= terms; ++j) {
        if (j % q == 0) {
            continue;
        }
        const ball a = ball_quotient(j, q);
        const ball below = j > 0 ? ball(ball(n) - a * (d_ + 1) / d_) : ball(n);
        if (!certainly_less(ball(0), below)) {
            throw precision_exhausted("the least index of a law");
        }
        sum += sizes_[static_cast<std::size_t>(j + of_.pole)] * pow(d_, a) / below;
    }
    return sum;
}

// |c_j| |sin pi a|/pi Gamma(1 + a)
ball branch_terms::slit_term(int j) const {
    return sizes_[static_cast<std::size_t>(j + of_.pole)] * gamma_of(ball_quotient(j + of_.sheets, of_.sheets));
}

// size reach^-(J_1+p)/(1 - e) Gamma(1 + a_1)/pi
ball branch_terms::rest_beyond(int terms) const {
    const int q = of_.sheets;
    const int next = index_beyond(terms, q);
    // Of two sheets only every second term jumps.
    const ball e = q == 2 ? ball(d_ / (of_.reach * of_.reach)) : ball(pow(d_, ball(ball(1) / q)) / of_.reach);
    return of_.size / pow(of_.reach, next + of_.pole) / (1 - e) * gamma_of(ball_quotient(next + q, q)) / pi<ball>();
}

ball branch_terms::bound(long n, int terms) const {
    const precision_scope few(digits_of_bounds);
    const int q = of_.sheets;
    ball sum = circle_terms(n, terms) * pow(ball(d_ + 1), -n);
    int last = of_.last();
    while (last > terms && static_cast<long>(index_beyond(last, q)) >= n * q) {
        --last;
    }
    for (int j = terms + 1; j <= last; ++j) {
        if (j % q != 0) {
            sum += slit_term(j) * gamma_quotient(n, j, q);
        }
    }
    sum += rest_beyond(last) * gamma_quotient(n, index_beyond(last, q), q);
    return upper_bound(ball(sum * pow(modulus_, -n) * (of_.real ? 1 : 2)));
}

branch_terms::uniform_bound branch_terms::uniform(int terms) const {
    const precision_scope few(digits_of_bounds);
    const int points = of_.real ? 1 : 2;
    return {upper_bound(ball(circle_terms(first(terms), terms) * points)),
            upper_bound(ball(rest_beyond(terms) * points)), index_beyond(terms, of_.sheets)};
}

}  // namespace libration::ode
