#include "attack/component.hpp"

#include <array>
#include <cmath>

namespace libration::attack {

namespace {

using typed_term = const std::string&;

mpfr factorial(long n) { return tgamma(mpfr(n + 1)); }

mpfr power(const mpfr& x, long n) { return pow(x, mpfr(n)); }

// Binomial coefficients of a half-integer exponent, by products.
mpfr binomial(const mpfr& exponent, long n) {
    mpfr result = 1;
    for (long k = 0; k < n; ++k) {
        result = result * (exponent - k) / (k + 1);
    }
    return result;
}

std::optional<truth> after_start(const truth& time) { return sign_of(time) > 0 ? std::optional(time) : std::nullopt; }

component logistic(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term) { return a.text + "*" + y + "*(1-" + y + ")"; }, u,
                   [=](const mpfr& s) {
                       const mpfr c = 1 / u.value() - 1;
                       return mpfr(1 / (1 + c * exp(mpfr(-a.value() * s))));
                   }};
    const double start = u.rough();
    made.backward = start > 1 ? std::log(start / (start - 1)) / a.rough() : made.backward;
    return made;
}

component polynomial(const constant& a, const constant& u, long k) {
    component made{[=](typed_term, typed_term s) { return a.text + "*" + s + "^" + std::to_string(k); }, u,
                   [=](const mpfr& s) { return mpfr(u.value() + a.value() * power(s, k + 1) / (k + 1)); }};
    made.coefficient = [=](long n) { return n == 0 ? u.value() : n == k + 1 ? mpfr(a.value() / (k + 1)) : mpfr(0); };
    return made;
}

// u' = a/(2 u): sqrt(u0^2 + a s).
component square_root(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term) { return a.text + "/(2*" + y + ")"; }, u,
                   [=](const mpfr& s) { return mpfr(sqrt(mpfr(u.value() * u.value() + a.value() * s))); }};
    made.backward = u.rough() * u.rough() / a.rough();
    made.coefficient = [=](long n) {
        const mpfr start = u.value();
        return mpfr(binomial(mpfr(1) / 2, n) * power(mpfr(a.value() / (start * start)), n) * start);
    };
    made.singularities = [=](double) {
        return std::vector<place>{{[=] { return mpfr(-u.value() * u.value() / a.value()); }, [] { return mpfr(0); }}};
    };
    return made;
}

// u' = a exp(-u): log(e^u0 + a s).
component logarithm(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term) { return a.text + "*exp(-" + y + ")"; }, u,
                   [=](const mpfr& s) { return mpfr(log(mpfr(exp(u.value()) + a.value() * s))); }};
    made.backward = std::exp(u.rough()) / a.rough();
    made.coefficient = [=](long n) {
        const mpfr q = -a.value() * exp(mpfr(-u.value()));
        return n == 0 ? u.value() : mpfr(-power(q, n) / n);
    };
    return made;
}

// u' = -a u^3: u0/sqrt(1 + 2 a u0^2 s).
component inverse_root(const constant& a, const constant& u) {
    const auto rate = [=] { return mpfr(2 * a.value() * u.value() * u.value()); };
    component made{[=](typed_term y, typed_term) { return "-" + a.text + "*" + y + "^3"; }, u,
                   [=](const mpfr& s) { return mpfr(u.value() / sqrt(mpfr(1 + rate() * s))); }};
    made.backward = 1 / (2 * a.rough() * u.rough() * u.rough());
    made.coefficient = [=](long n) { return mpfr(binomial(mpfr(-1) / 2, n) * power(rate(), n) * u.value()); };
    made.singularities = [=](double) {
        return std::vector<place>{{[=] { return mpfr(-1 / rate()); }, [] { return mpfr(0); }}};
    };
    return made;
}

