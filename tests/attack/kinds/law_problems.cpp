#include "attack/kinds/law_problems.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <utility>

namespace libration::attack {

namespace {

// y^(order) = sum over k of (constant_k + slope_k t) y^k, and the initial values.
struct polynomial_equation {
    int order = 1;
    std::vector<rational> constants, slopes;
    std::vector<rational> starts;

    std::string text() const {
        std::string right = "0";
        for (std::size_t k = 0; k < constants.size(); ++k) {
            right += fmt::format(" + ({} + ({})*t)*y^{}", constants[k].str(), slopes[k].str(), k);
        }
        std::string all = fmt::format("y{} = {}; y(0) = {}", std::string(static_cast<std::size_t>(order), '\''), right,
                                      starts[0].str());
        return order == 1 ? all : all + fmt::format("; y'(0) = {}", starts[1].str());
    }

    // Coefficients 0 to n by sums of products alone, in the working precision.
    std::vector<mpfr> coefficients_up_to(long n) const {
        std::vector<mpfr> a;
        for (const rational& each : starts) {
            a.push_back(real(each));
        }
        std::vector<std::vector<mpfr>> powers(constants.size());
        const auto term = [](const std::vector<mpfr>& of, long at) {
            return at < 0 ? mpfr(0) : of[static_cast<std::size_t>(at)];
        };
        for (long m = 0; static_cast<long>(a.size()) <= n; ++m) {
            mpfr sum(0);
            for (std::size_t k = 0; k < powers.size(); ++k) {
                mpfr next(k == 0 && m == 0 ? 1 : 0);
                for (long i = 0; k > 0 && i <= m; ++i) {
                    next += a[static_cast<std::size_t>(i)] * powers[k - 1][static_cast<std::size_t>(m - i)];
                }
                powers[k].push_back(next);
                sum += real(constants[k]) * next + real(slopes[k]) * term(powers[k], m - 1);
            }
            a.push_back(order == 1 ? mpfr(sum / (m + 1)) : mpfr(sum / ((m + 1) * (m + 2))));
        }
        return a;
    }
};

rational few(choices& next, bool zero = true) {
    const rational x(next.between(-4, 4), next.between(1, 3));
    return x == 0 && !zero ? rational(1) : x;
}

template <class Equation>
asked_law of_equation(const Equation& made) {
    return {made.text(), [=](long n) { return made.coefficients_up_to(n); }};
}

asked_law any_riccati(choices& next) {
    return of_equation(
        polynomial_equation{1, {few(next), few(next), few(next, false)}, {few(next), 0, 0}, {few(next)}});
}

asked_law any_second_order(choices& next) {
    polynomial_equation made{2, {0, 0, 0, 0}, {0, 0, 0, 0}, {few(next), few(next)}};
    if (next.one_in(2)) {  // y'' = a y^2 + b y + c + d t
        made.constants = {few(next), few(next), few(next, false), 0};
        made.slopes[0] = next.one_in(2) ? few(next) : rational(0);
    } else {  // y'' = a y^3 + (b + d t) y + c
        made.constants = {few(next), few(next), 0, few(next, false)};
        made.slopes[1] = next.one_in(2) ? few(next) : rational(0);
    }
    return of_equation(made);
}

asked_law any_abel(choices& next) {
    const bool quartic = next.one_in(3);
    polynomial_equation made{1, {few(next), few(next), 0, few(next, false)}, {few(next), 0, 0, 0}, {few(next, false)}};
    if (quartic) {
        made.constants.push_back(few(next, false));
        made.slopes.emplace_back(0);
    }
    return of_equation(made);
}

// y y' = a + b t: y^2 = y0^2 + 2 a t + b t^2, whose root by n (2 a_0) a_n.
asked_law any_root(choices& next) {
    const rational start = few(next, false);
    const rational a = few(next, false);
    const rational b = few(next);
    return {fmt::format("y*y' = {} + ({})*t; y(0) = {}", a.str(), b.str(), start.str()), [=](long n) {
                std::vector<mpfr> y{real(start)};
                for (long m = 1; m <= n; ++m) {
                    mpfr sum = real(m == 1 ? rational(2 * a) : m == 2 ? b : rational(0));
                    for (long i = 1; i < m; ++i) {
                        sum -= y[static_cast<std::size_t>(i)] * y[static_cast<std::size_t>(m - i)];
                    }
                    y.push_back(sum / (y[0] * 2));
                }
                return y;
            }};
}

// y' = c e^y: y = y0 - log(1 - c e^y0 t), y0 = 0: a_n = c^n/n.
asked_law any_logarithm(choices& next) {
    const rational c = few(next, false);
    return {fmt::format("y' = ({})*exp(y); y(0) = 0", c.str()),
            [=](long n) {
                std::vector<mpfr> a{mpfr(0)};
                mpfr power(1);
                for (long m = 1; m <= n; ++m) {
                    power *= real(c);
                    a.push_back(power / m);
                }
                return a;
            },
            nearest_singularity{[=] { return mpfr(1 / abs(real(c))); }, [=] { return real(c); }, 1, 0}};
}

// sum over i, j of coefficients[i][j] t^j y^(i) = right, and the initial values.
struct linear_polynomials {
    std::vector<std::vector<rational>> coefficients;
    rational right;
    std::vector<rational> starts;

