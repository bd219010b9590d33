// The series of tan at its pole compared with that of x cot x, also their tails; resonances of known systems.
#include "libration/plane/balance/balance_series.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/plane/balance/local_field.hpp"
#include "libration/plane/series_disc.hpp"
#include "libration/scalar/ball/functions.hpp"

namespace plane_balance_balance_series_test {

using namespace libration;
using namespace libration::ode;

namespace {

dominant_balance balance_of(const std::string& text, std::complex<double> place,
                            const std::vector<std::pair<std::complex<double>, double>>& leading) {
    const explicit_system system{parse(text)};
    const plane_system plane(system);
    const polynomial_form& form = plane.form().lifted;
    balance_sample sample{.place = place, .level = 28};
    for (const auto& [scale, order] : leading) {  // scale x^-order
        sample.values.push_back(scale * std::exp2(28 * order));
        sample.before.push_back(scale * std::exp2(27 * order));
    }
    return dominant_balance_of(*field_terms_of(form.system, form.leaves), sample);
}

}  // namespace

// y = 1/(t* x) x cot(t* x), x cot x = 1 - sum over k of 2 zeta(2k) (x/pi)^2k
TEST_CASE("the tail contains the terms beyond the polynomial", "[plane][proved]") {
    const precision_scope scope(30);
    const dominant_balance balance =
        balance_of("y' = 1 + y^2; y(0) = 0", std::numbers::pi / 2, {{2 / std::numbers::pi, 1}});
    CHECK(balance.step == 2);
    CHECK(balance.growing.empty());
    local_field field(balance);
    std::vector<complex_ball> scales;
    const complex_ball place(ball(pi<ball>() / 2));
    const auto at = field.at(complex_ball(0), place, {}, {}, scales);
    const weighted_monomials monomials({quadratic_number(rational(2))}, 6, 100);
    const auto series = series_of(balance, at, monomials);
    CHECK(monomials.count() == 4);
    const auto size = [](int k) { return 2 * std::riemann_zeta(2.0 * k) * std::exp2(-2.0 * k); };
    for (int k = 1; k < 4; ++k) {
        CHECK(std::abs(rounded_midpoint(series.nodes[0][static_cast<std::size_t>(k)]).real() + size(k)) < 1e-14);
    }
    const double radius = 0.6;  // of theta = x^2
    double beyond = 0;
    for (int k = 4; k < 200; ++k) {
        beyond += size(k) * std::pow(radius, k);
    }
    const auto tail = tail_of(balance, at, monomials, series, {magnitude::at_least(radius, 0)});
    REQUIRE(tail);
    CHECK(tail->beyond[0].above() >= beyond);
    CHECK(tail->beyond[0].above() < 1.7 * beyond);
    // beyond the next pole
    CHECK_FALSE(tail_of(balance, at, monomials, series, {magnitude::at_least(4.2, 0)}));
}

TEST_CASE("resonances of known systems", "[plane]") {
    const std::complex<double> i(0, 1);
    // Lorenz: x ~ 2i/tau, y ~ -2i/(10 tau^2), z ~ -2/(10 tau^2), tau = -t* x
    const std::complex<double> t(-0.25, 0.07);
    const auto lorenz = balance_of("x' = 10*(y-x); y' = x*(28-z)-y; z' = x*y - 8/3*z; x(0) = 1; y(0) = 1; z(0) = 1", t,
                                   {{-2.0 * i / t, 1}, {-0.2 * i / (t * t), 2}, {-0.2 / (t * t), 2}});
    std::vector<double> all;
    for (const quadratic_number& each : lorenz.eigenvalues) {
        CHECK(each.is_rational());
        all.push_back(each.real_part());
    }
    std::ranges::sort(all);
    CHECK(all == std::vector<double>{-1, 2, 4});
    CHECK(lorenz.step == 1);
    // Blasius: f ~ 6/tau, resonances 2 +- i sqrt 2
    const std::string text = "f''' = -f*f''/2; f(0) = 0; f'(0) = 0; f''(0) = 1";
    const auto blasius = balance_of(text, -4.0, {{1.5, 1}, {-6.0 / 16, 2}, {12.0 / 64, 3}});
    std::size_t found = 0;
    for (const quadratic_number& each : blasius.eigenvalues) {
        found += each.p == 2 && each.q * each.q * each.radicand == -2 ? 1U : 0U;
    }
    CHECK(found == 2);
    CHECK(blasius.step == 0);
    // another sign of the leading term is no balance
    CHECK_THROWS_AS(balance_of(text, -4.0, {{-1.5, 1}, {-6.0 / 16, 2}, {12.0 / 64, 3}}), error);
}

}  // namespace plane_balance_balance_series_test
