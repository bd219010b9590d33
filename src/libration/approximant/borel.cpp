#include "libration/approximant/borel.hpp"

#include <cstddef>

#include "libration/scalar/convert.hpp"
#include "libration/scalar/inner_product.hpp"

namespace libration {

namespace {

constexpr int nodes_per_unit = 32;
constexpr int last_node = 6 * nodes_per_unit;
constexpr int negligible_weight = -240;  // exponent of 2

mpfr gamma_of(const mpfr& x) {
    mpfr value;
    mpfr_gamma(handle(value), handle(x), MPFR_RNDN);
    return value;
}

}  // namespace

std::vector<mpfr> borel_transform(std::span<const mpfr> a, const rational& s, const rational& b) {
    std::vector<mpfr> transform;
    transform.reserve(a.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
        transform.push_back(a[n] / gamma_of(from_rational<mpfr>(rational(s * n + b))));
    }
    return transform;
}

laplace_rule::laplace_rule(const rational& s, const rational& b)
    : s_(from_rational<mpfr>(s)), b_(from_rational<mpfr>(b)) {
    for (int k = -last_node; k <= last_node; ++k) {
        const mpfr v = mpfr(k) / nodes_per_unit;
        const mpfr falling = exp(mpfr(-v));
        const mpfr log_of_u = v - falling;
        // du/dv = u (1 + e^-v).
        mpfr weight = exp(mpfr(log_of_u * b_ - exp(log_of_u))) * (falling + 1) / nodes_per_unit;
        if (weight != 0 && binary_exponent(weight) > negligible_weight) {
            nodes_.push_back({exp(mpfr(log_of_u * s_)), std::move(weight), k % 2 == 0});
        }
    }
}

std::vector<mpfr> laplace_rule::points() const {
    std::vector<mpfr> all;
    for (const node& each : nodes_) {
        all.push_back(each.at);
    }
    return all;
}

laplace_value laplace_rule::integral(const std::function<mpfr(const mpfr&)>& g) const {
    mpfr fine(0);
    mpfr coarse(0);
    for (const node& each : nodes_) {
        const mpfr value = g(each.at);
        add_product(fine, each.weight, value);
        if (each.coarse) {
            add_product(coarse, each.weight, value);
        }
    }
    return {fine, abs(mpfr(fine - coarse * 2))};
}

std::optional<laplace_value> laplace_rule::integral(const pade_approximant<mpfr>& quotient, const mpfr& x) const {
    mpfr of_poles(0);
    mpfr last_at(0);
    int last_sign = 1;
    bool defined = true;
    laplace_value found = integral([&](const mpfr& at) {
        const mpfr t = x * at;
        const mpfr denominator = evaluate_value(quotient.denominator, t);
        if (denominator == 0) {
            defined = false;
            return mpfr(0);
        }
        const int sign = denominator < 0 ? -1 : 1;
        if (sign != last_sign) {
            of_poles += pole_between(quotient, x, last_at, at);
        }
        last_at = at;
        last_sign = sign;
        return mpfr(evaluate_value(quotient.numerator, t) / denominator);
    });
    found.error += of_poles;
    return defined ? std::optional(found) : std::nullopt;
}

// pi |residue in u| e^-u u^(b-1) at the pole between two values of u^s, by bisection.
mpfr laplace_rule::pole_between(const pade_approximant<mpfr>& quotient, const mpfr& x, mpfr below, mpfr above) const {
    constexpr int halvings = 60;
    const bool negative = evaluate_value(quotient.denominator, mpfr(x * above)) < 0;
    for (int i = 0; i < halvings; ++i) {
        mpfr middle = (below + above) / 2;
        const bool same = (evaluate_value(quotient.denominator, mpfr(x * middle)) < 0) == negative;
        (same ? above : below) = std::move(middle);
    }
    const mpfr t = x * above;
    // dt/du = s t/u.
    const mpfr u = exp(mpfr(log(above) / s_));
    const mpfr residue = evaluate_value(quotient.numerator, t) / evaluate(quotient.denominator, t).slope;
    const mpfr density = exp(mpfr(log(u) * b_ - u));  // u times that of the integral
    return abs(mpfr(residue * density / (s_ * t))) * pi<mpfr>();
}

}  // namespace libration
