#include "libration/plane/frobenius_series.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "../algebra/dense_matrix.hpp"
#include "libration/scalar/ball/complex_values.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr long digits_of_series_bounds = 30;
constexpr std::size_t terms_of_quotient = 96;
constexpr long most_terms_of_series = 60'000;

magnitude norm_of_terms(const std::vector<complex_ball>& v) {
    magnitude sum;
    for (const complex_ball& each : v) {
        sum += hypotenuse(magnitude(each.re), magnitude(each.im));
    }
    return sum;
}

// Without one of the zeros of its leading coefficient the bound of an operator would be too small.
void require_all_zeros(const local_operator& of) {
    std::size_t degree = of.c.back().size() - 1;
    while (degree > 0 && norm_of_terms({of.c.back()[degree]}).is_zero()) {
        --degree;
    }
    if (of.zeros.size() != degree) {
        throw std::logic_error("a local series without a zero of its leading coefficient");
    }
}

// An upper bound of the sum over l >= 1 of |A_il| reach^l for each i < r. Division by one factor 1 - x/x_j after the other keeps the balls
// narrow.
std::vector<ball> sums_of_quotients(const local_operator& of, double reach) {
    const std::size_t order = of.c.size() - 1;
    const complex_ball& leading = of.c[order][0];
    const ball x = exactly(reach);
    const bool whole = of.zeros.empty();
    const ball farther = whole ? x : exactly((reach + of.nearest()) / 2);
    ball below = modulus_in_balls(leading);
    std::vector<complex_ball> inverses;
    for (const complex_ball& each : of.zeros) {
        below *= 1 - farther / modulus_in_balls(each);
        inverses.push_back(complex_ball(1) / each);
    }
    std::vector<ball> result;
    for (std::size_t i = 0; i < order; ++i) {
        std::vector<complex_ball> quotient = of.c[i];
        ball all(0);
        for (std::size_t l = 0; l < quotient.size(); ++l) {
            all += modulus_in_balls(quotient[l]) * pow(farther, static_cast<long>(l));
        }
        quotient.resize(std::max(terms_of_quotient, quotient.size()), complex_ball(0));
        for (const complex_ball& each : inverses) {
            for (std::size_t l = 1; l < quotient.size(); ++l) {
                quotient[l] = quotient[l] + quotient[l - 1] * each;
            }
        }
        ball sum(0);
        for (std::size_t l = quotient.size(); --l > 0;) {
            sum = (sum + modulus_in_balls(quotient[l])) * x;
        }
        sum = sum / modulus_in_balls(leading);
        if (!whole) {
            sum += all / below * pow(ball(x / farther), static_cast<long>(quotient.size())) / (1 - x / farther);
        }
        result.push_back(upper_bound(sum));
    }
    return result;
}

}  // namespace

frobenius_series::frobenius_series(const local_operator& of, complex_ball exponent,
                                   std::vector<std::vector<complex_ball>> first, const series_demand& demand)
    : exponent_(std::move(exponent)), v_(std::move(first)), reach_(exactly(demand.reach)) {
    require_all_zeros(of);
    for (const auto& each : v_) {
        powers_ = std::max(powers_, each.size());
    }
    for (auto& each : v_) {
        each.resize(powers_, complex_ball(0));
    }
    extend(of, demand);
}

frobenius_series frobenius_series::combination(const std::vector<frobenius_series>& all,
                                               const std::vector<complex_ball>& factors) {
    frobenius_series result;
    result.exponent_ = all.front().exponent_;
    result.reach_ = all.front().reach_;
    long shortest = all.front().terms();
    for (const frobenius_series& each : all) {
        shortest = std::min(shortest, each.terms());
        result.powers_ = std::max(result.powers_, each.powers_);
    }
    for (long n = 0; n < shortest; ++n) {
        std::vector<complex_ball> sum(result.powers_, complex_ball(0));
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t k = 0; k < all[i].powers_; ++k) {
                sum[k] = sum[k] + factors[i] * all[i].coefficient(n)[k];
            }
        }
        result.v_.push_back(std::move(sum));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        result.size_ += norm_of_terms({factors[i]}) * all[i].size_;
    }
    return result;
}

