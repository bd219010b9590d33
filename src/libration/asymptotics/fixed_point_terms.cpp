#include "libration/asymptotics/fixed_point_terms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_poly.h>
#else
#include <acb_poly.h>
#endif

namespace libration::ode {

namespace {

constexpr long digits_of_slit_bounds = 30;
// h = 1/8
constexpr int parts_of_logarithm = 8;
constexpr std::size_t leading_terms = 4;

ball h_times(long m) { return ball(m) / parts_of_logarithm; }

ball gamma_at(const ball& x) { return apply(arb_gamma, x); }

// Gamma(n - b)/n!
ball quotient_of_gammas(long n, const ball& b) {
    return exp(ball(apply(arb_lgamma, ball(ball(n) - b)) - apply(arb_lgamma, ball(n + 1))));
}

ball with_image(const complex_ball& z, bool real) { return real ? z.re : ball(z.re * 2); }

long floor_in_double(const ball& x) {
    return static_cast<long>(std::floor(arf_get_d(arb_midref(upper_bound(x).handle()), ARF_RND_UP)));
}

bool is_zero_exactly(const complex_ball& z) {
    return is_exact(z.re) && contains_zero(z.re) && is_exact(z.im) && contains_zero(z.im);
}

// Gamma(n - a - s)/(Gamma(-a - s) n!) in powers of s, `count` of them: one for each power of a logarithm, at most 12, where FLINT
// multiplies by the classical algorithm (product_guard.hpp).
std::vector<complex_ball> gamma_series(const complex_ball& a, long n, std::size_t count) {
    const auto length = static_cast<slong>(count);
    const slong bits = ball::working_bits();
    acb_poly_t above, below;
    acb_poly_init(above);
    acb_poly_init(below);
    const complex_ball minus{-a.re, -a.im};
    acb_poly_set_coeff_acb(below, 0, flint_complex(minus).handle());
    acb_poly_set_coeff_acb(above, 0, flint_complex(complex_ball{minus.re + n, minus.im}).handle());
    acb_poly_set_coeff_si(below, 1, -1);
    acb_poly_set_coeff_si(above, 1, -1);
    acb_poly_lgamma_series(above, above, length, bits);
    acb_t factorial;
    acb_init(factorial);
    acb_set_arb(factorial, apply(arb_lgamma, ball(n + 1)).handle());
    acb_t constant;
    acb_init(constant);
    acb_poly_get_coeff_acb(constant, above, 0);
    acb_sub(constant, constant, factorial, bits);
    acb_poly_set_coeff_acb(above, 0, constant);
    acb_poly_exp_series_basecase(above, above, length, bits);
    acb_poly_rgamma_series(below, below, length, bits);
    acb_poly_mullow_classical(above, above, below, length, bits);
    std::vector<complex_ball> result;
    for (slong k = 0; k < length; ++k) {
        flint_complex at;
        acb_poly_get_coeff_acb(at.handle(), above, k);
        result.push_back(at.number());
    }
    acb_clear(constant);
    acb_clear(factorial);
    acb_poly_clear(above);
    acb_poly_clear(below);
    return result;
}

// The series for a + 1 from that for a: times (-(a + 1) - s)/(n - a - 1 - s).
void take_next_exponent(std::vector<complex_ball>& series, const complex_ball& a, long n) {
    const complex_ball zero{-a.re - 1, -a.im};
    const complex_ball divisor{zero.re + n, zero.im};
    for (std::size_t k = series.size(); k-- > 0;) {
        series[k] = k > 0 ? series[k] * zero - series[k - 1] : series[k] * zero;
    }
    for (std::size_t k = 0; k < series.size(); ++k) {
        series[k] = (k > 0 ? series[k] + series[k - 1] : series[k]) / divisor;
    }
}

}  // namespace

// f and m of the part with log(x)^k/k!.
struct fixed_point_terms::jump {
    std::size_t k;
    ball f;
    long m;
};

fixed_point_terms::fixed_point_terms(complex_ball place, bool real, std::vector<local_part> parts, double rho)
    : place_(std::move(place)), real_(real), parts_(std::move(parts)) {
    const precision_scope few(digits_of_slit_bounds);
    arb_set_d(rho_.handle(), rho);
    modulus_ = modulus_in_balls(place_);
    d_ = rho_ / modulus_ - 1;
    for (const local_part& each : parts_) {
        // A part with one value has no slit.
        if (!each.has_single_values() && (!certainly_less(ball(0), d_) || !certainly_less(d_, each.series.reach()))) {
            throw precision_exhausted("the end of a slit");
        }
    }
}

std::vector<fixed_point_terms::jump> fixed_point_terms::jumps_of(const local_part& of) const {
    std::vector<jump> all;
    ball factorial(1);
    for (std::size_t k = 0; k < of.series.powers_of_logarithm(); ++k) {
        if (!of.has_integer_exponent()) {
            factorial = k > 1 ? ball(factorial * static_cast<long>(k)) : factorial;
            all.push_back({k, cosh(ball(pi<ball>() * of.series.exponent().im)) / factorial, static_cast<long>(k)});
        } else if (k > 0) {
            factorial = k > 2 ? ball(factorial * static_cast<long>(k - 1)) : factorial;
            all.push_back({k, pi<ball>() / factorial, static_cast<long>(k) - 1});
        }
    }
    return all;
}

// J, or more where the exponent is negative, so that b > 0 beyond.
long fixed_point_terms::last_of(const local_part& of, int terms) const {
    const ball lowest = h_times(static_cast<long>(of.series.powers_of_logarithm())) - of.series.exponent().re;
    return std::max<long>(terms, floor_in_double(lowest) + 1);
}

long fixed_point_terms::first(int terms) const {
    const precision_scope few(digits_of_slit_bounds);
    long least = 0;
    for (const local_part& each : parts_) {
        const auto jumps = jumps_of(each);
        if (jumps.empty()) {
            continue;
        }
        const ball a = each.series.exponent().re + last_of(each, terms);
        least = std::max({least, floor_in_double(ball(a + 1)) + 1,
                          floor_in_double(ball((a + h_times(jumps.back().m)) * (d_ + 1) / d_)) + 1});
    }
    return least;
}

ball fixed_point_terms::coefficient(long n, int terms) const {
    complex_ball sum(0);
    for (const local_part& each : parts_) {
        complex_ball a = each.series.exponent();
        const long last = last_of(each, terms);
        std::vector<complex_ball> series = gamma_series(a, n, each.series.powers_of_logarithm());
        for (long j = 0; j <= last; ++j) {
            if (each.has_single_values() && *each.exponent + j >= 0) {
                break;  // from here on the part is analytic
            }
            for (std::size_t k = 0; k < series.size(); ++k) {
                sum = sum + each.series.coefficient(j)[k] * series[k];
            }
            take_next_exponent(series, a, n);
            a.re += 1;
        }
    }
    flint_complex power;
    acb_pow_si(power.handle(), flint_complex(place_).handle(), -n, ball::working_bits());
    return with_image(sum * power.number(), real_);
}

// pi (1 + d)^n times what the jump of the terms j beyond d costs.
ball fixed_point_terms::circle_term(const local_part& of, long j, long n) const {
    const ball size = abs(log(d_)) + pi<ball>() + ball(parts_of_logarithm) / exp(ball(1));
    ball sum(0);
    for (const jump& each : jumps_of(of)) {
        const ball a = upper_bound(ball(of.series.exponent().re + j + h_times(each.m)));
        const ball below = certainly_less(a, ball(0)) ? ball(n) : ball(ball(n) - a * (d_ + 1) / d_);
        if (!certainly_less(ball(0), below)) {
            throw precision_exhausted("the least index of a law");
        }
        sum += modulus_in_balls(of.series.coefficient(j)[each.k]) * each.f * pow(size, each.m) *
               pow(d_, ball(of.series.exponent().re + j)) / below;
    }
    return sum;
}

// The largest over k of f H^m d^(hm) Gamma(b + 1) Gamma(n - b)/n!.
ball fixed_point_terms::slit_factor(const local_part& of, long j, long n) const {
    const ball size = abs(log(d_)) + pi<ball>() + ball(parts_of_logarithm) / exp(ball(1));
    ball largest(0);
    for (const jump& each : jumps_of(of)) {
        const ball b = of.series.exponent().re + j - h_times(each.m);
        const ball here =
            each.f * pow(size, each.m) * pow(d_, h_times(each.m)) * gamma_at(ball(b + 1)) * quotient_of_gammas(n, b);
        largest = hull(largest, here);
    }
    return upper_bound(largest);
}

ball fixed_point_terms::bound(long n, int terms) const {
    const precision_scope few(digits_of_slit_bounds);
    ball circle(0);
    ball slit(0);
    for (const local_part& each : parts_) {
        if (jumps_of(each).empty()) {
            continue;
        }
        const long last = last_of(each, terms);
        for (long j = 0; j <= last; ++j) {
            circle += circle_term(each, j, n);
        }
        // Known coefficients as long as n > b.
        const long end = std::min(
            {each.series.terms(), last + 21, n - 2 - std::max(0L, floor_in_double(abs(each.series.exponent().re)))});
        long j = last + 1;
        for (; j < end; ++j) {
            ball norm(0);
            for (const complex_ball& c : each.series.coefficient(j)) {
                norm += modulus_in_balls(c);
            }
            slit += norm * slit_factor(each, j, n);
        }
        const ball beyond = each.series.size().exact() / pow(each.series.reach(), j) / (1 - d_ / each.series.reach());
        slit += beyond * slit_factor(each, j, n);
    }
    const ball sum = circle * pow(ball(d_ + 1), -n) + slit;
    return upper_bound(ball(sum / pi<ball>() * pow(modulus_, -n) * (real_ ? 1 : 2)));
}

fixed_point_terms::uniform_bound fixed_point_terms::uniform(int terms) const {
    const precision_scope few(digits_of_slit_bounds);
    const long n = first(terms);
    uniform_bound result{ball(0), ball(0), rational(0)};
    // The least b, rounded down.
    std::optional<long> eighths;
    for (const local_part& each : parts_) {
        if (const auto jumps = jumps_of(each); !jumps.empty()) {
            const ball b = each.series.exponent().re + (last_of(each, terms) + 1);
            const long down = -floor_in_double(ball(b * -parts_of_logarithm)) - 1 - jumps.back().m;
            eighths = eighths ? std::min(*eighths, down) : down;
        }
    }
    if (!eighths) {
        return result;
    }
    result.index = rational(*eighths, parts_of_logarithm);
    const ball size = abs(log(d_)) + pi<ball>() + ball(parts_of_logarithm) / exp(ball(1));
    const ball index = from_rational<ball>(result.index);
    for (const local_part& each : parts_) {
        const auto jumps = jumps_of(each);
        if (jumps.empty()) {
            continue;
        }
        const long last = last_of(each, terms);
        for (long j = 0; j <= last; ++j) {
            result.circle += circle_term(each, j, n);
        }
        // w^b <= d^(b - index) w^index for w <= d
        ball largest(0);
        for (const jump& of : jumps) {
            const ball b = each.series.exponent().re + (last + 1) - h_times(of.m);
            largest = hull(largest, ball(of.f * pow(size, of.m) * pow(d_, ball(h_times(of.m) + b - index))));
        }
        result.slit +=
            each.series.size().exact() / pow(each.series.reach(), last + 1) / (1 - d_ / each.series.reach()) * largest;
    }
    const ball points = ball(real_ ? 1 : 2) / pi<ball>();
    result.circle = upper_bound(ball(result.circle * points));
    result.slit = upper_bound(ball(result.slit * points * gamma_at(ball(index + 1))));
    return result;
}

std::vector<fixed_point_terms::singular_term> fixed_point_terms::leading() const {
    std::vector<singular_term> all;
    for (const local_part& each : parts_) {
        std::size_t found = 0;
        for (long j = 0; found < leading_terms && j < each.series.terms(); ++j) {
            for (std::size_t k = each.series.powers_of_logarithm(); k-- > 0;) {
                const bool analytic = k == 0 && each.has_integer_exponent() && *each.exponent + j >= 0;
                const complex_ball& c = each.series.coefficient(j)[k];
                if (!analytic && !is_zero_exactly(c)) {
                    ++found;
                    const complex_ball a{each.series.exponent().re + j, each.series.exponent().im};
                    all.push_back({a, c, each.exponent ? std::optional(*each.exponent + rational(j)) : std::nullopt,
                                   static_cast<int>(k)});
                }
            }
        }
    }
    // By doubles: the order of exponents that are closer is not stated.
    const auto height = [](const singular_term& of) {
        return std::round(arf_get_d(arb_midref(of.exponent.re.handle()), ARF_RND_NEAR) * 1e9);
    };
    std::ranges::stable_sort(all, [&](const singular_term& a, const singular_term& b) {
        return height(a) != height(b) ? height(a) < height(b) : a.power > b.power;
    });
    return all;
}

}  // namespace libration::ode
