#include "libration/asymptotics/fixed_point_terms.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gamma_powers.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_slit_bounds = 30;
// h = 1/8
constexpr int parts_of_logarithm = 8;
constexpr std::size_t leading_terms = 4;

ball h_times(long m) { return ball(m) / parts_of_logarithm; }

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
    return with_image(sum * inverse_power(place_, n), real_);
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
