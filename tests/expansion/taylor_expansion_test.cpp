// The series of any system: compared with closed forms, exactly over fractions, and with the pendulum's recurrences in
// every scalar.
#include "libration/expansion/taylor_expansion.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/expansion/coefficient_digits.hpp"
#include "libration/expansion/fast_product.hpp"
#include "libration/pendulum/coefficients.hpp"
#include "libration/scalar/error.hpp"
#include "libration/series/exponential.hpp"
#include "libration/series/tangent.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace expansion_taylor_expansion_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;
using series::power_series;

namespace {

template <field R>
std::vector<power_series<R>> series_about_start(const std::string& text, int order) {
    const explicit_system system(parse(text));
    const tape made = tape::about_start(system);
    taylor_expansion<R> expansion(made, order);
    expansion.about_start();
    std::vector<power_series<R>> all;
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) {
        all.push_back(expansion.series_of(static_cast<int>(i)));
    }
    return all;
}

template <field R>
power_series<R> first_series(const std::string& text, int order) {
    return series_about_start<R>(text, order).front();
}

constexpr int exact_order = 13;

/// The variable of a series of fractions.
power_series<rational> identity() {
    auto t = power_series<rational>::zero(exact_order);
    t[1] = 1;
    return t;
}
power_series<rational> one() {
    auto f = power_series<rational>::zero(exact_order);
    f[0] = 1;
    return f;
}

bool same(const power_series<rational>& a, const power_series<rational>& b) {
    return a.coefficients() == b.coefficients();
}

// sum c_k t^(2k + shift).
power_series<rational> in_squares(const power_series<rational>& c, int shift) {
    auto f = power_series<rational>::zero(exact_order);
    for (int k = 0; 2 * k + shift <= exact_order; ++k) {
        f[2 * k + shift] = c[k];
    }
    return f;
}

const std::string swinging = "x'' = -sin(x); x(0) = 5/2; x'(0) = -3/10";

template <scalar T>
power_series<T> by_its_own_recurrence(int order) {
    using std::cos;
    using std::sin;
    const T theta = T(5) / 2;
    const T omega = T(-3) / 10;
    const T s = sin(T(theta / 2));
    const T c = cos(T(theta / 2));
    const T kinetic = omega * omega / 2;
    return pendulum::taylor_by_sine_cosine<T>(
        {{theta, omega, s, c}, {T(s * s * 2 + kinetic), T(c * c * 2 - kinetic)}, series::parity::any}, order, T(1));
}

}  // namespace

TEST_CASE("closed forms come out exactly over fractions", "[ode][taylor_expansion]") {
    const rational zero(0);
    const auto t = identity();
    const auto e = series::exponential(t, rational(1));
    const auto [sine, cosine] = series::sine_cosine(t, zero, rational(1));
    const auto first = [](const std::string& text) { return first_series<rational>(text, exact_order); };
    CHECK(same(first("y' = y; y(0) = 1"), e));
    CHECK(same(first("y' = 1 + y^2; y(0) = 0"), series::tangent(t, zero)));
    CHECK(same(first("y' = y*(1 - y); y(0) = 1/2"), e / (one() + e)));
    CHECK(same(first("y' = exp(-y); y(0) = 0"), series::logarithm(one() + t, zero)));
    CHECK(same(first("y'' = -y; y(0) = 1; y'(0) = 0"), cosine));
    CHECK(same(first("y' = 1/cos(y); y(0) = 0"), first("y' = (1 - t^2)^(-1/2); y(0) = 0")));
    CHECK(same(first("y' = sqrt(1 - y^2); y(0) = 0"), sine));
    CHECK(same(first("y' = y^(1/3); y(0) = 1"),
               series::power(one() + t * first("y' = 0; y(0) = 2/3"), rational(rational(3) / 2), rational(1))));
    CHECK(same(first("y' = -2*t*y^2; y(0) = 1"), one() / (one() + t * t)));
    CHECK(same(first("y' = 2*(t - 3)*y^-1; y(3) = 1"),
               series::power(one() + (t * t + t * t), rational(rational(1) / 2), rational(1))));
    CHECK(same(series_about_start<rational>("u' = v; v' = -u; u(0) = 0; v(0) = 1", exact_order)[1], cosine));
}

