// Series with known values at a point: drawn by a seed, inside and beyond the radius of convergence, entire and divergent.
// The values are closed forms in MPFR's functions.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "libration/scalar/constants.hpp"
#include "libration/scalar/convert.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/mpfr_traits.hpp"

namespace libration::tests {

using coefficients = std::vector<mpfr>;

/// f g up to the power of f.
inline coefficients product_of(const coefficients& f, const coefficients& g) {
    coefficients h(f.size(), mpfr(0));
    for (std::size_t n = 0; n < f.size(); ++n) {
        for (std::size_t k = 0; k <= n; ++k) {
            h[n] += f[k] * g[n - k];
        }
    }
    return h;
}

/// exp(f): n h_n = sum k f_k h_{n-k}.
inline coefficients exponential_of(const coefficients& f) {
    coefficients h{exp(f[0])};
    for (std::size_t n = 1; n < f.size(); ++n) {
        mpfr sum(0);
        for (std::size_t k = 1; k <= n; ++k) {
            sum += f[k] * h[n - k] * k;
        }
        h.push_back(sum / n);
    }
    return h;
}

/// log(f), f_0 > 0: h' f = f'.
inline coefficients logarithm_of(const coefficients& f) {
    coefficients h{log(f[0])};
    for (std::size_t n = 1; n < f.size(); ++n) {
        mpfr sum = f[n] * n;
        for (std::size_t k = 1; k < n; ++k) {
            sum -= h[k] * f[n - k] * k;
        }
        h.push_back(sum / f[0] / n);
    }
    return h;
}

inline coefficients scaled(coefficients f, const mpfr& factor) {
    for (mpfr& each : f) {
        each *= factor;
    }
    return f;
}

/// f^nu, f_0 > 0.
inline coefficients power_of(const coefficients& f, const mpfr& nu) {
    return exponential_of(scaled(logarithm_of(f), nu));
}

/// A polynomial as a series up to x^order.
inline coefficients polynomial(coefficients f, int order) {
    f.resize(static_cast<std::size_t>(order) + 1, mpfr(0));
    return f;
}

/// A list, a point, and the value there.
struct known_sum {
    std::string region;  ///< inside | beyond | divergent | pole beyond | entire | hard
    std::string family;
    coefficients a;
    mpfr x, truth;
};

/// Draws thousandths. The sequence of a seed is the same on every machine.
class value_draw {
public:
    explicit value_draw(unsigned seed) : engine_(seed) {
        for (int i = 0; i < 10; ++i) {
            engine_();
        }
    }
    int between(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<unsigned>(most - least + 1));
    }
    mpfr thousandths(int least, int most) { return mpfr(between(least, most)) / 1000; }
    int sign() { return between(0, 1) == 0 ? -1 : 1; }

private:
    std::mt19937 engine_;
};

/// (1 - x/x0)^nu exp(b x), nu = -1 for poles, |x0| from 0.5 to 3.
inline known_sum power_times_exponential(value_draw& draw, int order, const std::string& region) {
    const mpfr nu = region == "pole beyond" ? mpfr(-1) : draw.thousandths(-2500, 2500);
    const mpfr b = region == "pole beyond" ? mpfr(0) : draw.thousandths(-1500, 1500);
    const mpfr x0 = draw.thousandths(500, 3000) * draw.sign();
    const mpfr x = region == "inside" ? mpfr(x0 * draw.thousandths(200, 850) * draw.sign())
                                      : mpfr(x0 * draw.thousandths(-4000, -1100));
    auto power = power_of(polynomial({mpfr(1), mpfr(-1 / x0)}, order), nu);
    auto exponential = exponential_of(polynomial({mpfr(0), b}, order));
    return {region, "power times exponential", product_of(power, exponential), x,
            mpfr(exp(mpfr(log(mpfr(1 - x / x0)) * nu + b * x)))};
}

