// Solutions with delays as objects, and the problems with delays of the catalogue.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/problem/catalogue.hpp"
#include "libration/problem/solution.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/scalar/text/decimal.hpp"

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
        const answer proved = x->states("25", proved_digits(25));
        const answer rounded = x->states("25", {.scalar = {scalar_kind::binary64, 17}});
        CHECK(rounded.rigour == "heuristic");
        for (const std::string& name : x->quantities()) {
            const mpfr exact = printed(proved, 0, name);
            // Some 100 steps with an error of some epsilon each, and the condition of the solution.
            CHECK(abs(mpfr(printed(rounded, 0, name) - exact)) < abs(exact) * 4096 * mpfr(epsilon<double>()));
        }
    }
    CHECK(count == 4);
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