TEST_CASE("every function of the grammar has its series", "[ode][taylor_expansion]") {
    // f(g(t))' = f'(g) g' by two methods: the function's kernel, and that of its derivative.
    const std::vector<std::pair<std::string, std::string>> pairs{
        {"exp(u)", "y*u'"},
        {"log(1 + u)", "u'/(1 + u)"},
        {"sqrt(1 + u)", "u'/(2*y)"},
        {"sin(u)", "cos(u)*u'"},
        {"cos(u)", "-sin(u)*u'"},
        {"tan(u)", "(1 + tan(u)^2)*u'"},
        {"asin(u)", "u'/sqrt(1 - u^2)"},
        {"atan(u)", "u'/(1 + u^2)"},
        {"sinh(u)", "cosh(u)*u'"},
        {"cosh(u)", "sinh(u)*u'"},
        {"tanh(u)", "(1 - y^2)*u'"},
        {"(1 + u)^(2/3)", "2/3*y/(1 + u)*u'"},
        {"(1 + u)^-3", "-3*y/(1 + u)*u'"},
        {"(1 + u)^(5/2)", "5/2*(1 + u)^(3/2)*u'"},
    };
    // u is odd (every second coefficient is omitted), and not.
    const std::vector<std::string> paths{"u'' = -u - u^3; u(0) = 0; u'(0) = 1",
                                         "u'' = -u^2 + t; u(0) = 0; u'(0) = 1/2"};
    for (const std::string& u : paths) {
        for (const auto& [f, slope] : pairs) {
            INFO(f << " along " << u);
            const std::string value =
                f == "cos(u)" || f == "cosh(u)" || f == "exp(u)" || f[0] == '(' || f[1] == 'q' ? "1" : "0";
            const auto both = series_about_start<rational>(
                u + "; y' = " + slope + "; y(0) = " + value + "; z' = " + f + "; z(0) = 0", exact_order);
            CHECK(same(series::derivative(both[2]), both[1].truncated(exact_order - 1)));
        }
    }
    // acos u = pi/2 - asin u needs a scalar with pi.
    const precision_scope scope(40);
    const auto both = series_about_start<mpfr>("y' = acos(t/2) + asin(t/2); y(0) = 0", 6)[0];
    CHECK_THAT(both[1], near<mpfr>(mpfr(pi<mpfr>() / 2), 2));
    CHECK(both[2] == 0);
}

TEST_CASE("singular starts have their known series", "[ode][taylor_expansion]") {
    const rational zero(0);
    const auto lane_emden = [](const std::string& n) {
        return first_series<rational>("t*y'' + 2*y' + t*y^n = 0; y(0) = 1; y'(0) = 0; n = " + n, exact_order);
    };
    CHECK(same(lane_emden("0"),
               one() - identity() * identity() * first_series<rational>("y' = 0; y(0) = 1/6", exact_order)));
    const auto sine = series::sine_cosine(identity(), zero, rational(1)).first;
    const auto n_one = lane_emden("1");
    for (int n = 0; n < exact_order; ++n) {
        CHECK(n_one[n] == sine[n + 1]);
    }
    auto third = power_series<rational>::zero(exact_order);
    third[0] = 1;
    third[2] = rational(1, 3);
    CHECK(same(lane_emden("5"), series::power(third, rational(rational(-1) / 2), rational(1))));
    // J_0(t), and the same about t = 2, in a variable with another name.
    auto bessel = power_series<rational>::zero(exact_order);
    bessel[0] = 1;
    for (int k = 1; k <= exact_order; ++k) {
        bessel[k] = -bessel[k - 1] / (4 * k * k);
    }
    CHECK(same(first_series<rational>("t^2*y'' + t*y' + t^2*y = 0; y(0) = 1; y'(0) = 0", exact_order),
               in_squares(bessel, 0)));
    CHECK(same(
        first_series<rational>("variable x; (2*x - 4)*y'' + 2*y' + (2*x - 4)*y = 0; y(2) = 1; y'(2) = 0", exact_order),
        in_squares(bessel, 0)));
    // As a first-order system.
    CHECK(
        same(series_about_start<rational>("y' = w; w' = -2*w/t - y; y(0) = 1; w(0) = 0", exact_order)[0].truncated(12),
             n_one.truncated(12)));
    // Thomas, Fermi: y = 1 + B t + 4/3 t^(3/2) + 2B/5 t^(5/2) + t^3/3 + 3B^2/70 t^(7/2) + ...
    const auto atom = first_series<rational>("y'' = y^(3/2)/sqrt(t); y(0) = 1; y'(0) = -3/2", 7);
    const rational b(-3, 2);
    const std::vector<rational> expected{
        1, 0, b, rational(4, 3), 0, rational(2 * b / 5), rational(1, 3), rational(3 * b * b / 70)};
    CHECK(atom.coefficients() == expected);
    // A quotient of powers of t that is not a power: sin(y) + 1.
    CHECK(same(first_series<rational>("t*y' = t*sin(y) + t; y(0) = 0", exact_order),
               first_series<rational>("y' = sin(y) + 1; y(0) = 0", exact_order)));
}