/// sum (c)_n (-x)^n = x^-c e^(1/x) Gamma(1-c, 1/x), x > 0 [DLMF 13.6.6, 13.7.3].
inline known_sum incomplete_gamma(value_draw& draw, int order) {
    const mpfr c = draw.thousandths(300, 2500);
    const mpfr x = draw.thousandths(50, 2000);
    coefficients a{mpfr(1)};
    for (int n = 0; n < order; ++n) {
        a.push_back(-a.back() * (c + n));
    }
    mpfr gamma;
    mpfr_gamma_inc(handle(gamma), handle(mpfr(1 - c)), handle(mpfr(1 / x)), MPFR_RNDN);
    return {"divergent", "incomplete gamma", a, x, mpfr(exp(mpfr(1 / x - log(x) * c)) * gamma)};
}

/// sum (-1)^k u_k x^k = 2 sqrt(pi) z^(1/4) e^(1/x) Ai(z), x = 3/(2 z^(3/2)) [DLMF 9.7.5].
inline known_sum airy(value_draw& draw, int order) {
    const mpfr z = draw.thousandths(700, 4000);
    const mpfr x = mpfr(3) / (z * sqrt(z) * 2);
    coefficients a{mpfr(1)};
    for (int k = 1; k <= order; ++k) {
        a.push_back(-a.back() * (6 * k - 5) * (6 * k - 1) / (72 * k));
    }
    mpfr value;
    mpfr_ai(handle(value), handle(z), MPFR_RNDN);
    return {"divergent", "Airy", a, x, mpfr(value * exp(mpfr(1 / x)) * sqrt(mpfr(sqrt(z) * pi<mpfr>())) * 2)};
}

/// x (log Gamma(1/x) - (1/x - 1/2) log(1/x) + 1/x - log(2 pi)/2)/x = sum B_2k/(2k (2k-1)) x^(2k-2) [DLMF 5.11.1].
inline known_sum stirling(value_draw& draw, int order) {
    const mpfr z = draw.thousandths(300, 3000);
    std::vector<rational> bernoulli{rational(1)};
    for (int n = 1; n <= order + 2; ++n) {
        rational sum = 0;
        rational binomial = 1;
        for (int k = 0; k < n; ++k) {
            sum += binomial * bernoulli[static_cast<std::size_t>(k)];
            binomial = binomial * (n + 1 - k) / (k + 1);
        }
        bernoulli.push_back(rational(-sum / (n + 1)));
    }
    coefficients a;
    for (int n = 0; n <= order; ++n) {
        const rational b = n % 2 == 0 ? bernoulli[static_cast<std::size_t>(n) + 2] : rational(0);
        a.push_back(from_rational<mpfr>(rational(b / ((n + 2) * (n + 1)))));
    }
    mpfr value;
    mpfr_lngamma(handle(value), handle(z), MPFR_RNDN);
    value -= (z - mpfr(1) / 2) * log(z) - z + log(mpfr(pi<mpfr>() * 2)) / 2;
    return {"divergent", "Stirling", a, mpfr(1 / z), mpfr(value * z)};
}

/// 1 + c log(1 - x/x0) times a power: not a solution of an equation of low order with small coefficients.
inline known_sum logarithm(value_draw& draw, int order, const std::string& region) {
    const mpfr c = draw.thousandths(200, 1500);
    const mpfr b = draw.thousandths(-1500, 1500);
    const mpfr x0 = draw.thousandths(500, 3000) * draw.sign();
    const mpfr x = region == "inside" ? mpfr(x0 * draw.thousandths(200, 850) * draw.sign())
                                      : mpfr(x0 * draw.thousandths(-4000, -1100));
    auto log_series = logarithm_of(polynomial({mpfr(1), mpfr(-1 / x0)}, order));
    auto f = scaled(log_series, c);
    f[0] += 1;
    auto exponential = exponential_of(polynomial({mpfr(0), b}, order));
    return {region, "logarithm", product_of(f, exponential), x,
            mpfr((log(mpfr(1 - x / x0)) * c + 1) * exp(mpfr(b * x)))};
}