// u' = -2 a s u^2: 1/(1/u0 + a s^2).
component bell(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term s) { return "-2*" + a.text + "*" + s + "*" + y + "^2"; }, u,
                   [=](const mpfr& s) { return mpfr(1 / (1 / u.value() + a.value() * s * s)); }};
    made.coefficient = [=](long n) {
        return n % 2 == 1 ? mpfr(0) : mpfr(u.value() * power(mpfr(-a.value() * u.value()), n / 2));
    };
    made.singularities = [=](double) {
        const truth above = [=] { return mpfr(1 / sqrt(mpfr(a.value() * u.value()))); };
        const truth none = [] { return mpfr(0); };
        return std::vector<place>{{none, above}, {none, [=] { return mpfr(-above()); }}};
    };
    return made;
}

component gaussian(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term s) { return "-2*" + a.text + "*" + s + "*" + y; }, u,
                   [=](const mpfr& s) { return mpfr(u.value() * exp(mpfr(-a.value() * s * s))); }};
    made.coefficient = [=](long n) {
        return n % 2 == 1 ? mpfr(0) : mpfr(u.value() * power(mpfr(-a.value()), n / 2) / factorial(n / 2));
    };
    return made;
}

component sine(const constant& a, const constant& u) {
    component made{[=](typed_term, typed_term s) { return a.text + "*cos(" + a.text + "*" + s + ")"; }, u,
                   [=](const mpfr& s) { return mpfr(u.value() + sin(mpfr(a.value() * s))); }};
    made.coefficient = [=](long n) {
        const mpfr size = power(a.value(), n) / factorial(n);
        return n == 0 ? u.value() : n % 2 == 0 ? mpfr(0) : n % 4 == 1 ? size : mpfr(-size);
    };
    return made;
}

component hyperbolic(const constant& a, const constant& u) {
    return {[=](typed_term y, typed_term) { return a.text + "*(1-" + y + "^2)"; }, u,
            [=](const mpfr& s) {
                const mpfr grown = tanh(mpfr(a.value() * s));
                return mpfr((u.value() + grown) / (1 + u.value() * grown));
            }};
}

// Products and quotients of long series with equal coefficients, whose products come near the limits of the transforms:
// (c/(1-s)) (c/(s-1)), (c/(1-s)) (d/(1-s)), (c/(1+s)) (d/(s-1)).
component quotients(const constant& c, const constant& d, const constant& u, long form) {
    const char* const left = form == 2 ? "/(1+" : "/(1-";
    const bool turned = form != 1;
    component made{[=](typed_term, typed_term s) {
                       const std::string right = turned ? "/(" + s + "-1)" : "/(1-" + s + ")";
                       return "(" + c.text + left + s + "))*(" + d.text + right + ")";
                   },
                   u,
                   [=](const mpfr& s) {
                       const mpfr cd = c.value() * d.value();
                       if (form == 2) {
                           return mpfr(u.value() - cd * atanh(s));
                       }
                       const mpfr grown = cd * s / (1 - s);
                       return form == 0 ? mpfr(u.value() - grown) : mpfr(u.value() + grown);
                   }};
    made.forward = 1;
    made.backward = form == 2 ? 1 : made.backward;
    made.coefficient = [=](long n) {
        const mpfr cd = c.value() * d.value();
        if (n == 0) {
            return u.value();
        }
        return form == 0 ? mpfr(-cd) : form == 1 ? cd : n % 2 == 0 ? mpfr(0) : mpfr(-cd / n);
    };
    return made;
}

// u' = a/(1-s)^r, r > 1 no integer: u0 + a/(r-1) ((1-s)^(1-r) - 1).
component forced(const constant& a, const constant& u, const constant& r) {
    component made{[=](typed_term, typed_term s) { return a.text + "/(1-" + s + ")^" + r.text; }, u,
                   [=](const mpfr& s) {
                       const mpfr e = 1 - r.value();
                       return mpfr(u.value() - a.value() / e * (pow(mpfr(1 - s), e) - 1));
                   }};
    made.forward = 1;
    made.coefficient = [=](long n) {
        if (n == 0) {
            return u.value();
        }
        const mpfr size = a.value() * binomial(mpfr(-r.value()), n - 1) / n;
        return n % 2 == 0 ? mpfr(-size) : size;
    };
    made.singularities = [=](double) { return std::vector<place>{{[] { return mpfr(1); }, [] { return mpfr(0); }}}; };
    return made;
}

