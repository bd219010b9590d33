#include "libration/pendulum/resummation_terms.hpp"

#include <string>

#include "libration/pendulum/error_norm.hpp"
#include "libration/pendulum/resummation.hpp"

namespace libration::pendulum {

namespace {

int direction_of(const fundamental_arc<mpfr>& arc) {
    return arc.level().regime == regime::rotation ? arc.of().direction() : 1;
}

// T*, theta* and omega* of the motion itself: a clockwise rotation goes from pi down to 0.
resummation_terms frame_of(const fundamental_arc<mpfr>& arc, resummation_formulas by) {
    const bool rotates = arc.level().regime == regime::rotation;
    const int direction = direction_of(arc);
    const bool corrected = by == resummation_formulas::corrected;
    resummation_terms terms;
    terms.effective_period = arc.effective_period();
    terms.angle = corrected && rotates && direction > 0 ? arc.bottom().value : mpfr(0);
    const mpfr fastest = abs(arc.bottom().slope);
    terms.speed = rotates ? mpfr(fastest * direction) : corrected ? mpfr(-fastest) : fastest;
    return terms;
}

// (pendseries).
void add_series(resummation_terms& terms, const fundamental_arc<mpfr>& arc, int order) {
    auto& [period, angle, speed, a, s, c, b, a_hat, sigma, slope, alpha, beta] = terms;
    a = {arc.top().theta, mpfr(arc.top().omega * direction_of(arc))};
    s = {arc.top().sine()};
    c = {arc.top().cosine()};
    const auto count = static_cast<std::size_t>(order) + 1;
    for (std::size_t n = 0; n + 1 < count; ++n) {
        mpfr sine(0);
        mpfr cosine(0);
        for (std::size_t k = 0; k <= n; ++k) {
            const mpfr factor = a[k + 1] * static_cast<long>(k + 1);
            sine += factor * c[n - k];
            cosine -= factor * s[n - k];
        }
        a.push_back(mpfr(-s[n] / static_cast<long>((n + 1) * (n + 2))));
        s.push_back(mpfr(sine / static_cast<long>(n + 1)));
        c.push_back(mpfr(cosine / static_cast<long>(n + 1)));
    }
    a.resize(count);
}

// sigma_n(T*) and its derivative; as printed with t^N in every term.
void add_partial_sums(resummation_terms& terms, resummation_formulas by) {
    const mpfr& period = terms.effective_period;
    mpfr value(0);
    mpfr slope(0);
    mpfr plain(0);
    mpfr power(1);  // T*^n
    for (std::size_t n = 0; n < terms.a.size(); ++n) {
        const auto index = static_cast<long>(n);
        const mpfr term = terms.a[n] * power;
        value += term;
        slope += term * index / period;
        plain += terms.a[n];
        const bool printed = by == resummation_formulas::printed;
        terms.sigma.push_back(printed ? mpfr(plain * power) : value);
        terms.sigma_slope.push_back(printed ? mpfr(plain * power * index / period) : slope);
        power *= period;
    }
}

// (efficient).
void add_alpha_beta(resummation_terms& terms) {
    const mpfr inverse = 1 / terms.effective_period;
    mpfr power(1);  // T*^-n
    for (std::size_t n = 0; n < terms.a.size(); ++n, power *= inverse) {
        const auto index = static_cast<long>(n);
        const mpfr missing = terms.sigma[n] - terms.angle;
        const mpfr slope = terms.speed - terms.sigma_slope[n];
        terms.alpha.push_back(mpfr(-(missing * (index + 2) * inverse + slope) * power));
        terms.beta.push_back(mpfr((missing * (index + 1) * inverse + slope) * power * inverse));
    }
}

void add_b(resummation_terms& terms) {
    terms.b = terms.a;
    terms.b[0] += terms.effective_period * terms.speed - terms.angle;
    if (terms.b.size() > 1) {
        terms.b[1] -= terms.speed;
    }
}

}  // namespace

resummation_terms terms_of_resummation(const motion& m, int order, resummation_formulas by) {
    require_taylor_order(order);
    const auto arc = arc_of<mpfr>(m);
    resummation_terms terms = frame_of(arc, by);
    add_series(terms, arc, order);
    add_b(terms);
    std::vector<mpfr> square;  // (k+1)/T*^(k+2)
    mpfr power = 1 / (terms.effective_period * terms.effective_period);
    for (std::size_t n = 0; n < terms.b.size(); ++n, power /= terms.effective_period) {
        square.push_back(mpfr(power * static_cast<long>(n + 1)));
        mpfr sum(0);
        for (std::size_t k = 0; k <= n; ++k) {
            sum += terms.b[n - k] * square[k];
        }
        terms.a_hat.push_back(sum);
    }
    add_partial_sums(terms, by);
    add_alpha_beta(terms);
    return terms;
}

resummation_terms terms_by_another_route(const motion& m, int order) {
    require_taylor_order(order);
    const auto arc = arc_of<mpfr>(m);
    resummation_terms terms = frame_of(arc, resummation_formulas::corrected);
    // a_n T*^n of the canonical motion; theta is odd about the top of a rotation, up to pi.
    auto scaled = arc_series(arc, order + 2);
    for (int n = 1; n <= order + 2 && direction_of(arc) < 0; ++n) {
        scaled[n] = -scaled[n];
    }
    std::vector<mpfr> a;
    mpfr power(1);
    for (int n = 0; n <= order + 2; ++n, power *= terms.effective_period) {
        a.push_back(mpfr(scaled[n] / power));
    }
    for (int n = 0; n <= order; ++n) {
        const auto at = static_cast<std::size_t>(n);
        terms.s.push_back(mpfr(-a[at + 2] * static_cast<long>((n + 1) * (n + 2))));
        mpfr square(0);
        for (std::size_t k = 0; k <= at; ++k) {
            square += a[k + 1] * static_cast<long>(k + 1) * a[at - k + 1] * static_cast<long>(at - k + 1);
        }
        terms.c.push_back(mpfr(square / 2 + (n == 0 ? mpfr(1 - arc.level().pair.energy) : mpfr(0))));
    }
    a.resize(static_cast<std::size_t>(order) + 1);
    terms.a = std::move(a);
    add_b(terms);
    const std::vector<mpfr> endpoint{terms.angle, mpfr(terms.speed * terms.effective_period)};
    const auto inner = inner_series(scaled.truncated(order), endpoint);
    mpfr inverse = 1 / (terms.effective_period * terms.effective_period);
    for (int n = 0; n <= order; ++n, inverse /= terms.effective_period) {
        terms.a_hat.push_back(mpfr(inner[n] * inverse));
        const auto polynomial = endpoint_corrected(scaled.truncated(n), endpoint);
        terms.alpha.push_back(mpfr(polynomial[n + 1] * inverse * terms.effective_period));
        terms.beta.push_back(mpfr(polynomial[n + 2] * inverse));
    }
    // sigma from alpha and beta, by the two conditions that these satisfy.
    mpfr reach = terms.effective_period;  // T*^(n+1)
    for (std::size_t n = 0; n < terms.a.size(); ++n, reach *= terms.effective_period) {
        const auto index = static_cast<long>(n);
        const mpfr first = terms.alpha[n] * reach;
        const mpfr second = terms.beta[n] * reach * terms.effective_period;
        terms.sigma.push_back(mpfr(terms.angle - first - second));
        // The empty sum of n = 0 is 0.
        const mpfr slope = terms.speed - (first * (index + 1) + second * (index + 2)) / terms.effective_period;
        terms.sigma_slope.push_back(n == 0 ? mpfr(0) : slope);
    }
    return terms;
}

long digits_lost_in_terms(const motion& m, int order) { return digits_below(m, order); }

}  // namespace libration::pendulum