/// (1 + 2 p x + x^2/r^2)^nu exp(b x): a complex pair.
inline known_sum pair(value_draw& draw, int order, const std::string& region) {
    const mpfr r = draw.thousandths(500, 2000);
    const mpfr cosine = draw.thousandths(-900, 900);
    const mpfr nu = draw.thousandths(-2500, 2500);
    const mpfr b = draw.thousandths(-1000, 1000);
    const mpfr x = region == "inside" ? mpfr(r * draw.thousandths(200, 850) * draw.sign())
                                      : mpfr(r * draw.thousandths(1100, 2500) * draw.sign());
    const coefficients quadratic{mpfr(1), mpfr(cosine * -2 / r), mpfr(1 / (r * r))};
    auto power = power_of(polynomial(quadratic, order), nu);
    auto exponential = exponential_of(polynomial({mpfr(0), b}, order));
    const mpfr base = quadratic[0] + x * quadratic[1] + x * x * quadratic[2];
    return {region, "pair", product_of(power, exponential), x, mpfr(exp(mpfr(log(base) * nu + b * x)))};
}

/// exp(b x) cos(c x) or exp(b x) J_0(c x).
inline known_sum entire(value_draw& draw, int order) {
    const mpfr b = draw.thousandths(-1500, 1500);
    const mpfr c = draw.thousandths(300, 2000);
    const mpfr x = draw.thousandths(200, 5000) * draw.sign();
    coefficients wave{mpfr(1)};
    const bool bessel = draw.between(0, 1) == 0;
    for (int n = 1; n <= order; ++n) {
        const auto before = static_cast<std::size_t>(n - 2);
        wave.push_back(n % 2 == 1 ? mpfr(0)
                       : bessel   ? mpfr(-wave[before] * c * c / (n * n))
                                  : mpfr(-wave[before] * c * c / (n * (n - 1))));
    }
    mpfr value = cos(mpfr(c * x));
    if (bessel) {
        mpfr_j0(handle(value), handle(mpfr(c * x)), MPFR_RNDN);
    }
    return {"entire", bessel ? "Bessel" : "cosine", product_of(wave, exponential_of(polynomial({mpfr(0), b}, order))),
            x, mpfr(value * exp(mpfr(b * x)))};
}

/// W(x/x0), x/x0 > -1/e: sum (-n)^(n-1)/n! (x/x0)^n [DLMF 4.13.5].
inline known_sum lambert(value_draw& draw, int order) {
    const mpfr x0 = draw.thousandths(500, 3000) * draw.sign();
    const mpfr w = draw.thousandths(-500, 1500);
    coefficients a{mpfr(0)};
    mpfr factor(1);
    for (int n = 1; n <= order; ++n) {
        factor /= x0 * n;
        a.push_back(mpfr(pow(mpfr(-n), n - 1)) * factor);
    }
    return {"hard", "Lambert", a, mpfr(w * exp(w) * x0), w};
}

/// tanh(c x)/x: poles on the imaginary axis alone.
inline known_sum hyperbolic_tangent(value_draw& draw, int order) {
    const mpfr c = draw.thousandths(500, 2000);
    const mpfr x = draw.thousandths(200, 4000) * draw.sign();
    const auto growing = exponential_of(polynomial({mpfr(0), mpfr(c * 2)}, order + 1));
    coefficients above;  // (e^(2 c x) - 1)/x
    coefficients below = growing;
    below[0] += 1;
    for (std::size_t n = 1; n < growing.size(); ++n) {
        above.push_back(growing[n]);
    }
    below.pop_back();
    return {"hard", "tanh", product_of(above, power_of(below, mpfr(-1))), x, mpfr(tanh(mpfr(c * x)) / x)};
}

/// exp(c (e^(b x) - 1)).
inline known_sum iterated_exponential(value_draw& draw, int order) {
    const mpfr b = draw.thousandths(-1000, 1000);
    const mpfr c = draw.thousandths(-1500, 1500);
    const mpfr x = draw.thousandths(200, 3000) * draw.sign();
    auto inner = exponential_of(polynomial({mpfr(0), b}, order));
    inner[0] = 0;
    return {"hard", "iterated exponential", exponential_of(scaled(inner, c)), x,
            mpfr(exp(mpfr((exp(mpfr(b * x)) - 1) * c)))};
}

