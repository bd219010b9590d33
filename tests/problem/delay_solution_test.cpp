// Solutions with delays as objects, and the problems with delays of the catalogue.
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "libration/problem/catalogue.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/decimal.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace problem_delay_solution_test {

using namespace libration;

namespace {

using polynomial = std::vector<rational>;

rational value_at(const polynomial& p, const rational& u) {
    rational value = 0;
    for (std::size_t n = p.size(); n-- > 0;) {
        value = value * u + p[n];
    }
    return value;
}

// The polynomial with this value at 0 and the derivative a + b.
polynomial integral(const rational& start, const polynomial& a, const polynomial& b) {
    polynomial result(std::max(a.size(), b.size()) + 1);
    result[0] = start;
    for (std::size_t n = 0; n + 1 < result.size(); ++n) {
        const rational slope = (n < a.size() ? a[n] : rational(0)) + (n < b.size() ? b[n] : rational(0));
        result[n + 1] = slope / rational(static_cast<long>(n) + 1);
    }
    return result;
}

mpfr printed(const answer& of, std::size_t row, const std::string& name) { return mpfr(of.at(row, name)); }

}  // namespace

TEST_CASE("Wille and Baker's problem has the polynomials of exact arithmetic", "[problem][delay][catalogue]") {
    constexpr long digits = 40;
    const precision_scope scope(2 * digits);
    const rational unit(1, 5);
    std::vector<polynomial> y1;
    std::vector<polynomial> y2;
    std::vector<rational> ends{1, 1, 1};
    const polynomial one{1};
    for (std::size_t k = 0; k < 25; ++k) {
        const polynomial earlier = k < 5 ? one : y1[k - 5];
        y1.push_back(integral(ends[0], earlier, {}));
        y2.push_back(integral(ends[1], earlier, k < 1 ? one : y2[k - 1]));
        ends = {value_at(y1[k], unit), value_at(y2[k], unit), value_at(integral(ends[2], y2[k], {}), unit)};
    }
    const answer found = solve(problem("wille_baker"))->states("5", proved_digits(digits));
    CHECK(found.rigour == "proved");
    for (std::size_t i = 0; i < 3; ++i) {
        const mpfr exact = from_rational<mpfr>(ends[i]);
        const mpfr value = printed(found, 0, "y" + std::to_string(i + 1));
        CHECK(abs(mpfr(value - exact)) <= abs(exact) * pow(mpfr(10), -(digits - 1)));
    }
}

TEST_CASE("the population of the infectious disease remains the same", "[problem][delay][catalogue]") {
    const precision_scope scope(60);
    const answer found = solve(problem("infectious_disease"))->states("40, 12", proved_digits(30));
    for (const std::size_t row : {0, 1}) {
        const mpfr sum = printed(found, row, "y1") + printed(found, row, "y2") + printed(found, row, "y3");
        CHECK(abs(mpfr(sum - mpfr(61) / 10)) < pow(mpfr(10), -28));
    }
}

namespace {

// y1, y2 of problem E2 of Paul's test set after four delays: on parts of so many equal lengths of a delay, each by Taylor
// polynomials, whose delayed ones are those of the part a delay earlier.
std::pair<mpfr, mpfr> predator_and_prey(int parts, std::size_t order) {
    using series = std::vector<mpfr>;
    const mpfr h = mpfr(21) / (50 * parts);
    const mpfr rho = mpfr(29) / 10;
    const mpfr alpha = mpfr(1) / 10;
    std::vector<series> earlier;
    for (int i = 0; i < parts; ++i) {
        series line(order + 1, mpfr(0));
        line[0] = mpfr(33) / 100 - (i - parts) * h / 10;
        line[1] = mpfr(-1) / 10;
        earlier.push_back(line);
    }
    const auto coefficient = [](const series& a, const series& b, std::size_t n) {
        mpfr sum = 0;
        for (std::size_t k = 0; k <= n; ++k) {
            sum += a[k] * b[n - k];
        }
        return sum;
    };
    const auto value = [&](const series& of) {
        mpfr sum = 0;
        for (std::size_t n = of.size(); n-- > 0;) {
            sum = sum * h + of[n];
        }
        return sum;
    };
    mpfr prey = mpfr(33) / 100;
    mpfr predator = mpfr(111) / 50;
    for (int delay = 0; delay < 4; ++delay) {
        for (series& old : earlier) {
            series y1{prey};
            series y2{predator};
            series square, share, growth;  // y1^2, y1^2/(y1^2 + 1), 1 - y1(t - tau) - rho y1'(t - tau)
            for (std::size_t n = 0; n < order; ++n) {
                square.push_back(coefficient(y1, y1, n));
                mpfr rest = square[n];
                for (std::size_t k = 0; k < n; ++k) {
                    rest -= share[k] * square[n - k];
                }
                share.push_back(rest / (1 + square[0]));
                growth.push_back((n == 0 ? 1 : 0) - old[n] - rho * (n + 1) * old[n + 1]);
                const mpfr eaten = coefficient(y2, share, n);
                y1.push_back((coefficient(y1, growth, n) - eaten) / (n + 1));
                y2.push_back((eaten - alpha * y2[n]) / (n + 1));
            }
            prey = value(y1);
            predator = value(y2);
            old = y1;
        }
    }
    return {prey, predator};
}

}  // namespace