    std::string text() const {
        std::string left;
        for (std::size_t i = 0; i < coefficients.size(); ++i) {
            for (std::size_t j = 0; j < coefficients[i].size(); ++j) {
                left += fmt::format("{}({})*t^{}*y{}", left.empty() ? "" : " + ", coefficients[i][j].str(), j,
                                    std::string(i, '\''));
            }
        }
        left += fmt::format(" = {}", right.str());
        for (std::size_t k = 0; k < starts.size(); ++k) {
            left += fmt::format("; y{}(0) = {}", std::string(k, '\''), starts[k].str());
        }
        return left;
    }

    // Coefficients 0 to n by the recurrence for coefficient m of the equation, m = 0, 1, ..
    std::vector<mpfr> coefficients_up_to(long n) const {
        std::vector<mpfr> a;
        long factorial = 1;
        for (std::size_t k = 0; k < starts.size(); ++k) {
            factorial *= k > 1 ? static_cast<long>(k) : 1;
            a.push_back(real(starts[k]) / factorial);
        }
        const auto order = static_cast<long>(coefficients.size()) - 1;
        const auto falling = [](long from, long count) {
            mpfr product(1);
            for (long k = 0; k < count; ++k) {
                product *= from - k;
            }
            return product;
        };
        for (long m = 0; static_cast<long>(a.size()) <= n; ++m) {
            mpfr sum(m == 0 ? real(right) : mpfr(0));
            for (long i = 0; i <= order; ++i) {
                const auto& row = coefficients[static_cast<std::size_t>(i)];
                for (long j = 0; j < static_cast<long>(row.size()) && j <= m; ++j) {
                    if (i < order || j > 0) {
                        sum -= real(row[static_cast<std::size_t>(j)]) * falling(m - j + i, i) *
                               a[static_cast<std::size_t>(m - j + i)];
                    }
                }
            }
            a.push_back(sum / (real(coefficients.back()[0]) * falling(m + order, order)));
        }
        return a;
    }
};

// The leading coefficient (1 - a t)(1 - b t), also with a = b: Euler's equation or an irregular singular point.
asked_law any_linear(choices& next) {
    const rational a = few(next, false);
    const rational b = next.one_in(4) ? a : few(next);
    const std::vector<rational> leading{1, -a - b, a * b};
    linear_polynomials made;
    const bool second = !next.one_in(3);
    made.right = next.one_in(3) ? few(next) : rational(0);
    if (a == b && second) {
        const rational c = few(next);
        made.coefficients = {{few(next)}, {c, -c * a}, leading};
    } else {
        made.coefficients = {{few(next), next.one_in(2) ? few(next) : rational(0)}, leading};
        if (second) {
            made.coefficients.insert(made.coefficients.begin() + 1, {few(next), few(next)});
        }
    }
    for (std::size_t k = 0; k + 1 < made.coefficients.size(); ++k) {
        made.starts.push_back(few(next));
    }
    return of_equation(made);
}

// t (1 - s t) y'' + (c - d t) y' - e y = 0 from 0, where only y_0 is free: (m + 1)(m + c) a_(m+1) = (s m (m - 1) + d m + e) a_m.
asked_law any_singular_start(choices& next) {
    const rational s = few(next, false);
    const rational c = abs(few(next, false));
    const rational d = few(next);
    const rational e = few(next);
    const rational start = few(next, false);
    return {fmt::format("t*(1 - ({})*t)*y'' + ({} - ({})*t)*y' - ({})*y = 0; y(0) = {}; y'(0) = {}", s.str(), c.str(),
                        d.str(), e.str(), start.str(), rational(e * start / c).str()),
            [=](long n) {
                std::vector<mpfr> a{real(start)};
                for (long m = 0; m < n; ++m) {
                    a.push_back(a.back() * ((real(s) * (m - 1) + real(d)) * m + real(e)) / ((real(c) + m) * (m + 1)));
                }
                return a;
            }};
}

// x_k' = sum of c x_i x_j, where x_0 = 1 stands for a factor less; the law is that of x_1.
struct quadratic_system {
    struct product {
        std::size_t row;
        rational c;
        std::size_t i, j;
    };
    std::vector<product> products;
    std::vector<rational> starts;  // of x_1, x_2, ..

