// Solutions of delay differential equations, against piecewise polynomials in exact arithmetic, closed forms, and chains of
// ordinary equations that another integrator proves.
#include "libration/query/delay_trajectory.hpp"

#include <boost/math/constants/constants.hpp>
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libration/digits/proved_decimals.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/integration/delay/delay_errors.hpp"
#include "libration/integration/proved_march.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace ode_delay_trajectory_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr long digits = 30;

std::vector<number> times_of(const std::vector<rational>& times) {
    std::vector<number> result;
    for (const rational& each : times) {
        result.emplace_back(each);
    }
    return result;
}

partial_trajectory proved_values(const std::string& text, const std::vector<number>& times) {
    return proved_part_of_delay(delay_system(parse(text)), times, digits);
}

// Whether a proved decimal of 30 digits is within one unit of its last digit of a number with more digits.
bool agrees(const known_value& value, const mpfr& exact) {
    REQUIRE(value.decimal);
    return abs(mpfr(mpfr(value.decimal->text) - exact)) <= abs(exact) * pow(mpfr(10), -(digits - 1));
}

mpfr in_mpfr(const rational& q) { return from_rational<mpfr>(q); }

using polynomial = std::vector<rational>;

rational value_at(const polynomial& p, const rational& u) {
    rational value = 0;
    for (std::size_t n = p.size(); n-- > 0;) {
        value = value * u + p[n];
    }
    return value;
}

// start + the integral of factor_1 p_1 + ...
polynomial integral(const rational& start, const std::vector<std::pair<rational, polynomial>>& of) {
    polynomial result{start};
    for (const auto& [factor, p] : of) {
        result.resize(std::max(result.size(), p.size() + 1));
        for (std::size_t n = 0; n < p.size(); ++n) {
            result[n + 1] += factor * p[n] / rational(static_cast<long>(n) + 1);
        }
    }
    return result;
}

// The pieces of length `unit` of x' = sum of factors[j] x(t - delays[j] unit), x = 1 for t <= 0, by the method of steps.
std::vector<polynomial> pieces_of(const std::map<std::size_t, rational>& factors, const rational& unit,
                                  std::size_t count) {
    std::vector<polynomial> pieces;
    rational start = 1;
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<std::pair<rational, polynomial>> terms;
        for (const auto& [delay, factor] : factors) {
            terms.emplace_back(factor, k >= delay ? pieces[k - delay] : polynomial{1});
        }
        pieces.push_back(integral(start, terms));
        start = value_at(pieces.back(), unit);
    }
    return pieces;
}

// In pieces of length `unit`: the proved digits at the middle and the end of each are those of the polynomials.
void check_pieces(const std::string& text, const std::map<std::size_t, rational>& factors, const rational& unit,
                  std::size_t count) {
    INFO(text);
    const precision_scope scope(60);
    const auto pieces = pieces_of(factors, unit, count);
    std::vector<rational> times;
    std::vector<rational> exact;
    for (std::size_t k = 0; k < count; ++k) {
        for (const rational& part : {rational(unit / 2), unit}) {
            times.emplace_back(unit * static_cast<long>(k) + part);
            exact.push_back(value_at(pieces[k], part));
        }
    }
    const auto found = proved_values(text, times_of(times));
    for (std::size_t i = 0; i < times.size(); ++i) {
        INFO("time " << times[i]);
        const known_value& value = found.states[i][0];
        CHECK((exact[i] == 0 ? !value.decimal || value.decimal->text == "0" : agrees(value, in_mpfr(exact[i]))));
    }
}

// Enclosures with so few bits that the bounds of truncation are most of their radii contain the exact values.
template <class Exact>
void check_enclosures(const std::string& text, const std::vector<rational>& times, const Exact& exact) {
    INFO(text);
    for (const long bits : {16, 20, 28}) {
        INFO(bits << " bits");
        const auto found = enclosed_delay(delay_system(parse(text)), times_of(times), bits);
        REQUIRE(found);
        for (std::size_t i = 0; i < times.size(); ++i) {
            INFO("time " << times[i]);
            CHECK(contains((*found)[i][0], exact(i)));
            CHECK((bits < 28 || certainly_less(radius_of((*found)[i][0]), ball(1) / 16)));
        }
    }
}

}  // namespace

TEST_CASE("linear equations have the piecewise polynomials of exact arithmetic", "[ode][delay][proved]") {
    check_pieces("x' = -x(t - 1); x(t <= 0) = 1", {{1, -1}}, 1, 12);
    check_pieces("x' = -3*x(t - 1/3); x(t <= 0) = 1", {{1, -3}}, rational(1, 3), 9);
    check_pieces("x' = -x(t - 1) + x(t - 3/2)/2; x(t <= 0) = 1", {{2, -1}, {3, rational(1, 2)}}, rational(1, 2), 14);
    check_pieces("x' = x(t - 1/7) - 2*x(t - 2/5); x(t <= 0) = 1", {{5, 1}, {14, -2}}, rational(1, 35), 40);
}

