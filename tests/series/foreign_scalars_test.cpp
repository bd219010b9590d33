// Types that the library has never heard of run through the series of the pendulum by their scalar_traits alone, which
// stand behind every header of the library here.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/pendulum/coefficients.hpp"
#include "libration/pendulum/other_recurrences.hpp"
#include "libration/series/exponential.hpp"
#include "libration/series/tangent.hpp"

// Behind them: Boost's interval of two MPFR numbers.
#include <boost/multiprecision/mpfi.hpp>

namespace series_foreign_scalars_test {

using namespace libration;
using namespace libration::series;
using namespace libration::pendulum;
using interval = boost::multiprecision::mpfi_float;

/// value + slope d with d^2 = 0: a number and its derivative.
struct dual {
    mpfr value;
    mpfr slope;

    dual() = default;
    explicit dual(int n) : value(n), slope(0) {}
    dual(mpfr of_value, mpfr of_slope) : value(std::move(of_value)), slope(std::move(of_slope)) {}

    dual& operator+=(const dual& b) { return *this = *this + b; }
    dual& operator-=(const dual& b) { return *this = *this - b; }
    dual& operator*=(const dual& b) { return *this = *this * b; }
    dual& operator/=(const dual& b) { return *this = *this / b; }
    friend dual operator-(const dual& a) { return {-a.value, -a.slope}; }
    friend dual operator+(const dual& a, const dual& b) { return {a.value + b.value, a.slope + b.slope}; }
    friend dual operator-(const dual& a, const dual& b) { return {a.value - b.value, a.slope - b.slope}; }
    friend dual operator*(const dual& a, const dual& b) {
        return {a.value * b.value, a.value * b.slope + a.slope * b.value};
    }
    friend dual operator/(const dual& a, const dual& b) {
        return {a.value / b.value, (a.slope * b.value - a.value * b.slope) / (b.value * b.value)};
    }
    friend dual operator+(const dual& a, int n) { return {a.value + n, a.slope}; }
    friend dual operator*(const dual& a, int n) { return {a.value * n, a.slope * n}; }
    friend dual operator/(const dual& a, int n) { return {a.value / n, a.slope / n}; }

    friend dual sqrt(const dual& x) {
        const mpfr root = sqrt(x.value);
        return {root, x.slope / (root * 2)};
    }
    friend dual exp(const dual& x) { return {exp(x.value), exp(x.value) * x.slope}; }
    friend dual log(const dual& x) { return {log(x.value), x.slope / x.value}; }
    friend dual sin(const dual& x) { return {sin(x.value), cos(x.value) * x.slope}; }
    friend dual cos(const dual& x) { return {cos(x.value), -sin(x.value) * x.slope}; }
    friend dual tan(const dual& x) { return sin(x) / cos(x); }
};

}  // namespace series_foreign_scalars_test

namespace libration {

template <>
struct scalar_traits<series_foreign_scalars_test::dual> : default_scalar_traits<series_foreign_scalars_test::dual> {
    using dual = series_foreign_scalars_test::dual;

    static int digits() { return scalar_traits<mpfr>::digits(); }
    static dual epsilon() { return {scalar_traits<mpfr>::epsilon(), mpfr(0)}; }
    static dual pi() { return {scalar_traits<mpfr>::pi(), mpfr(0)}; }
    static dual from_rational(const rational& q) { return {scalar_traits<mpfr>::from_rational(q), mpfr(0)}; }
    static long binary_exponent(const dual& x) { return scalar_traits<mpfr>::binary_exponent(x.value); }
    static bool certainly_less(const dual& a, const dual& b) { return a.value < b.value; }
};

template <>
struct scalar_traits<boost::multiprecision::mpfi_float> : default_scalar_traits<boost::multiprecision::mpfi_float> {
    using interval = boost::multiprecision::mpfi_float;
    static constexpr bool proved = true;

    static int digits() { return static_cast<int>(mpfi_get_prec(interval().backend().data())); }
    static interval pi() {
        interval result;
        mpfi_const_pi(result.backend().data());
        return result;
    }
    static interval from_rational(const rational& q) {
        interval result;
        mpfi_set_q(result.backend().data(), q.backend().data());
        return result;
    }
    static interval enclose(const interval& value, const interval& bound) {
        const interval size = abs(bound);
        return value + interval(-upper(size), upper(size));
    }
    static long binary_exponent(const interval& x) {
        const auto largest = upper(interval(abs(x)));
        return largest == 0 ? exponent_of_zero : static_cast<long>(mpfr_get_exp(largest.backend().data()));
    }
    static interval midpoint(const interval& x) { return interval(median(x)); }
    static bool certainly_less(const interval& a, const interval& b) { return upper(a) < lower(b); }
};

}  // namespace libration