    std::string text() const {
        std::vector<std::string> right(starts.size(), "0");
        const auto factor = [](std::size_t k) { return k == 0 ? std::string() : fmt::format("*x{}", k); };
        for (const product& each : products) {
            right[each.row - 1] += fmt::format(" + ({}){}{}", each.c.str(), factor(each.i), factor(each.j));
        }
        std::string all;
        for (std::size_t k = 0; k < starts.size(); ++k) {
            all += fmt::format("{}x{}' = {}", k == 0 ? "" : "; ", k + 1, right[k]);
        }
        for (std::size_t k = 0; k < starts.size(); ++k) {
            all += fmt::format("; x{}(0) = {}", k + 1, starts[k].str());
        }
        return all;
    }

    std::vector<mpfr> coefficients_up_to(long n) const {
        std::vector<std::vector<mpfr>> a{{mpfr(1)}};
        for (const rational& each : starts) {
            a.push_back({real(each)});
        }
        for (std::size_t m = 0; m < static_cast<std::size_t>(n); ++m) {
            std::vector<mpfr> next(a.size(), mpfr(0));
            for (const product& each : products) {
                mpfr sum(0);
                for (std::size_t l = 0; l <= m; ++l) {
                    sum += a[each.i][l] * a[each.j][m - l];
                }
                next[each.row] += real(each.c) * sum;
            }
            for (std::size_t k = 0; k < a.size(); ++k) {
                a[k].push_back(mpfr(next[k] / static_cast<long>(m + 1)));
            }
        }
        return a[1];
    }
};

// Competing species, tops with a torque or without, coupled Riccati equations, equations like Lorenz's, a damped
// oscillator: poles, logarithms, and kinds that are rejected.
asked_law any_quadratic_system(choices& next) {
    quadratic_system made;
    const auto c = [&] { return few(next, false); };
    switch (next.below(6)) {
        case 0:
            made = {{{1, c(), 0, 1}, {1, c(), 1, 2}, {2, c(), 0, 2}, {2, c(), 1, 2}}, {c(), c()}};
            if (next.one_in(3)) {
                made.products.push_back({1, c(), 1, 1});
            }
            break;
        case 1:
            made = {{{1, c(), 2, 3}, {2, c(), 1, 3}, {3, c(), 1, 2}}, {few(next), c(), c()}};
            if (next.one_in(2)) {
                made.products.push_back({1, few(next), 0, next.one_in(2) ? 0U : 1U});
            }
            break;
        case 2:
            made = {{{1, c(), 1, 1}, {1, few(next), 0, 2}, {2, c(), 1, 2}, {2, few(next), 0, 2}}, {c(), c()}};
            break;
        case 3:
            made = {{{1, c(), 0, 2},
                     {1, c(), 0, 1},
                     {2, c(), 0, 1},
                     {2, c(), 1, 3},
                     {2, c(), 0, 2},
                     {3, c(), 1, 2},
                     {3, c(), 0, 3}},
                    {c(), c(), c()}};
            break;
        case 4: {  // y = tau^(2 q) (a - k log tau), tau = 1 - t: x = 1/tau, u = tau^q, v = k x u
            const rational q = next.one_in(2) ? rational(1, 4) : rational(static_cast<int>(next.below(5)) + 1, 2);
            made = {
                {{1, -2 * q, 2, 1}, {1, rational(1), 3, 4}, {2, rational(1), 2, 2}, {3, -q, 2, 3}, {4, 1 - q, 2, 4}},
                {c(), rational(1), rational(1), few(next)}};
            break;
        }
        default:  // x'' = a x' + b x + c x^3 with the square as a third unknown
            const rational start = c();
            made = {{{1, rational(1), 0, 2},
                     {2, few(next), 0, 2},
                     {2, few(next), 0, 1},
                     {2, c(), 1, 3},
                     {3, rational(2), 1, 2}},
                    {start, few(next), start * start}};
    }
    return of_equation(made);
}

// Coefficient n from those before it.
using next_coefficient = std::function<mpfr(const std::vector<mpfr>& a, long n)>;

std::function<std::vector<mpfr>(long)> by_recurrence(const rational& first, const next_coefficient& next) {
    return [=](long n) {
        std::vector<mpfr> a{real(first)};
        for (long m = 1; m <= n; ++m) {
            a.push_back(next(a, m));
        }
        return a;
    };
}

// y' = c y^k, k from -3 to 5: y0 (1 - t/t1)^(-1/(k - 1)), 1/t1 = c (k - 1) y0^(k - 1).
asked_law any_power(choices& next) {
    const auto k = next.one_in(3) ? -static_cast<int>(next.between(1, 3)) : static_cast<int>(next.between(2, 5));
    const rational c = few(next, false);
    const rational start = few(next, false);
    rational limit = c * (k - 1);
    for (int i = 0; i < std::abs(k - 1); ++i) {
        limit *= k > 0 ? start : rational(1 / start);
    }
    const rational exponent = rational(-1) / (k - 1);
    return {fmt::format("y' = ({})*y^({}); y(0) = {}", c.str(), k, start.str()),
            by_recurrence(start,
                          [=](const std::vector<mpfr>& a, long n) {
                              return mpfr(a.back() * real(rational(n - 1 - exponent)) * real(limit) / n);
                          }),
            nearest_singularity{[=] { return mpfr(1 / abs(real(limit))); }, [=] { return real(limit); }, 1, exponent}};
}

// y = A (1 - c t^p)^s: p singularities on one circle.
asked_law any_circle(choices& next) {
    const auto p = static_cast<int>(next.between(1, 4));
    const rational c = few(next, false);
    const rational start = few(next, false);
    const rational s = next.one_in(3) ? rational(-1) : rational(next.between(-9, 9), next.between(2, 4));
    if (denominator(s) == 1 && s >= 0) {
        return any_power(next);
    }
    const std::string slope = fmt::format("({})*t^{}", rational(c * p).str(), p - 1);
    const rational by_square = 1 / start;
    std::string text;
    if (s == -1 && next.one_in(2)) {  // y' = c p t^(p - 1)/A y^2
        text = fmt::format("y' = ({})*({})*y^2", by_square.str(), slope);
    } else if (next.one_in(2)) {
        text = fmt::format("(1 - ({})*t^{})*y' = ({})*({})*y", c.str(), p, rational(-s).str(), slope);
    } else {
        text = fmt::format("y' = ({})*({})*y/(1 - ({})*t^{})", rational(-s).str(), slope, c.str(), p);
    }
    return {fmt::format("{}; y(0) = {}", text, start.str()),
            by_recurrence(start,
                          [=](const std::vector<mpfr>& a, long n) {
                              return n % p != 0 ? mpfr(0)
                                                : mpfr(a[static_cast<std::size_t>(n - p)] * real(c) *
                                                       real(rational(n / p - 1 - s)) / (n / p));
                          }),
            nearest_singularity{[=] { return mpfr(1 / pow(abs(real(c)), mpfr(mpfr(1) / p))); }, [=] { return real(c); },
                                p, s}};
}

// y = 1/(1 - u t + v t^2): two poles, one of order 2, opposite ones, or a pair; from y' = (u - 2 v t) y^2.
asked_law any_quotient(choices& next) {
    rational u;
    rational v;
    std::optional<nearest_singularity> nearest;
    if (next.one_in(4)) {
        const rational r = few(next, false);
        const rational w = few(next, false);
        u = 2 * r;
        v = r * r + w * w;
        nearest = nearest_singularity{[=] { return mpfr(1 / sqrt(real(v))); }, {}, 1, -1};
    } else {
        const rational a = few(next, false);
        const rational b = next.one_in(4) ? a : next.one_in(3) ? rational(-a) : few(next);
        u = a + b;
        v = a * b;
        const rational far = abs(a) >= abs(b) ? a : b;
        nearest = nearest_singularity{[=] { return mpfr(1 / abs(real(far))); }, [=] { return real(far); }, 1,
                                      a == b ? -2 : -1};
        if (u == 0) {
            nearest = nearest_singularity{[=] { return mpfr(1 / abs(real(far))); }, [=] { return real(rational(-v)); },
                                          2, -1};
        }
    }
    return {fmt::format("y' = ({} - ({})*t)*y^2; y(0) = 1", u.str(), rational(2 * v).str()),
            by_recurrence(1,
                          [=](const std::vector<mpfr>& a, long n) {
                              const mpfr before = n > 1 ? a[static_cast<std::size_t>(n - 2)] : mpfr(0);
                              return mpfr(real(u) * a.back() - real(v) * before);
                          }),
            nearest};
}

// u' = c u^2 - d, d of either sign, so that y = u + e has poles that repeat along or across the real axis.
asked_law any_constant_riccati(choices& next) {
    const rational c = few(next, false);
    const rational m = few(next, false);  // d = c m^2 or -c m^2
    const rational start = few(next);
    const bool repeats = next.one_in(2);
    const rational d = (repeats ? -c : c) * m * m;
    asked_law made = of_equation(polynomial_equation{1, {-d, 0, c}, {0, 0, 0}, {start}});
    const rational size = abs(m);
    if (repeats) {  // t1 = (pi/2 - atan(u0/m))/(c m) for c > 0, and the one before 0 by pi/(c m) less
        const auto place = [=](int sign) {
            const mpfr angle = atan(mpfr(real(start) / real(size)));
            return mpfr((sign * pi_value() / 2 - angle) / (real(c) * real(size)));
        };
        if (start == 0) {
            made.nearest = nearest_singularity{[=] { return abs(place(1)); },
                                               [=] { return mpfr(1 / (place(1) * place(1))); }, 2, -1};
        } else {
            const int sign = start > 0 ? 1 : -1;
            made.nearest =
                nearest_singularity{[=] { return abs(place(sign)); }, [=] { return mpfr(1 / place(sign)); }, 1, -1};
        }
    } else if (abs(start) > size) {  // t1 = log((u0 + m)/(u0 - m))/(2 c m)
        const auto place = [=] {
            return mpfr(log(mpfr((real(start) + real(size)) / (real(start) - real(size)))) /
                        (2 * real(c) * real(size)));
        };
        made.nearest = nearest_singularity{[=] { return abs(place()); }, [=] { return mpfr(1 / place()); }, 1, -1};
    } else if (abs(start) < size) {  // the same with -+i pi more: opposite poles on the imaginary axis, or a pair
        const auto square = [=] {
            const mpfr re = log(mpfr((real(size) + real(start)) / (real(size) - real(start))));
            return mpfr((re * re + pi_value() * pi_value()) / pow(mpfr(2 * real(c) * real(size)), 2));
        };
        made.nearest = nearest_singularity{[=] { return mpfr(sqrt(square())); }, {}, 1, -1};
        if (start == 0) {
            made.nearest->limit = [=] { return mpfr(-1 / square()); };
            made.nearest->power = 2;
        }
    }
    return made;
}

}  // namespace

const std::vector<mpfr>& asked_law::coefficients_up_to(long n) const {
    const long digits = working_digits();
    auto& list = (*known)[digits];
    if (static_cast<long>(list.size()) <= n) {
        list = coefficients(n);
    }
    return list;
}

mpfr asked_law::coefficient(long n, int derivative) const {
    const auto& list = coefficients_up_to(n + derivative);
    mpfr result = list[static_cast<std::size_t>(n + derivative)];
    for (int k = 1; k <= derivative; ++k) {
        result *= n + k;
    }
    return result;
}

asked_law any_law(choices& next) {
    const auto kind = next.below(15);
    return kind < 2    ? any_riccati(next)
           : kind < 4  ? any_second_order(next)
           : kind < 6  ? any_abel(next)
           : kind < 7  ? any_root(next)
           : kind < 8  ? any_logarithm(next)
           : kind < 12 ? any_linear(next)
           : kind < 13 ? any_singular_start(next)
                       : any_quadratic_system(next);
}

asked_law any_closed_law(choices& next) {
    switch (next.below(6)) {
        case 0: return any_power(next);
        case 1: return any_circle(next);
        case 2: return any_circle(next);
        case 3: return any_quotient(next);
        case 4: return any_constant_riccati(next);
        default: return any_logarithm(next);
    }
}

}  // namespace libration::attack
