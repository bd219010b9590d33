#include "local_field.hpp"

#include <algorithm>
#include <numeric>

namespace libration::ode {

namespace {

complex_ball power_by_products(const complex_ball& z, int n) {
    complex_ball result(1);
    for (int k = 0; k < n; ++k) {
        result = result * z;
    }
    return result;
}

complex_ball exponential_of(const complex_ball& z) {
    flint_complex result;
    acb_exp(result.handle(), flint_complex(z).handle(), ball::working_bits());
    return result.number();
}

}  // namespace

long binomial_of(int n, int k) {
    long result = 1;
    for (int i = 1; i <= k; ++i) {
        result = result * (n - k + i) / i;
    }
    return result;
}

local_field::local_field(const dominant_balance& balance) : balance_(balance), size_(balance.orders.size()) {
    depends_ = std::ranges::any_of(balance.terms, [](const balance_term& each) {
        return each.excess != 0 || !each.share || each.of.by_time.size() > 1;
    });
}

// The coefficient of x^power of c(t), t = time - place x, without the factor (-place)^power.
complex_ball local_field::factor_of(const balance_term& of, const complex_ball& time, int power) const {
    complex_ball sum(0);
    for (std::size_t s = of.of.by_time.size(); s-- > static_cast<std::size_t>(power);) {
        const auto n = static_cast<int>(s);
        const complex_ball c(constant_value<ball>::of(of.of.by_time[s]));
        sum = sum + c * ball(binomial_of(n, power)) * power_by_products(time, n - power);
    }
    return sum;
}

std::size_t local_field::node_of(const std::vector<int>& exponents) {
    const int degree = std::accumulate(exponents.begin(), exponents.end(), 0);
    if (degree == 0) {
        return 0;
    }
    const auto first =
        static_cast<std::size_t>(std::ranges::find_if(exponents, [](int e) { return e > 0; }) - exponents.begin());
    if (degree == 1) {
        return first + 1;
    }
    if (const auto known = nodes_.find(exponents); known != nodes_.end()) {
        return known->second;
    }
    std::vector<int> rest = exponents;
    --rest[first];
    const std::size_t right = node_of(rest);
    products_.emplace_back(first + 1, right);
    const std::size_t node = size_ + products_.size();
    nodes_.emplace(exponents, node);
    return node;
}

int local_field::whole_power(const rational& exponent) const {
    return exponent == 0 ? 0 : static_cast<int>(numerator(rational(exponent / balance_.step)));
}

std::vector<complex_ball> local_field::limits(const std::vector<complex_ball>& finite) const {
    std::vector<complex_ball> result;
    for (const balance_role each : balance_.roles) {
        result.emplace_back(each == balance_role::nonzero ? 1 : 0);
    }
    for (std::size_t k = 0; k < finite.size(); ++k) {
        result[balance_.finite[k]] = finite[k];
    }
    return result;
}

balance_field<complex_ball> local_field::at(const complex_ball& origin, const complex_ball& place,
                                            const std::vector<complex_ball>& finite,
                                            const std::vector<complex_ball>& free, std::vector<complex_ball>& scales) {
    const complex_ball time = origin + place;
    std::vector<complex_ball> logs(size_, complex_ball(0));
    for (std::size_t k = 0; k < free.size(); ++k) {
        logs[balance_.free[k]] = free[k];
    }
    std::vector<complex_ball> right;
    const complex_ball of_place = logarithm_near(-place, 0.0 - balance_.place);
    for (std::size_t k = 0; k < balance_.equations.size(); ++k) {
        const balance_term& term = balance_.terms[balance_.equations[k]];
        const complex_ball share(from_rational<ball>(*term.share));
        complex_ball value = logarithm_near(share, static_cast<double>(*term.share)) -
                             logarithm_near(factor_of(term, time, 0), balance_.factors[k]) - of_place;
        value.im += pi<ball>() * (2 * balance_.turns[k]);
        const auto exponents = balance_.exponents_of(term);
        for (const std::size_t j : balance_.free) {
            value = value - logs[j] * ball(exponents[j]);
        }
        right.push_back(value);
    }
    for (std::size_t i = 0; i < balance_.pivots.size(); ++i) {
        complex_ball sum(0);
        for (std::size_t k = 0; k < right.size(); ++k) {
            sum = sum + right[k] * from_rational<ball>(balance_.inverse[i][k]);
        }
        logs[balance_.pivots[i]] = sum;
    }
    scales.clear();
    for (std::size_t i = 0; i < size_; ++i) {
        scales.push_back(balance_.roles[i] == balance_role::nonzero ? exponential_of(logs[i]) : complex_ball(1));
    }
    const std::vector<complex_ball> at_zero = limits(finite);
    balance_field<complex_ball> result;
    result.rows.resize(size_);
    for (const balance_term& each : balance_.terms) {
        complex_ball log_of_scales(0);
        const auto exponents = balance_.exponents_of(each);
        for (std::size_t j = 0; j < size_; ++j) {
            if (exponents[j] != 0 && balance_.roles[j] == balance_role::nonzero) {
                log_of_scales = log_of_scales + logs[j] * ball(exponents[j]);
            }
        }
        complex_ball factor = -place * exponential_of(log_of_scales);
        const auto last = static_cast<int>(each.of.by_time.size());
        for (int l = 0; l < last; ++l) {
            const bool leading = l == 0 && each.excess == 0;
            const complex_ball c = leading && each.share ? complex_ball(from_rational<ball>(*each.share))
                                                         : complex_ball(factor * factor_of(each, time, l));
            // of degrees 0 and 1 leading terms are in the matrix of the balance
            expand<complex_ball>(each, c, whole_power(rational(each.excess + l)), at_zero, leading ? 2 : 0,
                                 result.rows[each.row]);
            factor = factor * -place;
        }
    }
    result.products = products_;
    return result;
}

void local_field::check_shares(const std::vector<complex_ball>& scales, const complex_ball& origin,
                               const complex_ball& place) const {
    for (const balance_term& each : balance_.terms) {
        if (!each.share) {
            continue;
        }
        complex_ball value = -place * factor_of(each, origin + place, 0);
        const auto exponents = balance_.exponents_of(each);
        for (std::size_t j = 0; j < size_; ++j) {
            const complex_ball power = power_by_products(scales[j], std::abs(exponents[j]));
            value = exponents[j] > 0 ? value * power : value / power;
        }
        const complex_ball off = value / from_rational<ball>(*each.share) - complex_ball(1);
        const magnitude size = hypotenuse(magnitude(off.re), magnitude(off.im));
        if (!(size < magnitude::of(1, -5))) {
            throw precision_exhausted("the leading terms at a singularity");
        }
    }
}

}  // namespace libration::ode