// The least tried N for which the bound holds.
long frobenius_series::first_proved(const local_operator& of, double reach) const {
    const precision_scope few(digits_of_series_bounds);
    const std::size_t order = of.c.size() - 1;
    const ball shift(powers_ > 1 ? 1 : 0);
    const ball size = modulus_in_balls(exponent_);
    const std::vector<ball> sums = sums_of_quotients(of, reach);
    for (long n = terms() + 1; n < most_terms_of_series; n += 1 + n / 4) {
        ball below(1);
        bool above_all = true;
        for (const complex_ball& each : of.exponents) {
            const ball rest = ball(n) - modulus_in_balls(exponent_ - each) - shift;
            above_all = above_all && certainly_less(ball(0), rest);
            below *= rest;
        }
        if (!above_all) {
            continue;
        }
        ball needed(0);
        ball factors = ball(n) / below;
        for (std::size_t i = 0; i < order; ++i) {
            needed += factors * sums[i];
            factors *= ball(n + static_cast<long>(i)) + size + shift;
        }
        if (certainly_less(needed, ball(n))) {
            return n;
        }
    }
    throw precision_exhausted("the coefficients of a local series");
}

// [e + n + S]_i v for i <= order.
std::vector<std::vector<complex_ball>> frobenius_series::images(const std::vector<complex_ball>& v, long n,
                                                                std::size_t order) const {
    std::vector<std::vector<complex_ball>> all{v};
    for (std::size_t i = 0; i < order; ++i) {
        const complex_ball factor{exponent_.re + (n - static_cast<long>(i)), exponent_.im};
        std::vector<complex_ball> next;
        for (std::size_t k = 0; k < powers_; ++k) {
            const complex_ball here = all.back()[k] * factor;
            next.push_back(k + 1 < powers_ ? here + all.back()[k + 1] : here);
        }
        all.push_back(std::move(next));
    }
    return all;
}

void frobenius_series::extend(const local_operator& of, const series_demand& demand) {
    const std::size_t order = of.c.size() - 1;
    const std::size_t length = of.c[order].size();
    const long least = std::max(first_proved(of, demand.reach), demand.least_terms);
    const magnitude reach = magnitude::at_least(demand.reach, 0);
    const double log2_of_ratio = std::log2(demand.at / demand.reach);
    magnitude power(1U);
    double largest = -1e300;
    std::vector<std::vector<std::vector<complex_ball>>> before;
    std::vector<complex_ball> indicial;
    for (const auto& row : of.c) {
        indicial.push_back(row[0]);
    }
    for (long n = 0;; ++n) {
        if (n == terms()) {
            // Enough if the rest is below 2^-bits of the largest term at |x| = at.
            const double rest = log_of(size_) + log2_of_ratio * static_cast<double>(n);
            if (n >= least && (rest < largest - static_cast<double>(demand.bits) || size_.is_zero())) {
                return;
            }
            if (n >= most_terms_of_series) {
                throw precision_exhausted("the terms of a local series");
            }
            std::vector<complex_ball> sum(powers_, complex_ball(0));
            for (std::size_t l = 1; l < length && static_cast<long>(l) <= n; ++l) {
                const auto& at = before[static_cast<std::size_t>(n) - l];
                for (std::size_t i = 0; i <= order; ++i) {
                    for (std::size_t k = 0; k < powers_; ++k) {
                        sum[k] = sum[k] - of.c[i][l] * at[i][k];
                    }
                }
            }
            const complex_ball at{exponent_.re + n, exponent_.im};
            const auto q = falling_sum(indicial, at, powers_);
            std::vector<complex_ball> v(powers_);
            for (std::size_t k = powers_; k-- > 0;) {
                for (std::size_t s = 1; k + s < powers_; ++s) {
                    sum[k] = sum[k] - q[s] * v[k + s];
                }
                v[k] = sum[k] / q[0];
            }
            v_.push_back(std::move(v));
        }
        const auto& v = v_[static_cast<std::size_t>(n)];
        before.push_back(images(v, n, order));
        if (before.size() > length) {
            before[before.size() - 1 - length].clear();
        }
        const magnitude term = norm_of_terms(v) * power;
        size_ = size_ < term ? term : size_;
        if (!size_.is_finite()) {
            throw precision_exhausted("a local series");
        }
        largest = std::max(largest, log_of(term) + log2_of_ratio * static_cast<double>(n));
        power *= reach;
    }
}

