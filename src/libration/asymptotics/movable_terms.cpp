#include "libration/asymptotics/movable_terms.hpp"

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

constexpr long digits_of_movable_bounds = 30;
constexpr std::size_t leading_movable_terms = 8;

ball part_of_logarithm(long p) { return ball(p) / parts_of_movable_logarithm; }

bool is_whole(const movable_term& of) { return of.exact && denominator(*of.exact) == 1; }
bool is_regular(const movable_term& of) { return is_whole(of) && *of.exact >= 0; }

ball double_exactly(double x) {
    ball result;
    arb_set_d(result.handle(), x);
    return result;
}

// Whether a term is summed: Re a <= J, or too small for a positive b with all logarithms. By doubles, for it is only a choice.
bool is_summed(const movable_term& of, int terms) {
    const double a = arf_get_d(arb_midref(of.exponent.re.handle()), ARF_RND_NEAR);
    const double by_logarithms = static_cast<double>(of.by_logarithm.size()) / parts_of_movable_logarithm;
    return a <= std::max(static_cast<double>(std::max(terms, 0)), by_logarithms) + 1e-9;
}

}  // namespace

// |c| f (|log w| + pi)^p w^(Re a) on the slit.
struct movable_terms::jump {
    ball a, size;
    long p;
    bool summed;
};

movable_terms::movable_terms(movable_point of, double rho) : of_(std::move(of)) {
    const precision_scope few(digits_of_movable_bounds);
    rho_ = double_exactly(rho);
    modulus_ = modulus_in_balls(of_.place);
    d_ = rho_ / modulus_ - 1;
    if (!certainly_less(ball(0), d_) || !certainly_less(d_, double_exactly(of_.reach))) {
        throw precision_exhausted("the end of a slit");
    }
    size_ = upper_bound(abs(log(d_)) + pi<ball>() + ball(parts_of_movable_logarithm) / exp(ball(1)));
    rest_ = ball(0);
    if (!of_.single_valued) {
        const ball kappa = of_.kappa_at(d_, size_);
        const ball power = contains_zero(kappa) ? ball(0) : pow(kappa, double_exactly(of_.least_weight));
        rest_ = upper_bound(ball(of_.rest.exact() * power * pow(d_, from_rational<ball>(-of_.order))));
    }
}

// b
ball movable_terms::rest_index() const {
    const rational loss = of_.logarithms / parts_of_movable_logarithm;
    const ball index =
        double_exactly(of_.least_weight) * from_rational<ball>(rational(1 - loss)) - from_rational<ball>(of_.order);
    if (!certainly_less(ball(0), index)) {
        throw precision_exhausted("the weights of an expansion at a singularity");
    }
    return index;
}

std::vector<movable_terms::jump> movable_terms::jumps(int terms) const {
    std::vector<jump> all;
    for (const movable_term& each : of_.terms) {
        const bool whole = is_whole(each);
        const ball turn = cosh(ball(pi<ball>() * each.exponent.im));
        for (std::size_t k = whole ? 1 : 0; k < each.by_logarithm.size(); ++k) {
            const auto power = static_cast<long>(k);
            const ball f = whole ? ball(pi<ball>() * power) : turn;
            all.push_back({each.exponent.re, upper_bound(ball(modulus_in_balls(each.by_logarithm[k]) * f)),
                           whole ? power - 1 : power, is_summed(each, terms)});
        }
    }
    return all;
}

long movable_terms::first(int terms) const {
    const precision_scope few(digits_of_movable_bounds);
    long least = 0;
    if (of_.single_valued) {
        return least;
    }
    for (const movable_term& each : of_.terms) {
        const long powers = static_cast<long>(each.by_logarithm.size()) - (is_whole(each) ? 2 : 1);
        if (is_summed(each, terms) && powers >= 0) {
            const ball a = each.exponent.re + part_of_logarithm(powers);
            least = std::max({least, floor_in_double(ball(a * (d_ + 1) / d_)) + 1, floor_in_double(ball(a + 1)) + 1});
        }
    }
    return std::max(least, 4L);
}

