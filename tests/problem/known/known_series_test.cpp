#include "libration/problem/known/known_series.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "libration/series/exponential.hpp"
#include "reference_table.hpp"
#include "scalars.hpp"

namespace convergence_known_series_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

template <class T>
known_series<T> known(const std::string& name) {
    for (auto& each : all_known_series<T>()) {
        if (each.name == name) {
            return each;
        }
    }
    throw std::invalid_argument("no series " + name);
}

// Coefficients are narrowed from guard digits: half an eps, and one for the fraction that they are compared with.
constexpr long once_rounded = 1;

struct fractions {
    std::string name;
    int first;
    int step;
    std::vector<rational> values;  // a_first, a_{first + step}, ...
};

struct decimals {
    std::string name;
    int n;
    std::string value;
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("known series begin with their known fractions", "[convergence][known_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // tan, sec: DLMF 4.19.3, 4.19.5; Bernoulli's numbers 24.2.3; Langevin: Lagrange's inversion of coth y - 1/y in
    // fractions; the others by hand from their closed forms.
    const std::vector<fractions> all{
        {"log(1-t)", 0, 1, {0, -1, {-1, 2}, {-1, 3}, {-1, 4}}},
        {"(1-t)^(1/3)", 0, 1, {1, {-1, 3}, {-1, 9}, {-5, 81}}},
        {"(1-t)^(-5/2)", 0, 1, {1, {5, 2}, {35, 8}, {105, 16}}},
        {"(1-t)^(1/2)+3-2t+t^5", 0, 1, {4, {-5, 2}, {-1, 8}, {-1, 16}, {-5, 128}, {249, 256}, {-21, 1024}}},
        {"1/(1-t)^2", 0, 1, {1, 2, 3, 4, 5, 6}},
        {"1/(1-t)+1/(1-t/1.05)", 0, 1, {2, {41, 21}, {841, 441}}},
        {"log(1-t)+3log(1+t/1.02)", 0, 1, {0, {33, 17}, {-10101, 5202}}},
        {"1e-6log(1-t)+log(1+t/1.25)", 0, 1, {0, {799'999, 1'000'000}, {-640'001, 2'000'000}}},
        {"1/(1+t^2)", 0, 1, {1, 0, -1, 0, 1, 0, -1}},
        {"1/(1+t+t^2)", 0, 1, {1, -1, 0, 1, -1, 0}},
        {"tan t", 1, 2, {1, {1, 3}, {2, 15}, {17, 315}, {62, 2835}}},
        {"sec t", 0, 2, {1, {1, 2}, {5, 24}, {61, 720}, {277, 8064}}},
        {"t/(e^t-1)", 0, 1, {1, {-1, 2}, {1, 12}, 0, {-1, 720}, 0, {1, 30'240}, 0, {-1, 1'209'600}}},
        {"arctan t", 0, 1, {0, 1, 0, {-1, 3}, 0, {1, 5}}},
        {"arcsin t", 0, 1, {0, 1, 0, {1, 6}, 0, {3, 40}, 0, {15, 336}}},
        {"Catalan numbers", 0, 1, {1, 1, 2, 5, 14, 42, 132, 429}},
        {"Lambert W", 0, 1, {0, 1, -1, {3, 2}, {-8, 3}, {125, 24}}},
        {"inverse Langevin", 1, 2, {3, {9, 5}, {297, 175}, {1539, 875}, {126'117, 67'375}, {43'733'439, 21'896'875}}},
        {"e^t", 0, 1, {1, 1, {1, 2}, {1, 6}, {1, 24}}},
        {"cos t", 0, 1, {1, 0, {-1, 2}, 0, {1, 24}}},
        {"J0(t)", 0, 2, {1, {-1, 4}, {1, 64}, {-1, 2304}}},
        {"sum t^(2^k)", 0, 1, {0, 0, 1, 0, 1, 0, 0, 0, 1, 0}},
        {"sum t^(k^2)", 0, 1, {0, 1, 0, 0, 1, 0, 0, 0, 0, 1}},
        {"sum n! t^n", 0, 1, {1, 1, 2, 6, 24, 120}},
    };
    for (const auto& each : all) {
        CAPTURE(each.name);
        const int last = each.first + (static_cast<int>(each.values.size()) - 1) * each.step;
        const auto a = known<T>(each.name).coefficients(last);
        REQUIRE(a.order() == last);
        for (std::size_t i = 0; i < each.values.size(); ++i) {
            const int n = each.first + static_cast<int>(i) * each.step;
            CHECK_THAT(a[n], near<T>(from_rational<T>(each.values[i]), once_rounded));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("known series have the coefficients that mpmath gives", "[convergence][known_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // mpmath 1.2.1 with mp.dps = 70: legendre(30, 3/10), gegenbauer(7, -1/3, 9/10), gegenbauer(30, -1/2, -2/5),
    // airyai(0, derivative=0, 1), -euler, zeta(2), -zeta(3), taylor(f, 0, n)[n].
    const std::vector<decimals> all{
        {"(1-2ct+t^2)^(-1/2) c=0.3", 30, "0.14665500486868718984277486654067537204921245574951171875"},
        {"(1-2ct+t^2)^(1/3) c=0.9", 7, "0.0341266962962962962962962962962962962962962962962962962962963"},
        {"(1-2ct+t^2)^(1/2) c=-0.4", 30, "0.00433076738347969404629949153600000000000000000000000000000000"},
        {"Ai(t)", 0, "0.355028053887817239260063186004183176397979174199177240583327"},
        {"Ai(t)", 1, "-0.258819403792806798405183560189203963479091138354934582210002"},
        {"digamma(1+t)", 0, "-0.577215664901532860606512090082402431042159335939923598805767"},
        {"digamma(1+t)", 1, "1.64493406684822643647241516664602518921894990120679843773556"},
        {"digamma(1+t)", 2, "-1.20205690315959428539973816151144999076498629234049888179227"},
        {"tan t", 29, "0.00000261477115129075455426359425640974109737042991113553614024825"},
        {"e^t/(1-t/50)", 20, "0.000000000000000000671516670618468544047430416782619366056899614832209572509851"},
        {"(1-t)^(1/3)(1+t)^(-1/2)", 20, "0.155436060825001905291139469439152039914218627413687594538661"},
    };
    for (const auto& each : all) {
        CAPTURE(each.name, each.n);
        CHECK_THAT(known<T>(each.name).coefficients(each.n)[each.n], near<T>(decimal(each.value), once_rounded));
    }
    // log |1 - e^(i phi) t|^2 = -2 sum cos(n phi) t^n/n; an eps in the angle, 30 times.
    using std::acos;
    using std::cos;
    const T angle = acos(T(T(9) / 10));
    CHECK_THAT(known<T>("log(1-2ct+t^2) c=0.9").coefficients(30)[30],
               near<T>(T(-cos(T(angle * 30)) / 15), 120, T(T(1) / 15)));
    // K(m) = (pi/2)(1 + m/4 + 9 m^2/64 + 25 m^3/256 + ...) [DLMF 19.5.1]: two roundings more.
    CHECK_THAT(known<T>("K(m)").coefficients(3)[3], near<T>(T(pi<T>() / 512 * 25), 3));
}

TEMPLATE_LIST_TEST_CASE("recurrences of known series keep their digits", "[convergence][known_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // Each coefficient of order 200 against the same in 60 digits more, times 1/2 or 2 at each power lest it leave the
    // range of double: what a recurrence loses shows.
    for (const auto& each : all_known_series<T>()) {
        CAPTURE(each.name);
        const bool small_radius = each.radius && *each.radius < T(3) / 4;
        const T unit = small_radius ? T(1) / 2 : each.radius && *each.radius > 2 ? T(4) : T(1);
        const int order = each.coefficient_size == growth::geometric ? 200 : 100;
        const auto a = each.coefficients(order, unit);
        const mpfr eps = widen(epsilon<T>());
        const precision_scope scope(decimal_digits(digits<T>()) + 60);
        const auto more = rescale(each.expand(order), widen(unit));
        bool right = true;
        for (int n = 0; n <= order; ++n) {
            right = right && abs(widen(a[n]) - more[n]) <= abs(more[n]) * eps;
        }
        CHECK(right);
    }
}

TEMPLATE_LIST_TEST_CASE("known series say all that a radius test could find", "[convergence][known_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    std::set<std::string> names;
    for (const auto& each : all_known_series<T>()) {
        CAPTURE(each.name);
        CHECK(names.insert(each.name).second);
        CHECK(each.name.find(',') == std::string::npos);
        CHECK(each.radius.has_value() == (each.coefficient_size != growth::entire));
        CHECK(each.position.has_value() == (each.count > 0));
        CHECK(each.exponent.has_value() == (each.count > 0));
        CHECK((each.kind == singularity_kind::unknown) == (each.coefficient_size != growth::geometric));
        if (each.position) {
            // Two squares, a sum and a root.
            CHECK_THAT(modulus_of(*each.position), near<T>(*each.radius, 4));
            CHECK(each.position->im >= 0);
        }
        if (each.kind == singularity_kind::pole || each.kind == singularity_kind::logarithm) {
            CHECK(boost::multiprecision::denominator(*each.exponent) == 1);
            CHECK((*each.exponent < 0) == (each.kind == singularity_kind::pole));
        }
    }
    CHECK(names.size() == 42);
}

TEST_CASE("the coefficients of known series grow as their nearest singularities ask", "[convergence][known_series]") {
    const precision_scope scope(40);
    constexpr int order = 600;
    // |a_n| R^n ~ n^(-nu-1): the largest with 0.9 N < n <= N against the largest in the same part of N/2. A pair's
    // cosine spares a few per cent of the largest, a second singularity near to the circle adds 3 * 1.02^-270 = 1.4%: a
    // tenth in the exponent is allowed.
    const std::string stronger_at_minus_one = "(1-t)^(1/3)(1+t)^(-1/2)";
    for (const auto& each : all_known_series<mpfr>()) {
        if (!each.position) {
            continue;
        }
        CAPTURE(each.name);
        const auto a = each.coefficients(order, *each.radius);
        const auto largest_up_to = [&](int last) {
            mpfr largest(0);
            for (int n = last * 9 / 10 + 1; n <= last; ++n) {
                largest = std::max(largest, mpfr(abs(a[n])));
            }
            return largest;
        };
        const mpfr power = log(largest_up_to(order) / largest_up_to(order / 2)) / log(mpfr(2));
        const rational exponent = each.name == stronger_at_minus_one ? rational(-1, 2) : *each.exponent;
        const mpfr expected = -from_rational<mpfr>(exponent) - 1;
        CAPTURE(power, expected);
        CHECK(abs(power - expected) * 10 < 1);
    }
}

TEMPLATE_LIST_TEST_CASE("the nearest singularities without a closed form are where mpmath finds them",
                        "[convergence][known_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // mpmath 1.2.1 with mp.dps = 120: y = findroot(lambda y: sinh(y) + y, 2.25+4.21j); x = coth(y) - 1/y; abs(x), re,
    // im.
    const auto radius =
        decimal("0.904643679457683739246956773175964193511887570595313601840198234621608197193816063432162");
    const auto langevin = known<T>("inverse Langevin");
    CHECK_THAT(*langevin.radius, near<T>(radius, once_rounded));
    CHECK_THAT(langevin.position->re,
               near<T>(decimal("0.889240427271279413112393127164661205255149881300117458059356"), once_rounded));
    CHECK_THAT(langevin.position->im,
               near<T>(decimal("0.166227703133770314431063849404495603948193484457207289769489"), once_rounded));
    // In T itself: hyperbolic and trigonometric functions, twenty roundings; the last ones of y do not count,
    // x'(y) = 0.
    CHECK_THAT(modulus_of(inverse_langevin_singularity<T>()), near<T>(radius, 20));
    using std::exp;
    CHECK_THAT(*known<T>("Lambert W").radius, near<T>(T(exp(T(-1))), 2));
    CHECK_THAT(*known<T>("t/(e^t-1)").radius, near<T>(T(pi<T>() * 2), once_rounded));
}

TEMPLATE_LIST_TEST_CASE("the inverse Langevin series inverts Langevin's function", "[convergence][known_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // coth y - 1/y = t is y cosh y = (1 + t y) sinh y. All coefficients of y are positive up to here: those of y e^y
    // say how large the terms are whose sum is 0. Order 24: products of as many terms, three deep.
    constexpr int order = 24;
    const auto y = known<T>("inverse Langevin").coefficients(order);
    auto t = power_series<T>::zero(order);
    t[1] = T(1);
    auto minus_y = y;
    for (int n = 0; n <= order; ++n) {
        minus_y[n] = -y[n];
    }
    const auto growing = exponential(y);
    const auto falling = exponential(minus_y);
    const auto twice_sinh = growing - falling;
    const auto residual = y * (growing + falling) - twice_sinh - t * y * twice_sinh;
    const auto size = y * growing;
    for (int n = 0; n <= order; ++n) {
        CHECK_THAT(residual[n], near<T>(exactly(T(0)), 3 * order, T(size[n] + 1)));
    }
}

TEST_CASE("Blasius' constants are those of their generator", "[convergence][known_series]") {
    const auto table = reference_table("blasius.csv");
    REQUIRE(table.size() == 2);
    CHECK(table[0].at("quantity") == "curvature");
    CHECK(table[0].at("value") == blasius_curvature);
    CHECK(table[1].at("quantity") == "radius");
    CHECK(table[1].at("value") == blasius_radius);
}

TEST_CASE("the coefficients of Blasius' series agree with its radius", "[convergence][known_series]") {
    const precision_scope scope(60);
    // c_k R^3k tends to a constant with alternating sign; the powers u^(1 +- i sqrt 2) beside the pole 6/u add k^(-2)
    // to it, so ratios are R^-3 up to k^-3. The constant of that is not known: from 100 to 400 it has to fall by
    // 4^3 = 64, half of which is allowed for its oscillation.
    const auto a = known<mpfr>("Blasius").coefficients(1202);
    const mpfr radius = from_exact<mpfr>(read_exact(blasius_radius));
    const mpfr cube = radius * radius * radius;
    const auto largest_error = [&](int k) {
        mpfr largest(0);
        for (int i = k / 2; i <= k; ++i) {
            const mpfr error = a[3 * i + 2] / a[3 * i - 1] * cube + 1;
            largest = std::max(largest, mpfr(abs(error)));
        }
        return largest;
    };
    CHECK(largest_error(400) < largest_error(100) / 32);
    CHECK(largest_error(400) < mpfr(1) / 1'000'000);
    // f = 6/u about -R, and the same about R e^(+-i pi/3): c_k = 3 * 6/R * (-1)^k R^-(3k+2) to order k^-2.
    const mpfr amplitude = a[1202] * pow(radius, 1203) / 18;
    CHECK(abs(abs(amplitude) - 1) < mpfr(1) / 10'000);
}

TEST_CASE("known series are scaled before they are rounded", "[convergence][known_series]") {
    // n! R^-n and R^-n leave the range of double.
    const auto blasius = known<double>("Blasius");
    const auto scaled = blasius.coefficients(1200, *blasius.radius);
    CHECK(scaled[1199] != 0);
    CHECK(blasius.coefficients(1200)[1199] == 0);
    const auto factorials = known<double>("sum n! t^n").coefficients(300, 1 / 128.0);
    CHECK(factorials[300] > 0);
    CHECK(factorials[300] < std::numeric_limits<double>::infinity());
}

TEMPLATE_LIST_TEST_CASE("recurrences of special functions run in every scalar", "[convergence][known_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    constexpr int order = 30;
    const std::vector<std::pair<std::string, power_series<T>>> all{
        {"(1-t)^(1/3)", binomial_series(T(T(1) / 3), order)},
        {"(1-t)^(1/3)(1+t)^(-1/2)", opposite_powers_series(T(T(1) / 3), T(T(-1) / 2), order)},
        {"tan t", tangent_series<T>(order)},
        {"sec t", secant_series<T>(order)},
        {"t/(e^t-1)", bernoulli_series<T>(order)},
        {"Catalan numbers", catalan_series<T>(order)},
        {"Lambert W", lambert_series<T>(order)},
        {"K(m)", parameter_series_of_k<T>(order)},
        {"digamma(1+t)", digamma_series<T>(order)},
        {"inverse Langevin", inverse_langevin_series<T>(order)},
        {"Blasius", blasius_series<T>(order)},
        {"J0(t)", bessel_series<T>(order)},
        {"Ai(t)", airy_series<T>(order)},
    };
    // A few roundings a step, order steps; those of W are of powers n - 2.
    for (const auto& [name, a] : all) {
        CAPTURE(name);
        const auto expected = known<T>(name).coefficients(order);
        for (int n = 0; n <= order; ++n) {
            CHECK_THAT(a[n], near<T>(expected[n], name == "Lambert W" ? order * order : 3 * order));
        }
    }
}

}  // namespace convergence_known_series_test
