// The functions of formulas and equations: their series against their values elsewhere and against identities, their
// values in every scalar against balls, and the manual's list.
#include "libration/function/list.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/ball_expansion.hpp"
#include "libration/function/ball_values.hpp"
#include "libration/number/exact_real_text.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace function_functions_test {

using namespace libration;
using namespace libration::ode;
using namespace libration::tests;

namespace {

/// A function, an order where it has one, and a point that is at least 1/2 from its singular points.
struct place {
    function_kind f;
    rational order;
    rational at;
};

std::string text_of(const place& p) {
    const std::string name(name_of(p.f));
    return has_order(p.f) ? name + "(" + p.order.str() + ", " + p.at.str() + ")" : name + "(" + p.at.str() + ")";
}

std::vector<place> places() {
    std::vector<place> all;
    for (std::size_t i = 0; i < function_kinds; ++i) {
        const auto f = static_cast<function_kind>(i);
        if (f == function_kind::exprel || f == function_kind::cosrel) {
            for (const rational& order : {rational(1), rational(2), rational(5)}) {
                all.push_back({f, order, rational(-3, 2)});
                all.push_back({f, order, rational(1, 2)});
            }
        } else if (has_order(f)) {
            for (const rational& order :
                 {rational(0), rational(1), rational(-2), rational(5), rational(1, 3), rational(-7, 2)}) {
                all.push_back({f, order, rational(3, 2)});
            }
        } else {
            const bool below_1 = f == function_kind::asin || f == function_kind::acos || f == function_kind::atanh;
            all.push_back({f, 0, below_1 ? rational(1, 3) : rational(5, 2)});
            if (f != function_kind::acosh) {
                all.push_back({f, 0, rational(1, 2)});
            }
        }
    }
    all.push_back({function_kind::sinc, 0, 0});
    all.push_back({function_kind::cbrt, 0, rational(-3, 2)});
    all.push_back({function_kind::lambertw, 0, 0});
    all.push_back({function_kind::expm1, 0, 0});
    all.push_back({function_kind::log1p, 0, 0});
    all.push_back({function_kind::erf, 0, 0});
    return all;
}

ode::expression applied(const place& p, const ode::expression& x) {
    return has_order(p.f) ? apply(p.f, ode::expression(p.order), x) : apply(p.f, x);
}

explicit_system moving_from(const rational& at) { return explicit_system(parse("u' = 1; u(0) = " + at.str())); }

/// The sum of the series of an expression of u = u(0) + t at t = h.
template <field R>
R sum_of_series(const ode::expression& of, const rational& at, const rational& h, int terms) {
    const explicit_system system = moving_from(at);
    const tape steps = tape::about_points(system, {of});
    taylor_expansion<R> series(steps, terms);
    series.about(R(0), {{constant_value<R>::of(number(at))}});
    R sum(0);
    for (int n = terms - 1; n >= 0; --n) {
        sum = R(sum * constant_value<R>::of(number(h)) + series.watched(0)[n]);
    }
    return sum;
}

}  // namespace

TEST_CASE("the series of each function has the function's values around", "[function]") {
    // The nearest singular point is at least 3/8 away: (1/32)/(3/8) = 2^-3.58, 60 terms leave out less than 2^-210.
    const rational h(1, 32);
    for (const place& p : places()) {
        INFO(text_of(p));
        const precision_scope scope(60);
        const ode::expression u = unknown("u");
        const ball sum = sum_of_series<ball>(applied(p, u), p.at, h, 60);
        const ball there = function_value<ball>(p.f, from_rational<ball>(rational(p.at + h)), &p.order);
        const mpfr size = abs(midpoint_of(there)) + 1;
        CHECK(abs(midpoint_of(ball(sum - there))) < size * pow(mpfr(10), -50));
        CHECK(midpoint_of(radius_of(sum)) < size * pow(mpfr(10), -40));
    }
}