TEST_CASE("singular starts that have no series are told so", "[ode][taylor_expansion]") {
    const auto refused = [](const std::string& text, const std::string& told) {
        INFO(text);
        const explicit_system system(parse(text));
        CHECK_THROWS_WITH(tape::about_start(system), told);
    };
    refused("t*y'' + 2*y' + t*y^3 = 0; y(0) = 1; y'(0) = 1",
            "problem 'y' has no power series with these initial values, since the equation contradicts y'(t0), or "
            "the solution has a logarithm: choose another initial point");
    refused("y' = 1/t; y(0) = 1",
            "problem 'y' has no power series with these initial values, since the equation contradicts y(t0), or "
            "the solution has a logarithm: choose another initial point");
    refused("t*y' = y; y(0) = 0",
            "problem 'y' has no unique series at the initial point, since the equation leaves the coefficient of power "
            "1 free, or has no solution: choose another initial point");
    refused("t*y'' + sqrt(2)*y' + t*y = 0; y(0) = 1; y'(0) = 0",
            "problem 'y' has an indicial equation whose numbers are not fractions: give parameters as fractions");
    CHECK_THROWS_WITH(series_about_start<rational>("y' = exp(y); y(0) = 1", 4),
                      "problem has a number that is not a fraction, or a function whose value at the initial point is "
                      "not one: choose another scalar");
    CHECK_THROWS_WITH(series_about_start<rational>("y' = y; y(0) = 1", -1), "order '-1' of a series is negative");
}

TEST_CASE("a symmetry of the start leaves out coefficients and nothing else", "[ode][tape]") {
    const auto stride = [](const std::string& text) {
        return tape::about_start(explicit_system(parse(text))).stride();
    };
    CHECK(stride("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 0; f''(0) = 1") == 3);
    CHECK(stride("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 1; f''(0) = 0") == 2);
    CHECK(stride("f''' + f*f''/2 = 0; f(0) = 0; f'(0) = 1; f''(0) = 1") == 1);
    CHECK(stride("x'' = -sin(x); x(0) = 1; x'(0) = 0") == 2);
    CHECK(stride("x'' = -sin(x); x(1) = 1; x'(1) = 0") == 2);
    CHECK(stride("x'' = -t*sin(x); x(1) = 1; x'(1) = 0") == 1);
    CHECK(stride("x'' = -sin(x); x(0) = 1; x'(0) = 1") == 1);
    CHECK(stride("u'' = 6*u^2 + t; u(0) = 0; u'(0) = 0") == 5);
    // The same solution with an initial value in another form: y(0) = sqrt(2)^2 - 2 is 0, but not by its form.
    const std::string plain = "y'' = y^3 - y + t; y'(0) = 1; y(0) = ";
    const precision_scope scope(30);
    const auto a = first_series<mpfr>(plain + "0", 20);
    const auto b = first_series<mpfr>(plain + "1/10^60", 20);
    for (int n = 0; n <= 20; ++n) {
        CHECK(abs(mpfr(a[n] - b[n])) < pow(mpfr(10), -29));
    }
}

TEMPLATE_LIST_TEST_CASE("the pendulum by the tape is the pendulum by its own recurrence", "[ode][taylor_expansion]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    constexpr int order = 60;
    const auto tape_made = first_series<T>(swinging, order);
    const auto own = by_its_own_recurrence<T>(order);
    for (int n = 0; n <= order; ++n) {
        using std::abs;
        T size(0);
        for (int k = std::max(0, n - 4); k <= n; ++k) {
            size = std::max(size, T(abs(own[k])));
        }
        // n roundings in each of both; neighbours are as large as what cancels.
        CHECK_THAT(tape_made[n], near<T>(own[n], 2 * n + 2, size));
    }
}