// v = x - 1 has v' = -1 - (v(t - 1) + v(t - sqrt 2) + v(t - sqrt 3))/3, with the sum over the numbers of all delays.
TEST_CASE("incommensurable delays have the values of the sum over their multiples", "[ode][delay][proved]") {
    const precision_scope scope(80);
    const rational time(13, 2);
    const mpfr t = in_mpfr(time);
    mpfr exact = 1;
    for (int n = 0; n < 7; ++n) {
        for (int m = 0; m < 5; ++m) {
            for (int k = 0; k < 4; ++k) {
                const mpfr rest = t - n - m * sqrt(mpfr(2)) - k * sqrt(mpfr(3));
                if (rest <= 0) {
                    continue;
                }
                // -rest^(n + m + k + 1)/((n + m + k + 1) n! m! k!) (-1/3)^(n + m + k)
                mpfr term = -rest / (n + m + k + 1);
                for (const int count : {n, m, k}) {
                    for (int i = 1; i <= count; ++i) {
                        term *= -rest / (3 * i);
                    }
                }
                exact += term;
            }
        }
    }
    const auto found =
        proved_values("x' = -(x(t - 1) + x(t - sqrt(2)) + x(t - sqrt(3)))/3; x(t <= 0) = 1", times_of({time}));
    CHECK(agrees(found.states[0][0], exact));
}

TEST_CASE("solutions in closed form", "[ode][delay][proved]") {
    const precision_scope scope(60);
    const auto times = times_of({rational(1, 2), 3, 10});
    const auto sine = proved_values("x' = -x(t - pi/2); x(t <= 0) = sin(t)", times);
    const auto oscillator = proved_values("x'' = -x(t - 2*pi)/2 - x'(t - pi/2)/2; x(t <= 0) = sin(t)", times);
    const auto decay = proved_values("y' = -y(t - 1)*exp(-1)*s; s' = 0; y(t <= 0) = exp(-t); s(0) = 1", times);
    const auto forced = proved_values("z' = log(z(t - 1)) + z/(t + 1) - log(t); z(t <= 1) = t + 1", times_of({3, 10}));
    for (std::size_t i = 0; i < times.size(); ++i) {
        const mpfr t = constant_value<mpfr>::of(times[i]);
        CHECK(agrees(sine.states[i][0], sin(t)));
        CHECK(agrees(oscillator.states[i][0], sin(t)));
        CHECK(agrees(oscillator.states[i][1], cos(t)));
        CHECK(agrees(decay.states[i][0], exp(mpfr(-t))));
    }
    CHECK(agrees(forced.states[0][0], mpfr(4)));
    CHECK(agrees(forced.states[1][0], mpfr(11)));
}

// x_j(s) = x(2 j + s) for 0 <= s <= 2 is a system of ordinary equations.
TEST_CASE("Mackey and Glass's equation has the values of its chain of ordinary equations", "[ode][delay][proved]") {
    constexpr long bits = 200;
    const precision_scope scope(60);
    const std::string history = "(1/2 + (t - 2)/10)";
    std::string text = "x0' = 0.2*" + history + "/(1 + " + history + "^9.65) - 0.1*x0; x0(0) = 1/2";
    std::vector<ball> start{ball(1) / 2};
    std::vector<ball> at_half;
    for (int j = 1; j <= 4; ++j) {
        const auto half = proved_march(explicit_system(parse(text)), start, bits).at(number(rational(1)));
        const auto end = proved_march(explicit_system(parse(text)), start, bits).at(number(rational(2)));
        REQUIRE(half);
        REQUIRE(end);
        at_half.push_back(half->back());
        start.push_back(end->back());
        const std::string before = "x" + std::to_string(j - 1);
        const std::string now = "x" + std::to_string(j);
        text += "; " + now + "' = 0.2*" + before + "/(1 + " + before + "^9.65) - 0.1*" + now + "; " + now + "(0) = 1";
    }
    const std::string mackey_glass =
        "x' = 0.2*x(t - tau)/(1 + x(t - tau)^9.65) - 0.1*x; x(t <= 0) = 1/2 + t/10; tau = 2";
    const auto found = proved_values(mackey_glass, times_of({1, 3, 5, 7, 8}));
    for (std::size_t j = 0; j < 4; ++j) {
        CHECK(agrees(found.states[j][0], midpoint_of(at_half[j])));
    }
    CHECK(agrees(found.states[4][0], midpoint_of(start[4])));
    check_enclosures(mackey_glass, {1, 3, 5, 7, 8}, [&](std::size_t i) { return i < 4 ? at_half[i] : start[4]; });
}