TEST_CASE("the polynomial form of each function has its series", "[function]") {
    for (const place& p : places()) {
        INFO(text_of(p));
        if (p.f == function_kind::sinc && p.at == 0) {
            continue;  // which has none about 0
        }
        const precision_scope scope(60);
        explicit_system given(parse("u' = 1 + y/8; u(0) = " + p.at.str() + "; y' = " +
                                    (has_order(p.f) ? std::string(name_of(p.f)) + "(" + p.order.str() + ", u)"
                                                    : std::string(name_of(p.f)) + "(u)") +
                                    "; y(0) = 1/5"));
        const polynomial_form polynomial = lifted(given);
        constexpr int order = 12;
        const tape of_given = tape::about_start(given);
        taylor_expansion<ball> expected(of_given, order);
        expected.about_start();
        const tape of_lifted = tape::about_points(polynomial.system);
        taylor_expansion<ball> actual(of_lifted, order);
        solution_state<ball> start;
        for (const ball& each : lifted_values<ball>(polynomial, ball(0), {from_rational<ball>(p.at), ball(1) / 5})) {
            start.push_back({each});
        }
        actual.about(ball(0), start);
        for (int unknown = 0; unknown < 2; ++unknown) {
            for (int n = 0; n <= order; ++n) {
                const ball difference = expected.coefficients(unknown)[n] - actual.coefficients(unknown)[n];
                CHECK(contains_zero(difference));
                CHECK(midpoint_of(radius_of(difference)) < pow(mpfr(10), -40));
            }
        }
    }
}