namespace series_foreign_scalars_test {

static_assert(scalar<interval> && proved_scalar<interval> && !rounding_scalar<interval>);
static_assert(scalar<dual> && rounding_scalar<dual> && !fixed_scalar<dual>);

namespace {

constexpr int order = 40;

/// The start with this angle and speed.
template <scalar T>
taylor_start<T> start_of(const T& theta, const T& omega) {
    using std::cos;
    using std::sin;
    const T s = sin(T(theta / 2));
    const T c = cos(T(theta / 2));
    const T kinetic = omega * omega / 2;
    return {{theta, omega, s, c}, {T(s * s * 2 + kinetic), T(c * c * 2 - kinetic)}, parity::any};
}

/// The top of libration with the energy 171/100, whose half angle has sine sqrt(E/2).
template <scalar T>
taylor_start<T> top_of_libration() {
    using std::sqrt;
    const T energy = from_rational<T>(rational(171) / 100);
    const T gap = from_rational<T>(rational(29) / 100);
    return {{T(0), T(0), T(sqrt(T(energy / 2))), T(sqrt(T(gap / 2)))}, {energy, gap}, parity::even};
}

template <scalar T>
std::vector<power_series<T>> all_ways(const taylor_start<T>& start) {
    const T scale(2);
    return {taylor_by_sine_cosine(start, order, scale), taylor_by_symmetric_squares(start, order, scale),
            taylor_by_speed(start, order, scale)};
}

/// Whether the interval holds x.
bool holds(const interval& a, const mpfr& x) { return mpfi_is_inside_fr(handle(x), a.backend().data()) != 0; }

void check_enclosures(const std::vector<power_series<interval>>& found, const std::vector<power_series<mpfr>>& truth) {
    for (std::size_t arc = 0; arc < found.size(); ++arc) {
        for (int n = 1; n <= order; ++n) {
            INFO("way " << arc << ", degree " << n);
            CHECK(holds(found[arc][n], truth.front()[n]));
            CHECK(width(found[arc][n]) < pow(mpfr(10), -40));
        }
    }
}

/// Intervals of 50 digits and numbers of 100.
struct both_precisions {
    both_precisions() : scope(100), previous(interval::thread_default_precision()) {
        interval::thread_default_precision(50);
    }
    both_precisions(const both_precisions&) = delete;
    both_precisions& operator=(const both_precisions&) = delete;
    ~both_precisions() { interval::thread_default_precision(previous); }

    precision_scope scope;
    unsigned previous;
};

template <scalar T>
T ratio(int above, int below) {
    return from_rational<T>(rational(above) / below);
}

}  // namespace

TEST_CASE("the pendulum's series in Boost's intervals contain those of twice the digits", "[series][foreign_scalars]") {
    const both_precisions precision;
    check_enclosures(all_ways(start_of(ratio<interval>(5, 4), ratio<interval>(-3, 10))),
                     all_ways(start_of(ratio<mpfr>(5, 4), ratio<mpfr>(-3, 10))));
    check_enclosures(all_ways(top_of_libration<interval>()), all_ways(top_of_libration<mpfr>()));
}

TEST_CASE("the functions of series run over Boost's intervals", "[series][foreign_scalars]") {
    const both_precisions precision;
    auto f = power_series<interval>::zero(order);
    for (int n = 0; n <= order; ++n) {
        f[n] = ratio<interval>(1, 3 + n * n);
    }
    const auto back = logarithm(exponential(f));
    const auto tan_f = arctangent(tangent(f));
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        CHECK(overlap(back[n], f[n]));
        CHECK(overlap(tan_f[n], f[n]));
        CHECK(width(back[n]) < pow(mpfr(10), -40));
    }
    CHECK(holds(enclose(interval(2), interval(-1)), mpfr(1)));
    CHECK(holds(enclose(interval(2), interval(-1)), mpfr(3)));
    CHECK(binary_exponent(interval(-5)) == 3);
    CHECK(holds(pi<interval>(), pi<mpfr>()));
}