// sum over n >= N of (n + shift)^power q^n, in balls.
ball frobenius_series::rest_of_sum(const ball& q, long shift, std::size_t power) const {
    const ball start = ball(terms() + shift) + modulus_in_balls(exponent_) + (powers_ > 1 ? 1 : 0);
    const ball ratio = pow(ball(1 + ball(1) / start), static_cast<long>(power)) * q;
    if (!certainly_less(ratio, ball(1))) {
        throw precision_exhausted("a point of a local series");
    }
    return upper_bound(ball(pow(start, static_cast<long>(power)) * pow(q, terms()) / (1 - ratio)));
}

std::vector<complex_ball> frobenius_series::derivatives(const complex_ball& x, std::size_t count) const {
    std::vector<std::vector<complex_ball>> sums(count, std::vector<complex_ball>(powers_, complex_ball(0)));
    complex_ball power(1);
    for (long n = 0; n < terms(); ++n) {
        const auto all = images(coefficient(n), n, count - 1);
        for (std::size_t d = 0; d < count; ++d) {
            for (std::size_t k = 0; k < powers_; ++k) {
                sums[d][k] = sums[d][k] + all[d][k] * power;
            }
        }
        power = power * x;
    }
    flint_complex logarithm;
    acb_log(logarithm.handle(), flint_complex(x).handle(), ball::working_bits());
    const bool plain = powers_ == 1 && is_exact(exponent_.re) && contains_zero(exponent_.re) &&
                       is_exact(exponent_.im) && contains_zero(exponent_.im);
    complex_ball factor(1);
    if (!plain) {
        flint_complex value;
        acb_exp(value.handle(), flint_complex(exponent_ * logarithm.number()).handle(), ball::working_bits());
        factor = value.number();
    }
    const ball distance = modulus_in_balls(x);
    const ball q = upper_bound(ball(distance / reach_));
    std::vector<complex_ball> result;
    for (std::size_t d = 0; d < count; ++d) {
        complex_ball sum(0);
        complex_ball of_logarithm(1);
        ball largest(1);
        for (std::size_t k = 0; k < powers_; ++k) {
            if (k > 0) {
                of_logarithm = of_logarithm * logarithm.number() / static_cast<int>(k);
                largest += modulus_in_balls(of_logarithm);
            }
            sum = sum + sums[d][k] * of_logarithm;
        }
        const magnitude rest(ball(size_.exact() * rest_of_sum(q, static_cast<long>(d), d) * largest));
        sum = complex_ball{widened(sum.re, rest), widened(sum.im, rest)} * factor;
        result.push_back(sum);
        factor = factor / x / static_cast<int>(d + 1);
    }
    return result;
}

ball frobenius_series::bound(const ball& low, const ball& high) const {
    const precision_scope few(digits_of_series_bounds);
    if (!certainly_less(high, reach_)) {
        throw precision_exhausted("a point of a local series");
    }
    std::vector<ball> logarithms{ball(1)};
    ball all(1);
    if (powers_ > 1) {
        const ball largest = hull(abs(log(low)), abs(log(high))) + pi<ball>();
        for (std::size_t k = 1; k < powers_; ++k) {
            logarithms.push_back(logarithms.back() * largest / static_cast<long>(k));
            all += logarithms.back();
        }
    }
    const auto power_of = [&](long n) {
        const ball exponent = exponent_.re + n;
        return is_exact(exponent_.re) && contains_zero(exponent_.re) ? pow(high, n)
                                                                     : hull(pow(low, exponent), pow(high, exponent));
    };
    ball sum(0);
    for (long n = 0; n < terms(); ++n) {
        ball term(0);
        for (std::size_t k = 0; k < powers_; ++k) {
            term += modulus_in_balls(coefficient(n)[k]) * logarithms[k];
        }
        sum += term * power_of(n);
    }
    const ball q = high / reach_;
    sum += size_.exact() * pow(reach_, -terms()) * power_of(terms()) / (1 - q) * all;
    return upper_bound(ball(sum * exp(ball(pi<ball>() * abs(exponent_.im)))));
}

}  // namespace libration::ode