TEST_CASE("functions fulfil their identities along a solution", "[function]") {
    const std::vector<std::pair<std::string, std::string>> identities{
        {"erf(u) + erfc(u)", "1"},
        {"sinh(asinh(u))", "u"},
        {"cosh(acosh(1 + u))", "1 + u"},
        {"tanh(atanh(u/4))", "u/4"},
        {"exp(log(10)*log10(u))", "u"},
        {"exp2(log2(u))", "u"},
        {"cbrt(u)^3", "u"},
        {"cbrt(-u)^3", "-u"},
        {"u*sinc(u)", "sin(u)"},
        {"expm1(u) + 1", "exp(u)"},
        {"log1p(u)", "log(1 + u)"},
        {"lambertw(u)*exp(lambertw(u))", "u"},
        {"lambertw(u*exp(u))", "u"},
        {"airy_ai(u)*airy_bi_prime(u) - airy_ai_prime(u)*airy_bi(u)", "1/pi"},
        {"bessel_j(1, u)*bessel_y(0, u) - bessel_j(0, u)*bessel_y(1, u)", "2/(pi*u)"},
        {"bessel_i(0, u)*bessel_k(1, u) + bessel_i(1, u)*bessel_k(0, u)", "1/u"},
        {"bessel_j(1, u) + bessel_j(3, u)", "4*bessel_j(2, u)/u"},
        {"bessel_j(-1, u)", "-bessel_j(1, u)"},
        {"bessel_i(-3, u)", "bessel_i(3, u)"},
        {"bessel_j(1/2, u)", "sqrt(2/pi)*sin(u)/sqrt(u)"},
        {"bessel_y(1/2, u)", "-sqrt(2/pi)*cos(u)/sqrt(u)"},
        {"bessel_i(-1/2, u)", "sqrt(2/pi)*cosh(u)/sqrt(u)"},
        {"bessel_k(3/2, u)", "sqrt(pi/2)*exp(-u)*(1 + 1/u)/sqrt(u)"},
        // K_(1/3) is Ai [DLMF 9.6.2].
        {"pi*sqrt(3/u)*airy_ai(u)", "bessel_k(1/3, 2*u^(3/2)/3)"},
    };
    for (const auto& [left, right] : identities) {
        INFO(left << " = " << right);
        const precision_scope scope(50);
        const explicit_system system(
            parse("u' = 1 - u^2/3 + t; u(0) = 3/4; l' = " + left + "; l(0) = 0; r' = " + right + "; r(0) = 0"));
        const tape steps = tape::about_start(system);
        taylor_expansion<ball> series(steps, 20);
        series.about_start();
        for (int n = 0; n <= 20; ++n) {
            const ball difference = series.coefficients(1)[n] - series.coefficients(2)[n];
            CHECK(contains_zero(difference));
            CHECK(midpoint_of(radius_of(difference)) < pow(mpfr(10), -30));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("values and series of functions agree with balls in every scalar", "[function][scalar]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const rational h(1, 64);
    const mpfr unit = widen(epsilon<T>());
    for (const place& p : places()) {
        INFO(text_of(p));
        const auto near = [&](const T& actual, const rational& x, long ulps) {
            const precision_scope scope(130);
            const mpfr truth = midpoint_of(function_value<ball>(p.f, from_rational<ball>(x), &p.order));
            const mpfr off = abs(mpfr(mpfr(widen(actual)) - truth));
            CHECK(off <= (abs(truth) + unit) * unit * ulps);
        };
        // At a number of T, so that the argument is exact; the C library's functions are within 2 units.
        const T x = from_rational<T>(p.at);
        rational exact = fraction_of(mpfr(widen(x)));
        near(function_value<T>(p.f, x, &p.order), exact, 4);
        // 24 terms of the quickest scalars are enough for 2^-60 and 2^-80; sums of alternating terms of size 1 round.
        if constexpr (std::is_floating_point_v<T>) {
            const T sum = sum_of_series<T>(applied(p, unknown("u")), exact, h, 24);
            const precision_scope scope(130);
            const mpfr truth =
                midpoint_of(function_value<ball>(p.f, from_rational<ball>(rational(exact + h)), &p.order));
            CHECK(abs(mpfr(mpfr(widen(sum)) - truth)) <= (abs(truth) + 1) * unit * 64);
        }
    }
}

TEST_CASE("numbers have the functions too, exact where they are rational", "[function]") {
    const std::vector<std::pair<std::string, std::string>> exact{
        {"erf(0)", "0"},     {"erfc(0)", "1"},        {"asinh(0)", "0"},       {"acosh(1)", "0"},
        {"atanh(0)", "0"},   {"log10(1000)", "3"},    {"log10(1/100)", "-2"},  {"log2(1/8)", "-3"},
        {"exp2(-3)", "1/8"}, {"cbrt(-27/8)", "-3/2"}, {"sinc(0)", "1"},        {"expm1(0)", "0"},
        {"log1p(0)", "0"},   {"lambertw(0)", "0"},    {"bessel_j(0, 0)", "1"}, {"bessel_i(-2, 0)", "0"},
    };
    for (const auto& [text, value] : exact) {
        INFO(text);
        const auto q = read_expression(text).fraction();
        REQUIRE(q);
        CHECK(*q == rational(value));
    }
    // [DLMF, PARI/GP 2.15: besselj(0,1), airy(1), lambertw(1), erfc(10)]
    const std::vector<std::pair<std::string, std::string>> decimals{
        {"bessel_j(0, 1)", "0.76519768655796655144971752610266322090927428975532524186154755"},
        {"airy_ai(1)", "0.13529241631288141552414742351546630617494414298833070600910205"},
        {"lambertw(1)", "0.56714329040978387299996866221035554975381578718651250813513108"},
        {"lambert_w(1)", "0.56714329040978387299996866221035554975381578718651250813513108"},
    };
    for (const auto& [text, value] : decimals) {
        INFO(text);
        const precision_scope scope(70);
        CHECK(abs(mpfr(rounded_value(read_expression(text)) - decimal(value).value)) < pow(mpfr(10), -60));
    }
    for (const std::string outside : {"acosh(1/2)", "atanh(1)", "log10(0)", "log2(-1)", "log1p(-1)", "lambertw(-1/2)",
                                      "bessel_y(0, -1)", "bessel_k(1, 0)", "bessel_j(1/2, -1)"}) {
        INFO(outside);
        CHECK_THROWS_AS(read_expression(outside), error);
    }
    for (const std::string wrong : {"bessel_j(1)", "bessel_j(pi, 1)", "erf(0, 1)", "bessel_j(0, 1, 2)"}) {
        INFO(wrong);
        CHECK_THROWS_AS(read_expression(wrong), error);
    }
}

TEST_CASE("the page of equations lists each function with its domain", "[function]") {
    std::ifstream page(std::filesystem::path(LIBRATION_SOURCE_DIR) / "docs" / "equations.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    for (std::size_t i = 0; i < function_kinds; ++i) {
        function::with_function(static_cast<function_kind>(i), [&](auto of) {
            const std::string line = "| `" + std::string(of.name) + "(" +
                                     (function::ordered<decltype(of)> ? "n, x" : "x") + ")` | " +
                                     std::string(of.domain) + " |";
            INFO(line);
            CHECK(text.find(line) != std::string::npos);
        });
    }
}

}  // namespace function_functions_test
