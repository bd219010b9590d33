// A solution as an object: closed forms of elementary problems, and the pendulum however it is written, by its closed
// form and by Taylor series.
#include "libration/problem/solution.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/known/pendulum_solution.hpp"
#include "libration/problem/proved_law.hpp"
#include "libration/scalar/error.hpp"

namespace problem_solution_test {

using namespace libration;

namespace {

const std::string tangent = "x' = 1 + x^2; x(0) = 0";

}  // namespace

TEST_CASE("a solution has states, events, series and a radius", "[problem]") {
    const auto x = solve(problem(tangent));
    CHECK(x->quantities() == std::vector<std::string>{"x"});
    CHECK(x->closed_form().empty());
    const answer states = x->states("pi/4, -pi/6, 0", proved_digits(20));
    CHECK(states.rigour == "proved");
    CHECK(states.at(0, "x") == "1.0000000000000000000");
    CHECK(states.at(1, "x") == "-0.57735026918962576451");
    CHECK(states.at(2, "x") == "0");
    CHECK_THROWS_AS(states.at(0, "y"), error);
    CHECK_THROWS_WITH(states.at(3, "x"), Catch::Contains("row '3' is beyond the last row"));
    CHECK(x->states("pi/4", rounded_digits(15)).rigour == "two-method");
    const answer events = x->events("x = sqrt(3)", 1, proved_digits(20));
    CHECK(events.at(0, "time") == "1.0471975511965977462");  // pi/3
    const answer series = x->series(5, "", proved_digits(10));
    CHECK(series.at(5, "x") == "0.1333333333");
    CHECK(series.at(4, "x") == "0");
    CHECK(x->series(1, "pi/4", proved_digits(10)).at(1, "x") == "2.000000000");
    const answer radius = x->radius("", proved_digits(10));
    CHECK(radius.at(0, "lower").starts_with("1.57079632"));
    CHECK(radius.at(0, "upper").starts_with("1.57079632"));
}

TEST_CASE("a solution keeps its steps for further questions", "[problem]") {
    const auto x = solve(problem(tangent));
    long observed = 0;
    request how = proved_digits(30);
    how.observer = [&](const ode::step_report&) { ++observed; };
    CHECK(x->states("pi/4, -pi/6", how).at(0, "x").starts_with("1.0000"));
    const long steps = observed;
    CHECK(steps > 0);
    CHECK(x->steps_made() == static_cast<std::size_t>(steps));
    CHECK(x->states("-pi/6, pi/6, pi/4", how).at(1, "x") == "0.577350269189625764509148780502");
    CHECK(x->states("pi/4", proved_digits(20)).at(0, "x") == "1.0000000000000000000");
    CHECK(x->events("x = sqrt(3)/3", 1, proved_digits(30)).at(0, "time") == "0.523598775598298873077107230547");
    CHECK(observed == steps);
    CHECK(x->steps_made() == static_cast<std::size_t>(steps));
    // Farther than before the steps are continued, with more digits they are made anew.
    CHECK(x->states("pi/3", how).at(0, "x") == "1.73205080756887729352744634151");
    CHECK(observed > steps);
    CHECK(observed < 3 * steps);
    const auto before = x->steps_made();
    CHECK(x->states("pi/4", proved_digits(100)).at(0, "x").starts_with("1.00000000000000000000000000000000000000000"));
    CHECK(x->steps_made() > before);
    CHECK(x->series(1, "pi/4", proved_digits(10)).at(1, "x") == "2.000000000");
}

TEST_CASE("independent parts of a system keep their own steps", "[problem]") {
    const auto both = solve(problem("x' = 1 + x^2; x(0) = 0; y' = -y^2; y(0) = 1"));
    const auto first = both->states("pi/4", proved_digits(20));
    CHECK(first.at(0, "x") == "1.0000000000000000000");
    const auto steps = both->steps_made();
    CHECK(both->states("pi/4", proved_digits(20)).at(0, "y") == first.at(0, "y"));
    CHECK(both->steps_made() == steps);
    // Events are those of the whole system: x = y where tan t = 1/(1 + t).
    CHECK(both->events("x = 1", 1, proved_digits(20)).at(0, "time") == "0.78539816339744830962");
}

TEST_CASE("a solution has a radius about any point, fractions and singularities", "[problem]") {
    const auto x = solve(problem(tangent));
    // About pi/4 the nearest pole of the tangent is pi/4 away.
    const answer tests = x->radius({.order = 80, .about = "pi/4"}, rounded_digits(30));
    CHECK(tests.rigour == "heuristic");
    CHECK(tests.at(0, "method") == "verdict");
    CHECK(tests.at(0, "radius").starts_with("0.78539816339744830961"));
    CHECK(tests.at(0, "kind") == "pole");
    const auto fractions = x->fractions({.first = 3, .order = 7});
    REQUIRE(fractions);
    CHECK(fractions->at(0, "n") == "3");
    CHECK(fractions->at(4, "x") == "17/315");
    const answer poles = x->singularities(2, proved_digits(12));
    REQUIRE(poles.rows.size() == 2);
    CHECK(poles.at(0, "rigour") == "proved");
    CHECK(poles.at(0, "modulus") == "1.57079632679");
    CHECK_FALSE(poles.missing);
    CHECK_THROWS_AS(x->radius("1/2", proved_digits(5)), error);
    CHECK_THROWS_AS(x->require_point("f(1)"), error);
}

// tan t, whose coefficients are 1, 1/3, 2/15, 17/315, and the pendulum, whose closed forms have no law of their own.
TEST_CASE("a solution has the law of its coefficients", "[problem][asymptotics]") {
    const auto law = solve(problem(tangent))->law({}, proved_digits(20));
    CHECK(law.name() == "x");
    CHECK(law.stride() == 2);
    REQUIRE(law.limit(20).decimal);
    CHECK(law.limit(20).decimal->text.starts_with("0.4052847345693510857"));  // 4/pi^2
    const auto at = law.coefficient(7, 15).value;
    REQUIRE(at.decimal);
    CHECK(at.decimal->text.starts_with("0.05396825396825"));
    const auto pendulum = solve(problem("th'' = -sin(th); th(0) = 0; th'(0) = sqrt(17/5)"));
    CHECK(pendulum->closed_form() == "the pendulum");
    CHECK(pendulum->law({.show = "th'"}, proved_digits(20)).stride() == 2);
    CHECK_THROWS_WITH(solve(problem("x' = -x(t-1); x(t <= 0) = 1"))->law({}, proved_digits(20)),
                      Catch::Contains("is piecewise or has delays"));
}

TEST_CASE("a value that is missing has its reason, and an empty text is a value", "[problem]") {
    const answer part{.names = {"time", "why"},
                      .rows = {{{"1", ""}, text_value("")}, {{"", ""}, text_value("")}, {}},
                      .rigour = "proved",
                      .missing = error(error_kind::undecided, error_subject::time, "", "is up")};
    CHECK(part.at(0, "time") == "1");
    CHECK(part.at(0, "why").empty());
    CHECK_THROWS_WITH(part.at(1, "time"), "time is up");
    CHECK(part.at(1, "why").empty());
    CHECK_THROWS_WITH(part.at(2, "why"), "time is up");
    CHECK_THROWS_WITH(part.at(3, "time"), "time is up");
}

TEST_CASE("a disc without a found singularity is not proved to be free", "[problem]") {
    const answer none = solve(problem(tangent))->singularities(1, proved_digits(10));
    CHECK(none.rows.empty());
    CHECK(none.rigour == "heuristic");
    REQUIRE(none.notes.size() == 2);
    CHECK(none.notes[0].text.ends_with("; 1 expansion point"));
    CHECK(none.notes[1].text == "none found within 1, which does not prove that there is none");
    const answer entire =
        solve(problem("x' = -x + y^2; y' = y; x(0) = 0; y(0) = 1"))->singularities(1, proved_digits(10));
    CHECK(entire.rigour == "proved");
    CHECK(entire.notes.size() == 1);
}

// x = -+sqrt(2) i/(t - t*) + ..., with logarithms from the fourth term on unless c = 0.
TEST_CASE("a pole with logarithms is called no pole, from its equation and from some lists", "[problem]") {
    const auto kind_of = [](const std::string& c, long order, const std::string& about) {
        const problem of("x'' = -c*x' - x - x^3; x(0) = 1; x'(0) = 0; c = " + c);
        return solve(of)->radius({.order = order, .about = about}, rounded_digits(40)).at(0, "kind");
    };
    for (const std::string about : {"", "1/4"}) {
        INFO(about);
        CHECK(kind_of("0", 40, about) == "pole");
        CHECK(kind_of("0.4", 40, about) != "pole");
    }
}

// The radius of the closed form against the tests of coefficients, which do not use it.
TEST_CASE("the radius of the pendulum is known without coefficients", "[problem]") {
    const auto theta = solve(problem("pendulum"));
    const answer tests = theta->radius({.order = 120, .about = "pi/4"}, rounded_digits(20));
    CHECK_FALSE(tests.at(0, "exact").empty());
    CHECK(std::stod(tests.at(0, "relative_error")) < 1e-8);
    const answer bounds = theta->radius("", proved_digits(15));
    const answer by_search = solve(problem("pendulum"), {.general = true})->radius("", proved_digits(6));
    CHECK(bounds.at(0, "lower").substr(0, 6) == by_search.at(0, "lower").substr(0, 6));
    CHECK(bounds.notes.size() == 2);
}

TEST_CASE("unknown parameters and orbits are found", "[problem]") {
    const answer speed = find_unknowns(problem("y'' = -y; y(0) = 0; y'(0) = 1"), {"y'(0)"}, {"y(pi/6) = 1"},
                                       {.scalar = {scalar_kind::proved, 20}, .check = true});
    CHECK(speed.at(0, "name") == "y'(0)");
    CHECK(speed.at(0, "value") == "2.0000000000000000000");
    CHECK(find_unknowns(problem("blasius"), {"k"}, {"f'(inf) = 1"}, proved_digits(20)).at(0, "value") ==
          "0.33205733621519629894");
    CHECK_THROWS_AS(find_unknowns(problem("blasius"), {"k"}, {}, proved_digits(5)), error);
    CHECK_THROWS_AS(find_unknowns(problem("blasius"), {"q"}, {"f'(5) = 1"}, proved_digits(5)), error);
    CHECK_THROWS_WITH(find_unknowns(problem("blasius"), {"k", "k"}, {"f'(5) = 1", "f(5) = 3"}, proved_digits(5)),
                      Catch::Contains("unknowns 'k' is given twice"));
    CHECK_THROWS_WITH(find_unknowns(problem("blasius"), {"k"}, {"f(5) = 3", "f'(inf) = 1"}, proved_digits(5)),
                      Catch::Contains("condition 'f(5) = 3' is given together with one at infinity"));
}

TEST_CASE("a solution gives what it reaches and says what it does not", "[problem]") {
    const auto both = solve(problem("y' = y^2; z' = 1 + z^2; y(0) = 1; z(0) = 0"));
    for (const request& how : {proved_digits(10), rounded_digits(10)}) {
        const answer states = both->states("0.5, 1.2, 2", how);
        CHECK(states.at(0, "y") == "2.000000000");
        CHECK(states.at(1, "z") == "2.572151622");
        CHECK_THROWS_AS(states.at(1, "y"), error);
        CHECK(states.rows[2].empty());
        CHECK(states.missing);
    }
}

TEST_CASE("a problem is a text, a name of the catalogue or equations, with changes", "[problem]") {
    CHECK(solve(problem("lotka_volterra"))->quantities() == std::vector<std::string>{"x", "y"});
    CHECK(solve(problem(tangent).set("x(0) = 1"))->states("0", proved_digits(5)).at(0, "x") == "1.0000");
    CHECK(solve(problem(ode::parse(tangent)))->states("pi/4", proved_digits(5)).at(0, "x") == "1.0000");
    CHECK_THROWS_AS(problem("no_such_problem"), error);
    CHECK_THROWS_AS(solve(problem("x' = x")), error);
}

TEST_CASE("the pendulum is recognised however it is written", "[problem]") {
    for (const char* text :
         {"x'' = -sin(x); x(0) = 2; x'(0) = 0", "x'' + 3*sin(x) = 0; x(1/2) = -100; x'(1/2) = -7",
          "2*q'' = -pi*sin(q); q(0) = pi/3; q'(0) = sqrt(2)", "y' = -sin(x)/7; x' = y; x(0) = 3; y(0) = 1e-10",
          "u' = v; v' = -k*sin(u); u(0) = 0; v(0) = 2; k = 1", "x'' = -sin(x); x(0) = 2*pi; x'(0) = 1e-200"}) {
        CAPTURE(text);
        const auto closed = solve(problem(text));
        const auto general = solve(problem(text), {.general = true});
        CHECK(closed->closed_form() == "the pendulum");
        CHECK(general->closed_form().empty());
        REQUIRE(closed->quantities() == general->quantities());
        const answer a = closed->states("-3/2, 5/2, 3", proved_digits(25));
        const answer b = general->states("-3/2, 5/2, 3", proved_digits(25));
        for (std::size_t row = 0; row < 3; ++row) {
            for (const std::string& name : closed->quantities()) {
                CHECK(a.at(row, name) == b.at(row, name));
            }
        }
        const answer by_lattice = closed->series(9, "", proved_digits(15));
        const answer by_equations = general->series(9, "", proved_digits(15));
        REQUIRE(by_lattice.names == by_equations.names);
        for (std::size_t n = 0; n < 10; ++n) {
            CHECK(by_lattice.at(n, by_lattice.names[1]) == by_equations.at(n, by_lattice.names[1]));
        }
    }
}

TEST_CASE("the points of a recognised pendulum are those of any equation", "[problem]") {
    const auto x = solve(problem("x'' = -sin(x); x(0) = 1; x'(0) = 0"));
    const auto third = [&](const std::string& about) { return x->series(3, about, proved_digits(15)).at(3, "x"); };
    for (const char* about : {"1+0i", "1 ", " 2/2"}) {
        CAPTURE(about);
        x->require_point(about);
        CHECK(third(about) == third("1"));
        CHECK(x->radius(about, proved_digits(8)).at(0, "lower") == x->radius("1", proved_digits(8)).at(0, "lower"));
    }
    CHECK(x->series(1, "1+2i", rounded_digits(5)).names.back() == "x_im");
    CHECK_THROWS_WITH(third("1+"), Catch::StartsWith("point '1+'"));
    CHECK_THROWS_WITH(x->radius("1+2i", proved_digits(5)), Catch::StartsWith("point '1+2i' is not real"));
}

// Energy is conserved; the progress callback ends the work after the second of four times.
TEST_CASE("the drift of an invariant is that of the finished states", "[problem]") {
    const auto x = solve(problem("x'' = -sin(x); x(0) = 1; x'(0) = 0; invariant x'^2/2 - cos(x)"));
    request how = rounded_digits(20);
    const answer all = x->states("0, 1, 2, 3", how);
    how.progress = [](double part) {
        if (part >= 0.5) {
            throw error(error_kind::undecided, error_subject::time, "", "is up");
        }
    };
    const answer two = x->states("0, 1, 2, 3", how);
    CHECK(two.at(1, "x") == all.at(1, "x"));
    CHECK_THROWS_WITH(two.at(2, "x"), "time is up");
    REQUIRE(two.drifts.size() == 4);
    CHECK(two.drifts[1] == all.drifts[1]);
    CHECK(std::stod(all.drifts[3]) < 1e-20);
    CHECK(two.drifts[2].empty());
}

TEST_CASE("what is not the pendulum is not taken for it", "[problem]") {
    for (const char* text : {"x'' = sin(x); x(0) = 2; x'(0) = 0", "x'' = -sin(2*x); x(0) = 2; x'(0) = 0",
                             "x'' = -sin(x) - x'; x(0) = 2; x'(0) = 0", "x'' = -t*sin(x); x(1) = 2; x'(1) = 0",
                             "x'' = -sin(x'); x(0) = 2; x'(0) = 0", "x' = y; y' = -sin(y); x(0) = 2; y(0) = 0",
                             "x' = 2*y; y' = -sin(x); x(0) = 2; y(0) = 0", "x'' = -cos(x); x(0) = 2; x'(0) = 0",
                             "x'' = -sin(x); y' = y; x(0) = 2; x'(0) = 0; y(0) = 1"}) {
        CAPTURE(text);
        CHECK_FALSE(recognise_pendulum(ode::parse(text)));
        CHECK(solve(problem(text))->closed_form().empty());
    }
}

// Far beyond what Taylor series reach in this time, and at the equilibria, which no precision shows.
TEST_CASE("the closed form answers where Taylor series cannot", "[problem]") {
    const auto top = solve(problem("x'' = -sin(x); x(0) = pi; x'(0) = 0"));
    CHECK(top->states("1e6", proved_digits(10)).at(0, "x'") == "0");
    const auto far = solve(problem("pendulum"));
    CHECK(far->states("1e12", proved_digits(30)).at(0, "theta") == "-1.28977566036974826206862501873");
    const auto constants = far->constants(proved_digits(10));
    REQUIRE(constants);
    CHECK(constants->names.front() == "energy");
}

// Released at a right angle, E = 1: T = 4 K(1/2), T* = K(1/2) and R = sqrt(2) T* about the top [paper (librationROC)];
// K(1/2) = Gamma(1/4)^2/(4 sqrt(pi)) = 1.85407467730137191843.... About the bottom R = K'(1/2) = T*.
TEST_CASE("constants of a motion are asked for by name and have bounds", "[problem]") {
    const auto swing = solution_of(pendulum::given_motion{.theta0 = "90deg", .omega0 = "0"});
    const auto found = swing->constants(proved_digits(12), {.names = {"tstar", "gap", "radius"}});
    REQUIRE(found);
    CHECK(found->names == std::vector<std::string>{"tstar", "gap", "radius"});
    CHECK(found->at(0, "tstar") == "1.85407467730");
    CHECK(std::stod(found->rows[0][0].bound) < 1e-11);
    CHECK(found->at(0, "gap") == "1");
    CHECK(found->rows[0][1].bound == "0");
    CHECK(found->at(0, "radius") == "2.62205755429");
    CHECK(swing->constants(proved_digits(12), {.names = {"radius"}, .about = "bottom"})->at(0, "radius") ==
          "1.85407467730");
    CHECK(swing->constants(proved_digits(8))->names.size() == 5);
    CHECK_THROWS_WITH(swing->constants(proved_digits(8), {.names = {"mass"}}), Catch::Contains("constant 'mass'"));
    CHECK_THROWS_WITH(solution_of(pendulum::given_motion{.energy = "2"})->states("T", proved_digits(8)),
                      Catch::Contains("multiple of an infinite period"));
}

TEST_CASE("a motion is sampled in double, and an equation is not", "[problem]") {
    const auto turn = solution_of(pendulum::given_motion{.energy = "3"});
    const auto sampler = turn->sampler();
    REQUIRE(sampler);
    const std::vector<double> times{0.75, -2};
    std::vector<double> theta(2);
    std::vector<double> omega(2);
    CHECK(sampler->reaches(times));
    sampler->at(times, std::vector<double*>{theta.data(), omega.data()});
    const answer exactly = turn->states("3/4, -2", proved_digits(20));
    for (std::size_t i = 0; i < 2; ++i) {
        // 4 units in the last place of |theta| < 8 and of the largest omega, sqrt(6) < 4 (pendulum/sampler.hpp).
        constexpr double unit = 4 * 4 * std::numeric_limits<double>::epsilon();
        CHECK(std::abs(theta[i] - std::stod(exactly.at(i, "theta"))) <= unit);
        CHECK(std::abs(omega[i] - std::stod(exactly.at(i, "omega"))) <= unit);
    }
    CHECK(solve(problem("x'' = -sin(x); x(0) = 1; x'(0) = 0"))->sampler() == nullptr);
}

}  // namespace problem_solution_test