/// Functions of roots and logarithms, most of which satisfy no linear equation with polynomial coefficients.
inline known_sum hard(value_draw& draw, int order) {
    const mpfr x0 = draw.thousandths(500, 3000) * draw.sign();
    const mpfr c = draw.thousandths(300, 1200);
    const mpfr x = mpfr(x0 * draw.thousandths(200, 3000) * -1);
    const mpfr root = sqrt(mpfr(1 - x / x0));
    const auto root_series = power_of(polynomial({mpfr(1), mpfr(-1 / x0)}, order), mpfr(1) / 2);
    const auto log_series = logarithm_of(polynomial({mpfr(1), mpfr(-1 / x0)}, order));
    switch (draw.between(0, 3)) {
        case 0: return {"hard", "exp of root", exponential_of(scaled(root_series, c)), x, mpfr(exp(mpfr(root * c)))};
        case 1: {
            auto f = scaled(log_series, c);
            f[0] += 2;
            return {"hard", "log of log", logarithm_of(f), x, mpfr(log(mpfr(log(mpfr(root * root)) * c + 2)))};
        }
        case 2: {
            auto f = root_series;
            f[0] += c;
            return {"hard", "power of root", power_of(f, mpfr(-1) / 3), x, mpfr(exp(mpfr(log(mpfr(root + c)) / -3)))};
        }
        default: {
            auto f = product_of(root_series, log_series);
            return {"hard", "exp of root times log", exponential_of(scaled(f, c)), x,
                    mpfr(exp(mpfr(root * log(mpfr(root * root)) * c)))};
        }
    }
}

/// (1 - x/p)^mu (1 + x/q)^nu, p and q positive: two competing singularities.
inline known_sum two_points(value_draw& draw, int order) {
    const mpfr p = draw.thousandths(500, 3000);
    const mpfr q = draw.thousandths(500, 3000);
    const mpfr mu = draw.thousandths(-1500, 1500);
    const mpfr nu = draw.thousandths(-1500, 1500);
    const mpfr x =
        draw.between(0, 1) == 0 ? mpfr(p * draw.thousandths(200, 950)) : mpfr(-q * draw.thousandths(200, 950));
    const auto left = power_of(polynomial({mpfr(1), mpfr(-1 / p)}, order), mu);
    const auto right = power_of(polynomial({mpfr(1), mpfr(1 / q)}, order), nu);
    return {"hard", "two points", product_of(left, right), x,
            mpfr(exp(mpfr(log(mpfr(1 - x / p)) * mu + log(mpfr(1 + x / q)) * nu)))};
}

/// The case of a seed, in the working precision; N = 20, 30 or 40 by the seed unless it is given.
inline known_sum known_value_of(unsigned seed, std::optional<int> with_order = std::nullopt) {
    value_draw draw(seed);
    const int drawn_order = 20 + 10 * draw.between(0, 2);
    const int order = with_order.value_or(drawn_order);
    switch (seed % 20) {
        case 0:
        case 1: return power_times_exponential(draw, order, "inside");
        case 2:
        case 3: return power_times_exponential(draw, order, "beyond");
        case 4:
        case 5: return incomplete_gamma(draw, order);
        case 6: return power_times_exponential(draw, order, "pole beyond");
        case 7: return logarithm(draw, order, "inside");
        case 8: return logarithm(draw, order, "beyond");
        case 9: return airy(draw, order);
        case 10: return stirling(draw, order);
        case 11: return pair(draw, order, "inside");
        case 12: return pair(draw, order, "beyond");
        case 13: return entire(draw, order);
        case 14: return two_points(draw, order);
        case 15: return lambert(draw, order);
        case 16: return hyperbolic_tangent(draw, order);
        case 17: return iterated_exponential(draw, order);
        default: return hard(draw, order);
    }
}

}  // namespace libration::tests
