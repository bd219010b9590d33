// Coefficients by the law of all coefficients: poles, branch points, movable logarithms and the singular points of linear equations, also
// in pairs and on one circle.
#include <fmt/core.h>

#include "attack/question.hpp"
#include "libration/asymptotics/coefficient_law.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/exponent_range.hpp"

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

    // Coefficient n by sums of products alone, in the working precision.
    mpfr coefficient(long n) const {
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
        return a[static_cast<std::size_t>(n)];
    }
};

struct asked_law {
    std::string text;
    std::function<mpfr(long)> coefficient;
    int derivative = 0;
};

rational few(choices& next, bool zero = true) {
    const rational x(next.between(-4, 4), next.between(1, 3));
    return x == 0 && !zero ? rational(1) : x;
}

asked_law of_equation(polynomial_equation made) {
    return {made.text(), [=](long n) { return made.coefficient(n); }};
}

asked_law any_riccati(choices& next) {
    return of_equation({1, {few(next), few(next), few(next, false)}, {few(next), 0, 0}, {few(next)}});
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
                return y[static_cast<std::size_t>(n)];
            }};
}

// y' = c e^y: y = y0 - log(1 - c e^y0 t), y0 = 0: a_n = c^n/n.
asked_law any_logarithm(choices& next) {
    const rational c = few(next, false);
    return {fmt::format("y' = ({})*exp(y); y(0) = 0", c.str()),
            [=](long n) { return mpfr(pow(real(c), static_cast<int>(n)) / n); }};
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

    // Coefficient n by the recurrence for coefficient m of the equation, m = 0, 1, ..
    mpfr coefficient(long n) const {
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
        return a[static_cast<std::size_t>(n)];
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
    return {made.text(), [=](long n) { return made.coefficient(n); }};
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

    mpfr coefficient(long n) const {
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
        return a[1][static_cast<std::size_t>(n)];
    }
};

// Competing species, tops with a torque or without, coupled Riccati equations, equations like Lorenz's, a damped oscillator: poles, logarithms, and
// kinds that are rejected.
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
    return {made.text(), [=](long n) { return made.coefficient(n); }};
}

}  // namespace

// Each coefficient of the law counts as one statement.
outcome ask_law(choices& next) {
    const auto kind = next.below(14);
    const asked_law asked = kind < 2    ? any_riccati(next)
                            : kind < 4  ? any_second_order(next)
                            : kind < 6  ? any_abel(next)
                            : kind < 7  ? any_root(next)
                            : kind < 8  ? any_logarithm(next)
                            : kind < 12 ? any_linear(next)
                                        : any_quadratic_system(next);
    const long order = next.one_in(8) ? 1000 : 200;
    const std::string command =
        fmt::format("libration asymptotics --problem \"{}\" --order 3,30,{}", asked.text, order);
    return answered(command, [&](outcome& result) {
        const whole_exponent_range exponents;
        const precision_scope scope(60);
        ode::law_request request;
        request.watch = [](ode::plane_step /*step*/) { require_time_left(); };
        const auto law = ode::coefficient_law::of(system_of(asked.text), request);
        for (const long n : {3L, 30L, 31L, 32L, order - 1, order}) {
            if (n >= law.first()) {
                result.add(judged_ball(law.value(n), [&] { return asked.coefficient(n); }),
                           fmt::format("coefficient {}", n));
            }
        }
    });
}

}  // namespace libration::attack