constant any_fractional_exponent(choices& next) {
    switch (next.below(4)) {
        case 0: return {"(5/2)", [] { return mpfr(mpfr(5) / 2); }};
        case 1: return {"(4/3)", [] { return mpfr(mpfr(4) / 3); }};
        case 2: return {"(33/10)", [] { return mpfr(mpfr(33) / 10); }};
        default: return {"pi", [] { return pi_value(); }};
    }
}

constexpr long kinds_with_coefficients = 11;

component of_kind(long kind, choices& next) {
    const constant a = any_constant(next);
    const constant u = any_constant(next);
    switch (kind) {
        case 0: return growth(next.one_in(2) ? a : constant{"(-" + a.text + ")", [a] { return mpfr(-a.value()); }}, u);
        case 1: return pole(a, u);
        case 2: return square_root(a, u);
        case 3: return inverse_root(a, u);
        case 4: return bell(a, u);
        case 5: return gaussian(a, u);
        case 6: return sine(a, u);
        case 7: return polynomial(a, u, next.between(0, 4));
        case 8: return logarithm(a, u);
        case 9: return quotients(a, any_constant(next), u, next.between(0, 2));
        case 10: return forced(a, u, any_fractional_exponent(next));
        case 11: return tangent(a, u);
        case 12: return logistic(a, u);
        default: return hyperbolic(a, u);
    }
}

}  // namespace

component growth(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term) { return a.text + "*" + y; }, u,
                   [=](const mpfr& s) { return mpfr(u.value() * exp(mpfr(a.value() * s))); }};
    made.coefficient = [=](long n) { return mpfr(u.value() * power(a.value(), n) / factorial(n)); };
    made.passes = [=](const constant& level) {
        return after_start([=] { return mpfr(log(mpfr(level.value() / u.value())) / a.value()); });
    };
    return made;
}

component pole(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term) { return a.text + "*" + y + "^2"; }, u,
                   [=](const mpfr& s) { return mpfr(u.value() / (1 - a.value() * u.value() * s)); }};
    made.forward = 1 / (a.rough() * u.rough());
    made.coefficient = [=](long n) { return mpfr(u.value() * power(mpfr(a.value() * u.value()), n)); };
    made.singularities = [=](double) {
        return std::vector<place>{{[=] { return mpfr(1 / (a.value() * u.value())); }, [] { return mpfr(0); }}};
    };
    made.passes = [=](const constant& level) {
        return after_start([=] { return mpfr((1 / u.value() - 1 / level.value()) / a.value()); });
    };
    return made;
}

component tangent(const constant& a, const constant& u) {
    component made{[=](typed_term y, typed_term) { return a.text + "*(1+" + y + "^2)"; }, u,
                   [=](const mpfr& s) {
                       const mpfr grown = tan(mpfr(a.value() * s));
                       return mpfr((u.value() + grown) / (1 - u.value() * grown));
                   }};
    const double phase = std::atan(u.rough());
    made.forward = (std::asin(1) - phase) / a.rough();
    made.backward = (std::asin(1) + phase) / a.rough();
    made.singularities = [=](double within) {
        std::vector<place> all;
        const double rate = a.rough();
        for (long k = -40; k <= 40; ++k) {
            const double about = ((static_cast<double>(k) + 0.5) * 2 * std::asin(1) - phase) / rate;
            if (std::abs(about) < within) {
                all.push_back({[=] { return mpfr((pi_value() * (2 * k + 1) / 2 - atan(u.value())) / a.value()); },
                               [] { return mpfr(0); }});
            }
        }
        return all;
    };
    made.passes = [=](const constant& level) {
        return after_start([=] { return mpfr((atan(level.value()) - atan(u.value())) / a.value()); });
    };
    return made;
}

component any_component(choices& next) { return of_kind(next.between(0, 13), next); }

component with_coefficients(choices& next) { return of_kind(next.between(0, kinds_with_coefficients - 1), next); }

component with_singularities(choices& next) {
    static constexpr std::array<long, 6> kinds{1, 2, 3, 4, 10, 11};
    return of_kind(kinds[next.below(kinds.size())], next);
}

}  // namespace libration::attack