TEST_CASE("enclosures by few bits contain the solution", "[ode][delay][proved]") {
    const precision_scope scope(60);
    const std::vector<rational> times{1, 2, 5, rational(19, 2)};
    const auto sine = [&](std::size_t i) { return sin(constant_value<ball>::of(number(times[i]))); };
    check_enclosures("x' = -x(t - pi/2); x(t <= 0) = sin(t)", times, sine);
    check_enclosures("x'' = -x(t - 2*pi)/2 - x'(t - pi/2)/2; x(t <= 0) = sin(t)", times, sine);
    check_enclosures("x' = -x(t - pi/2)*3/5 + x(t - 3*pi/2)*2/5; x(t <= 0) = sin(t)", times, sine);
    // With y = x(t - 1)^2/x(t - 1) instead of x(t - 1), which has other unknowns in polynomial form.
    check_enclosures("x' = -x(t - 1)^2/x(t - 1)*exp(-1); x(t <= 0) = exp(-t)", {1, 2, 3},
                     [&](std::size_t i) { return exp(-ball(static_cast<int>(i) + 1)); });
}

// The errors of the first steps are by far the largest at the end, so that a bound of a single step does not cover them.
TEST_CASE("enclosures contain solutions whose errors grow", "[ode][delay][proved]") {
    const precision_scope scope(60);
    // By the delayed value.
    const std::vector<rational> times{2, rational(13, 2), rational(19, 2)};
    check_enclosures("x' = cos(t) + 6*(sin(t - 1) - x(t - 1)); x(t <= 0) = sin(t)", times,
                     [&](std::size_t i) { return sin(constant_value<ball>::of(number(times[i]))); });
    // By the value itself, like e^(3 t).
    check_enclosures("x' = 3*x - 2*exp(1)*y(t - 1); y' = y; x(0) = 1; y(t <= 0) = exp(t)", {1, 2, 3, 4},
                     [&](std::size_t i) { return exp(ball(static_cast<int>(i) + 1)); });
}

namespace {

partial_trajectory neutral_values(const std::string& text, const std::vector<number>& times) {
    return proved_part_of_delay(delay_system(parse(text), times.back()), times, digits);
}

// y' = r y (1 - y(t - 1) - c y'(t - 1)), y = 2 + t for t <= 0, at the integer `last`: on parts of so many equal lengths, each by
// a Taylor polynomial, whose delayed ones are those of the part a unit of time earlier.
mpfr food_limited(long last, int parts, int order) {
    const mpfr h = mpfr(1) / parts;
    const mpfr pi = boost::math::constants::pi<mpfr>();
    const mpfr r = pi / sqrt(mpfr(3)) + mpfr(1) / 20;
    const mpfr c = sqrt(mpfr(3)) / (2 * pi) - mpfr(1) / 25;
    using series = std::vector<mpfr>;
    std::vector<series> earlier;
    for (int i = 0; i < parts; ++i) {
        series line(static_cast<std::size_t>(order) + 1, mpfr(0));
        line[0] = 1 + i * h;
        line[1] = 1;
        earlier.push_back(line);
    }
    mpfr start = 2;
    for (long unit_of_time = 0; unit_of_time < last; ++unit_of_time) {
        for (series& old : earlier) {
            series now{start};
            series factor;  // 1 - y(t - 1) - c y'(t - 1)
            for (std::size_t n = 0; n < static_cast<std::size_t>(order); ++n) {
                factor.push_back((n == 0 ? 1 : 0) - old[n] - c * (n + 1) * old[n + 1]);
                mpfr sum = 0;
                for (std::size_t k = 0; k <= n; ++k) {
                    sum += now[k] * factor[n - k];
                }
                now.push_back(r * sum / (n + 1));
            }
            start = 0;
            for (std::size_t n = now.size(); n-- > 0;) {
                start = start * h + now[n];
            }
            old = now;
        }
    }
    return start;
}

}  // namespace