TEST_CASE("a dual number differentiates the pendulum's series by the angle at the start", "[series][foreign_scalars]") {
    const precision_scope scope(50);
    const mpfr theta = ratio<mpfr>(5, 4);
    const mpfr omega = ratio<mpfr>(-3, 10);
    const auto found = all_ways(start_of(dual(theta, mpfr(1)), dual(omega, mpfr(0))));
    const auto plain = all_ways(start_of(theta, omega));
    // Difference quotients: with h = 10^-50 and 150 digits their error, h^2 times a third derivative, is far below.
    std::vector<mpfr> quotients;
    {
        const precision_scope wide(150);
        const mpfr h = pow(mpfr(10), -50);
        const auto above = all_ways(start_of(mpfr(ratio<mpfr>(5, 4) + h), ratio<mpfr>(-3, 10))).front();
        const auto below = all_ways(start_of(mpfr(ratio<mpfr>(5, 4) - h), ratio<mpfr>(-3, 10))).front();
        for (int n = 0; n <= order; ++n) {
            quotients.push_back((above[n] - below[n]) / (h * 2));
        }
    }
    for (std::size_t arc = 0; arc < found.size(); ++arc) {
        for (int n = 0; n <= order; ++n) {
            INFO("way " << arc << ", degree " << n);
            CHECK(abs(mpfr(found[arc][n].value - plain[arc][n])) < pow(mpfr(10), -46));  // mpfr fuses
            CHECK(abs(mpfr(found[arc][n].slope - quotients[static_cast<std::size_t>(n)])) < pow(mpfr(10), -44));
        }
    }
    // theta = theta0 + omega0 t - sin(theta0) t^2/2 - ..., in t/2.
    CHECK(found[0][1].slope == 0);
    CHECK(abs(mpfr(found[0][2].slope + cos(theta) * 2)) < pow(mpfr(10), -48));
}

TEST_CASE("any equation runs over a scalar of one's own", "[series][foreign_scalars][ode]") {
    const both_precisions precision;
    const ode::explicit_system system(ode::parse("x'' = -sin(x); x(0) = 5/4; x'(0) = -3/10"));
    const ode::tape about_start = ode::tape::about_start(system);
    const ode::tape about_points = ode::tape::about_points(system);
    ode::taylor_expansion<interval> enclosed(about_start, order);
    enclosed.about_start();
    ode::taylor_expansion<dual> varied(about_points, order);
    varied.about(dual(0), {{dual(ratio<mpfr>(5, 4), mpfr(1)), dual(ratio<mpfr>(-3, 10), mpfr(0))}});
    const auto truth = all_ways(start_of(dual(ratio<mpfr>(5, 4), mpfr(1)), dual(ratio<mpfr>(-3, 10), mpfr(0)))).front();
    for (int n = 0; n <= order; ++n) {
        INFO("degree " << n);
        const mpfr expected = ldexp(truth[n].value, -n);  // all_ways scales by 2
        CHECK(holds(interval(enclosed.coefficients(0)[n] + interval(-ldexp(mpfr(1), -300), ldexp(mpfr(1), -300))),
                    expected));
        CHECK(width(enclosed.coefficients(0)[n]) < pow(mpfr(10), -40));
        CHECK(abs(mpfr(varied.coefficients(0)[n].value - expected)) < pow(mpfr(10), -90));
        CHECK(abs(mpfr(varied.coefficients(0)[n].slope - ldexp(truth[n].slope, -n))) < pow(mpfr(10), -90));
    }
}

TEST_CASE("a dual number differentiates the functions of series", "[series][foreign_scalars]") {
    const precision_scope scope(50);
    // f = c + x: the derivative by c is that by x.
    auto f = power_series<dual>::zero(order);
    f[0] = dual(ratio<mpfr>(2, 3), mpfr(1));
    f[1] = dual(1);
    for (const auto& g : {exponential(f), logarithm(f), sine_cosine(f).first, tangent(f)}) {
        for (int n = 0; n < order; ++n) {
            INFO("degree " << n);
            const mpfr expected = g[n + 1].value * (n + 1);
            CHECK(abs(mpfr(g[n].slope - expected)) <= abs(expected) * pow(mpfr(10), -44));
        }
    }
}

}  // namespace series_foreign_scalars_test
