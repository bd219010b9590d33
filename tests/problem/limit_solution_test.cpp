// Solutions that conditions at infinity determine, at finite times and at the ends, compared with closed forms and with integrals.
#include "libration/problem/limit_solution.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/limit_condition.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/problem/find.hpp"
#include "libration/scalar/error.hpp"

namespace problem_limit_solution_test {

using namespace libration;

namespace {

limit_problem typed(const std::string& text, const std::string& unknown, const std::string& guess) {
    const auto separated = ode::with_limits_separated(text);
    return {
        problem(ode::changed(ode::parse(separated.problem), unknown + " = " + guess)), {unknown}, separated.limits, {}};
}

std::vector<exact> times_of(const std::vector<std::string>& words) {
    std::vector<exact> times;
    for (const std::string& each : words) {
        times.push_back(each == "inf" || each == "-inf" ? exact{0, unit::one, each} : read_exact(each));
    }
    return times;
}

std::string note_named(const answer& of, const std::string& name) {
    for (const answer_note& each : of.notes) {
        if (each.name == name) {
            return each.text;
        }
    }
    return "";
}

}  // namespace

// y = sqrt 2 sech t, by mpmath with 40 digits; on the manifold beyond t = 3, and at t = 100, where y is about 1e-43.
TEST_CASE("a soliton at finite times, at a late one and at infinity", "[problem][proved]") {
    const limit_solution soliton(typed("y'' = y - y^3; y'(0) = 0; y(inf) = 0", "y(0)", "1.4"));
    const auto found = soliton.states(times_of({"1", "100", "inf", "0"}), {"amplitude", "rate"},
                                      {.scalar = {scalar_kind::proved, 30}, .check = true});
    CHECK(found.names == std::vector<std::string>{"y", "y'", "rate 1", "amplitude of y"});
    CHECK(found.at(0, "y") == "0.916487142969312002551492271668");
    CHECK(found.at(1, "y") == "1.05219637966939898824288301420e-43");
    CHECK(found.at(2, "y") == "0");
    CHECK(found.at(2, "y'") == "0");
    CHECK(found.at(3, "y'") == "0");
    CHECK(found.at(2, "amplitude of y") == "2.82842712474619009760337744842");
    CHECK(note_named(found, "y(0)") == "1.41421356237309504880168872421");
    CHECK_FALSE(found.missing);
    CHECK_THROWS_AS(soliton.states(times_of({"-inf"}), {}, proved_digits(10)), error);
}

// (1 - 2 a)/sqrt 2, c/2, -1 of l = 1, and E_0 of x^4 as in eigenvalues.csv.
TEST_CASE("fronts, solitons and wells of the catalogue", "[problem][proved]") {
    const auto found = [](const std::string& name, const std::string& change, const std::string& unknown,
                          const std::vector<std::string>& limits) {
        const problem of(ode::changed(ode::parse(problem_text(name)), change));
        return find_unknowns(of, {unknown}, limits, proved_digits(20)).at(0, "value");
    };
    CHECK(found("nagumo", "a = 1/10", "c", {"u(-inf) = 1", "u(inf) = 0"}) == "0.56568542494923801952");
    CHECK(found("korteweg_de_vries", "c = 3", "u(0)", {"u(inf) = 0"}) == "1.5000000000000000000");
    CHECK(found("poeschl_teller", "l = 1", "E", {"psi(inf) = 0"}) == "-1.0000000000000000000");
    CHECK(found("quartic_oscillator", "E = 1", "E", {"psi(inf) = 0"}) == "1.0603620904841828996");
}

// f'(1) by Taylor series in mpmath with f''(0) = 0.46959998836101330450653365344758845872133407845029.
TEST_CASE("a boundary layer at finite times and its limits", "[problem][proved]") {
    const limit_solution layer(typed("f''' + f*f'' = 0; f(0) = 0; f'(0) = 0; f'(inf) = 1", "f''(0)", "0.5"));
    const auto found = layer.states(times_of({"1", "inf"}), {}, proved_digits(20));
    CHECK(found.at(0, "f'") == "0.46063257676899924547");
    CHECK(found.at(1, "f") == "inf");
    CHECK(found.at(1, "f'") == "1.0000000000000000000");
    CHECK(found.at(1, "f''") == "0");
}

// The front 1/(1 + exp(t/sqrt 2)) is visible where it is farther from 0 and 1 than 1/400: |t| < 8.5.
TEST_CASE("the visible part of a front", "[problem][proved]") {
    const limit_solution front(
        typed("u'' + c*u' + u*(1-u)*(u-1/4) = 0; u(0) = 0; u'(0) = 0; u(-inf) = 1; u(inf) = 0", "c", "0.3"));
    const auto times = front.visible_times(3, proved_digits(20));
    REQUIRE(times.size() == 3);
    const double first = std::stod(times.front().text);
    CHECK(first < -8.4);
    CHECK(first > -13);
    CHECK(std::stod(times.back().text) > 8.4);
    const auto states = front.states(times_of({"-inf", "0"}), {"angle"}, proved_digits(20));
    CHECK(states.at(0, "u") == "1.0000000000000000000");
    CHECK(states.at(1, "u") == "0.50000000000000000000");
    CHECK(states.at(1, "angle of intersection").starts_with("0.73230224898950"));
}

}  // namespace problem_limit_solution_test