TEST_CASE("the neutral predator and prey have the values of Taylor polynomials of two orders",
          "[problem][delay][catalogue]") {
    constexpr long digits = 30;
    const precision_scope scope(2 * digits);
    const auto exact = predator_and_prey(8, 50);
    const auto other = predator_and_prey(10, 56);
    CHECK(abs(mpfr(exact.first - other.first)) < mpfr("1e-38"));
    CHECK(abs(mpfr(exact.second - other.second)) < mpfr("1e-38"));
    const answer found = solve(problem("neutral_predator_prey"))->states("1.68", proved_digits(digits));
    CHECK(found.rigour == "proved");
    CHECK(abs(mpfr(printed(found, 0, "y1") - exact.first)) <= abs(exact.first) * pow(mpfr(10), -(digits - 1)));
    CHECK(abs(mpfr(printed(found, 0, "y2") - exact.second)) <= abs(exact.second) * pow(mpfr(10), -(digits - 1)));
}

TEST_CASE("the slope of a neutral equation jumps, so that events are not supported", "[problem][delay][catalogue]") {
    CHECK_THROWS_WITH(solve(problem("food_limited"))->events("y = 1", 1, proved_digits(20)),
                      Catch::Contains("is not supported with a delayed highest derivative"));
}

TEST_CASE("every problem with delays is proved, and the same in double", "[problem][delay][catalogue]") {
    const precision_scope scope(40);
    int count = 0;
    for (const catalogue_entry& each : catalogue()) {
        const problem given(each.name.data());
        if (!given.equations().has_delays()) {
            continue;
        }
        INFO(each.name);
        ++count;
        const auto x = solve(given);
        // A neutral equation has as many delays as pieces, and the pieces of this one have the length 0.42.
        const std::string time = each.name == "neutral_predator_prey" ? "4" : "25";
        const answer proved = x->states(time, proved_digits(25));
        const answer rounded = x->states(time, {.scalar = {scalar_kind::binary64, 17}});
        CHECK(rounded.rigour == "heuristic");
        for (const std::string& name : x->quantities()) {
            const mpfr exact = printed(proved, 0, name);
            // Some 100 steps with an error of some epsilon each, and the condition of the solution.
            CHECK(abs(mpfr(printed(rounded, 0, name) - exact)) < abs(exact) * 4096 * mpfr(epsilon<double>()));
        }
    }
    CHECK(count == 6);
}

TEST_CASE("a solution with delays answers nothing but values at times and events", "[problem][delay]") {
    const auto x = solve(problem("x' = -x(t - 1); x(t <= 0) = 1"));
    CHECK(x->quantities() == std::vector<std::string>{"x"});
    CHECK(x->states("2", rounded_digits(20)).at(0, "x") == "-0.50000000000000000000");
    request checked = proved_digits(20);
    checked.check = true;
    CHECK(x->states("2", checked).at(0, "x") == "-0.50000000000000000000");
    const auto rejects = [](const auto& ask, const std::string& reason) {
        CHECK_THROWS_WITH(ask(), Catch::Contains(reason));
    };
    rejects([&] { x->limits(proved_digits(20)); }, "time 'inf' is not supported for a problem with delays");
    CHECK(x->events("x = 1/2", 1, proved_digits(20)).at(0, "time") == "0.50000000000000000000");
    rejects([&] { x->events("x = c", 1, proved_digits(20)); }, "'c'");
    rejects([&] { x->series(5, "", proved_digits(20)); }, "for which only values at times and events are supported");
    rejects([&] { x->radius("", proved_digits(20)); }, "for which only values at times and events are supported");
    rejects([&] { x->singularities(1.0, proved_digits(20)); },
            "for which only values at times and events are supported");
    rejects([&] { x->states("1", {.derivatives = {"x(0)"}}); }, "derivatives 'x(0)' is not supported for a problem");
    rejects([&] { x->states("-1", proved_digits(20)); }, "is before the initial point");
    CHECK_THROWS_WITH(solve(problem("x' = -x(t - 1); x(t <= 0) = 1; when x = 0: stop")),
                      Catch::Contains("is not supported together with events"));
}

}  // namespace problem_delay_solution_test