ball movable_terms::coefficient(long n, int terms) const {
    complex_ball sum(0);
    std::size_t powers = 1;
    for (const movable_term& each : of_.terms) {
        powers = std::max(powers, each.by_logarithm.size());
    }
    // Exponents that differ by whole numbers share a series.
    struct ladder {
        rational exponent;
        std::vector<complex_ball> series;
    };
    std::vector<ladder> ladders;
    for (const movable_term& each : of_.terms) {
        const bool analytic = is_regular(each) && each.by_logarithm.size() == 1;
        if (!is_summed(each, terms) || analytic) {
            continue;
        }
        std::vector<complex_ball> series;
        if (each.exact) {
            auto at = std::ranges::find_if(
                ladders, [&](const ladder& of) { return denominator(rational(*each.exact - of.exponent)) == 1; });
            if (at == ladders.end()) {
                ladders.push_back({*each.exact, gamma_series(each.exponent, n, powers)});
                at = ladders.end() - 1;
            }
            for (; at->exponent < *each.exact; at->exponent += 1) {
                take_next_exponent(at->series, complex_ball(from_rational<ball>(at->exponent)), n);
            }
            series = at->series;
        } else {
            series = gamma_series(each.exponent, n, each.by_logarithm.size());
        }
        ball factorial(1);
        for (std::size_t k = 0; k < each.by_logarithm.size(); ++k) {
            factorial = k > 0 ? ball(factorial * static_cast<long>(k)) : factorial;
            sum = sum + each.by_logarithm[k] * series[k] * factorial;
        }
    }
    return with_image(sum * inverse_power(of_.place, n), of_.real);
}

// pi (1 + d)^n times what the jump of a summed term beyond d costs.
ball movable_terms::circle_part(const jump& of, long n) const {
    const ball a = upper_bound(ball(of.a + part_of_logarithm(of.p)));
    const ball below = certainly_less(a, ball(0)) ? ball(n) : ball(ball(n) - a * (d_ + 1) / d_);
    if (!certainly_less(ball(0), below)) {
        throw precision_exhausted("the least index of a law");
    }
    return of.size * pow(size_, of.p) * pow(d_, of.a) / below;
}

ball movable_terms::bound(long n, int terms) const {
    const precision_scope few(digits_of_movable_bounds);
    if (of_.single_valued) {
        return ball(0);
    }
    ball circle(0);
    ball slit(0);
    const ball half = ball(n) / 2;
    const auto index_for = [&](const ball& b) { return certainly_less(b, half) ? lower_bound(b) : half; };
    const auto gammas = [&](const ball& b) { return gamma_at(ball(b + 1)) * quotient_of_gammas(n, b); };
    for (const jump& each : jumps(terms)) {
        if (each.summed) {
            circle += circle_part(each, n);
        } else {
            const ball b = index_for(ball(each.a - part_of_logarithm(each.p)));
            slit += each.size * pow(size_, each.p) * pow(d_, ball(each.a - b)) * gammas(b);
        }
    }
    const ball b = index_for(rest_index());
    slit += rest_ * pow(d_, ball(-b)) * gammas(b);
    const ball sum = circle * pow(ball(d_ + 1), -n) + slit;
    return upper_bound(ball(sum / pi<ball>() * pow(modulus_, -n) * (of_.real ? 1 : 2)));
}

fixed_point_terms::uniform_bound movable_terms::uniform(int terms) const {
    const precision_scope few(digits_of_movable_bounds);
    fixed_point_terms::uniform_bound result{ball(0), ball(0), rational(0)};
    if (of_.single_valued) {
        return result;
    }
    const long n = first(terms);
    std::vector<jump> beyond;
    ball least = rest_index();
    for (const jump& each : jumps(terms)) {
        if (each.summed) {
            result.circle += circle_part(each, n);
        } else {
            const ball b = each.a - part_of_logarithm(each.p);
            least = certainly_less(b, least) ? b : least;
            beyond.push_back(each);
        }
    }
    // The least b, in eighths, at most n - 1.
    const long eighths = std::min(-floor_in_double(ball(least * -8)) - 1, 8 * (n - 1));
    result.index = rational(eighths, 8);
    const ball index = from_rational<ball>(result.index);
    for (const jump& each : beyond) {
        result.slit += each.size * pow(size_, each.p) * pow(d_, ball(each.a - index));
    }
    result.slit += rest_ * pow(d_, ball(-index));
    const ball points = ball(of_.real ? 1 : 2) / pi<ball>();
    result.circle = upper_bound(ball(result.circle * points));
    result.slit = upper_bound(ball(result.slit * points * gamma_at(ball(index + 1))));
    return result;
}

std::vector<fixed_point_terms::singular_term> movable_terms::leading() const {
    std::vector<fixed_point_terms::singular_term> all;
    for (const movable_term& each : of_.terms) {
        ball factorial(1);
        std::vector<fixed_point_terms::singular_term> here;
        for (std::size_t k = 0; k < each.by_logarithm.size(); ++k) {
            factorial = k > 0 ? ball(factorial * static_cast<long>(k)) : factorial;
            const bool analytic = k == 0 && is_regular(each);
            if (!analytic && !is_zero_exactly(each.by_logarithm[k])) {
                here.insert(here.begin(),
                            {each.exponent, each.by_logarithm[k] * factorial, each.exact, static_cast<int>(k)});
            }
        }
        all.insert(all.end(), here.begin(), here.end());
        if (all.size() >= leading_movable_terms) {
            break;
        }
    }
    return all;
}

}  // namespace libration::ode