TEST_CASE("in balls each coefficient holds the exact one", "[ode][taylor_expansion][ball]") {
    constexpr int order = 60;
    const auto truth = [&](const std::string& text) {
        const precision_scope wide(120);
        return first_series<mpfr>(text, order);
    };
    const precision_scope scope(50);
    for (const std::string& text :
         {swinging, std::string("y'' = exp(-y)*t + sqrt(1 + y^2)/3 + pi; y(0) = sqrt(2); y'(0) = log(3)"),
          std::string("t*y'' + 2*y' + t*y^3 = 0; y(0) = 1; y'(0) = 0"),
          std::string("y' = 1/7 + y^(1/3) - asin(t)/9; y(0) = 1/3")}) {
        INFO(text);
        const auto found = first_series<ball>(text, order);
        const auto exact = truth(text);
        const auto complex = first_series<complex_number<ball>>(text, order);
        for (int n = 0; n <= order; ++n) {
            INFO("degree " << n);
            const precision_scope wide(120);
            CHECK(contains(enclose(found[n], ball(mpfr(abs(exact[n]) * pow(mpfr(10), -100)))), ball(exact[n])));
            CHECK(overlaps(complex[n].re, found[n]));
            CHECK(contains_zero(complex[n].im));
            // Balls of one recurrence depend on each other and lose up to a bit per degree.
            const mpfr size = abs(exact[n]) + abs(exact[std::max(0, n - 1)]) + abs(exact[std::max(0, n - 2)]);
            CHECK(certainly_less(radius_of(found[n]), ball(mpfr(size * pow(mpfr(10), -30) + pow(mpfr(10), -48)))));
        }
    }
    const auto own = by_its_own_recurrence<ball>(order);
    const auto found = first_series<ball>(swinging, order);
    for (int n = 0; n <= order; ++n) {
        CHECK(overlaps(own[n], found[n]));
    }
}

TEST_CASE("coefficients have the digits of their degree", "[ode][taylor_expansion][ball]") {
    // y = 1/(3 - t): a_n = 3^-(n + 1), by a square, from y(0) = 1/3.
    constexpr int order = 200;
    const precision_scope scope(100);
    const tape points = tape::about_points(explicit_system(parse("y' = y^2; y(0) = 1/3")));
    std::vector<long> falling;
    for (int n = 0; n < order; ++n) {
        falling.push_back(100 - 2 * n / 5);
    }
    for (const auto* const fast : {static_cast<const series::block_product<ball>*>(nullptr), fast_product<ball>()}) {
        taylor_expansion<ball> series(points, order, fast);
        for (const bool limited : {true, false, true}) {
            const coefficient_digits digits(limited ? falling : std::vector<long>());
            series.about(ball(0), {{ball(1) / 3}});
            for (int n = 1; n <= order; ++n) {
                CAPTURE(limited, n);
                const ball& found = series.coefficients(0)[n];
                const ball exact = ball(1) / pow(ball(3), static_cast<long>(n + 1));
                CHECK(overlaps(found, exact));
                const long left = limited ? falling[static_cast<std::size_t>(n) - 1] : 100;
                CHECK(certainly_less(radius_of(found), exact * pow(ball(10), 3 - left) * n));
                CHECK(certainly_less(exact * pow(ball(10), -left - 6), radius_of(found)));
            }
        }
    }
    CHECK(coefficient_digits::in_force() == nullptr);
    CHECK(working_digits() == 100);
}

TEST_CASE("expansions about other points continue the solution, complex ones too", "[ode][taylor_expansion]") {
    const precision_scope scope(60);
    using complex = complex_number<mpfr>;
    // y = tan t, z = 1/(1 + t): to 1/2 + i/3 and then to 1/4 - i/5, within four decimal orders of the precision.
    const explicit_system system(parse("y' = 1 + y^2; z' = -z^2 + 0*t; y(0) = 0; z(0) = 1"));
    const tape about_start = tape::about_start(system);
    const tape about_points = tape::about_points(system, {unknown("z") * (1 + variable()), variable()});
    taylor_expansion<complex> first(about_start, 400);
    first.about_start();
    const complex a{mpfr(1) / 2, mpfr(1) / 3};
    const complex b{mpfr(1) / 4, mpfr(-1) / 5};
    const auto near_tan = [](const complex& found, const complex& at) {
        CHECK(modulus_of(complex(found - tan(at))) < pow(mpfr(10), -56));
    };
    const auto state = first.at(a);
    near_tan(state[0][0], a);
    taylor_expansion<complex> second(about_points, 400);
    second.about(a, state);
    const auto there = second.at(b - a);
    near_tan(there[0][0], b);
    CHECK(modulus_of(complex(there[1][0] * (complex(1) + b) - complex(1))) < pow(mpfr(10), -56));
    // The observed expressions: z (1 + t) = 1, t itself.
    CHECK(modulus_of(complex(second.watched(0)[0] - complex(1))) < pow(mpfr(10), -56));
    CHECK(modulus_of(second.watched(0)[7]) < pow(mpfr(10), -50));
    CHECK(second.watched(1)[0] == a);
    CHECK(second.watched(1)[1] == complex(1));
    // The arrays can be reused for any number of points.
    second.about(complex(0), {{complex(0)}, {complex(1)}});
    CHECK(second.coefficients(0)[2] == complex(0));
    CHECK(modulus_of(complex(second.coefficients(0)[3] - complex(mpfr(1) / 3))) < pow(mpfr(10), -58));
}

}  // namespace expansion_taylor_expansion_test