TEST_CASE("neutral equations have the values of closed forms", "[ode][delay][proved]") {
    const precision_scope scope(80);
    // The slope is n + 2 between n and n + 1.
    const auto stairs = neutral_values("x' = x'(t - 1) + 1; x(t <= 0) = t", times_of({1, rational(5, 2), 3}));
    CHECK(agrees(stairs.states[0][0], mpfr(2)));
    CHECK(agrees(stairs.states[1][0], mpfr(7)));
    CHECK(agrees(stairs.states[2][0], mpfr(9)));
    // t + (t - 1) + ... with n + 1 terms.
    const auto ramps = neutral_values("x' = x'(t - 1) + t; x(t <= 0) = 0", times_of({2, 3}));
    CHECK(agrees(ramps.states[0][0], mpfr(5) / 2));
    CHECK(agrees(ramps.states[1][0], mpfr(7)));
    // e^t, sin t, and t^2 with two delays, whose sums are equal in several ways.
    const auto growth = neutral_values("x' = (x + exp(1)*x'(t - 1))/2; x(t <= 0) = exp(t)", times_of({rational(7, 2)}));
    CHECK(agrees(growth.states[0][0], exp(mpfr(7) / 2)));
    const auto wave = neutral_values("x'' = -x''(t - pi); x(t <= 0) = sin(t)", times_of({1, 8}));
    CHECK(agrees(wave.states[0][0], sin(mpfr(1))));
    CHECK(agrees(wave.states[1][0], sin(mpfr(8))));
    CHECK(agrees(wave.states[1][1], cos(mpfr(8))));
    const auto square = neutral_values(
        "x' = (x'(t - 1) + 2)/3 + 2*(x'(t - 1/2) + 1)/3; y' = x'(t - 1/2) + 1; "
        "x(t <= 0) = t^2; y(0) = 0",
        times_of({rational(3, 4), rational(7, 2)}));
    for (const auto& [i, exact] : {std::pair(0U, mpfr(9) / 16), std::pair(1U, mpfr(49) / 4)}) {
        CHECK(agrees(square.states[i][0], exact));
        CHECK(agrees(square.states[i][1], exact));
    }
}

// Problem E1 of Paul's test set.
TEST_CASE("a neutral equation has the values of another method of two orders", "[ode][delay][proved]") {
    const precision_scope scope(80);
    const std::string text =
        "y' = r*y*(1 - y(t - 1) - c*y'(t - 1)); y(t <= 0) = 2 + t; r = pi/sqrt(3) + 1/20; c = sqrt(3)/(2*pi) - 1/25";
    const auto found = neutral_values(text, times_of({1, 2, 6}));
    for (const auto& [i, time] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 6)}) {
        const mpfr exact = food_limited(time, 8, 60);
        CHECK(abs(exact - food_limited(time, 10, 64)) < mpfr("1e-40"));
        CHECK(agrees(found.states[static_cast<std::size_t>(i)][0], exact));
    }
    // Beyond the last time of the system.
    const auto beyond = proved_part_of_delay(delay_system(parse(text), number(rational(1))), times_of({3}), digits);
    CHECK(beyond.states[0].empty());
    CHECK(beyond.missing);
}

TEST_CASE("solutions that do not reach a time say up to where they do", "[ode][delay][proved]") {
    // On 0 <= t <= 1 x' = x^2: x = 1/(1 - t).
    const auto found = proved_values("x' = x^2*x(t - 1); x(t <= 0) = 1", times_of({rational(1, 2), 2}));
    REQUIRE(found.states[0][0].decimal);
    CHECK(found.states[0][0].decimal->text.starts_with("2.0000000"));
    CHECK(found.states[1].empty());
    REQUIRE(found.missing);
    CHECK_THAT(found.missing->what(), Catch::Contains("time '2' is not reached: the solution is proved to "
                                                      "exist up to 0.99"));
    CHECK_THROWS_WITH(proved_values("x' = -x(t - 1); x(t <= 0) = 1", times_of({-1})),
                      Catch::Contains("is before the initial point, where the solution is the history"));
}

TEMPLATE_TEST_CASE("arithmetic that rounds has the accuracy of its scalar", "[ode][delay]", double, long double, quad) {
    const precision_scope scope(60);
    const std::vector<rational> times{1, 4, 9};
    const auto pieces = pieces_of({{2, -1}, {3, rational(1, 2)}}, rational(1, 2), 20);
    const delay_system system(parse("x' = -x(t - 1) + x(t - 3/2)/2; x(t <= 0) = 1"));
    const auto found = part_of_delay<TestType>(system, times_of(times));
    CHECK_FALSE(found.missing);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const mpfr exact = in_mpfr(value_at(pieces[static_cast<std::size_t>(times[i] * 2) - 1], rational(1, 2)));
        // A rounding error in each of some 20 steps, of numbers below 2.
        CHECK(abs(mpfr(widen(found.states[i][0][0]) - exact)) < 64 * widen(epsilon<TestType>()));
    }
}

TEST_CASE("terms of a series that are left out are bounded", "[ode][delay]") {
    // 1 + x + .. + x^9 at 1/2.
    std::vector<ball> series(10, ball(1));
    const magnitude rest = shorten_series(series, 3, magnitude(ball(1) / 2));
    CHECK(series.size() == 4);
    const ball exact = (ball(128) - ball(1)) / 512;  // 2^-3 + .. + 2^-9
    CHECK(magnitude(exact) <= rest);
    CHECK(rest <= magnitude(exact * 2));
}

}  // namespace ode_delay_trajectory_test
