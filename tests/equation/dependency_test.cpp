// The dependencies between unknowns: closed forms of graphs, and subsystems that solve the same equations.
#include "libration/equation/dependency.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/error.hpp"

namespace equation_dependency_test {

using namespace libration;
using namespace libration::ode;
using indices = std::vector<std::size_t>;
using partition = std::vector<indices>;

namespace {

explicit_system solved(const std::string& text) { return explicit_system(parse(text)); }

// y0' = y1, .., y(n-1)' = y0 or 0.
explicit_system chain(std::size_t n, bool closed) {
    equation_system given;
    std::vector<ode::expression> y;
    for (std::size_t i = 0; i < n; ++i) {
        y.push_back(unknown("y" + std::to_string(i)));
    }
    for (std::size_t i = 0; i < n; ++i) {
        given.add(derivative(y[i]), i + 1 < n ? y[i + 1] : closed ? y[0] : ode::expression(0));
        given.begin(y[i], 1);
    }
    return explicit_system(given);
}

}  // namespace

TEST_CASE("dependencies are those of the right sides", "[ode][dependency]") {
    const dependency_graph graph(
        solved("x' = y; y' = x; z'' = z' + x; w' = t*w; x(0) = 1; y(0) = 1; z(0) = 1; "
               "z'(0) = 1; w(0) = 1"));
    CHECK(graph.direct(0) == indices{1});
    CHECK(graph.direct(2) == indices{0, 2});
    CHECK(graph.strong_components() == partition{{0, 1}, {2}, {3}});
    CHECK(graph.weak_components() == partition{{0, 1, 2}, {3}});
    CHECK(graph.closure(0) == indices{0, 1});
    CHECK(graph.closure(2) == indices{0, 1, 2});
    CHECK(graph.closure(3) == indices{3});
    CHECK(graph.component_of(1) == indices{0, 1});
}

TEST_CASE("a component comes after those that it depends on", "[ode][dependency]") {
    // a needs b and c, both need d: d is the first, a the last.
    const dependency_graph diamond(
        solved("a' = b*c; b' = d; c' = d^2; d' = 1; a(0) = 1; b(0) = 1; c(0) = 1; d(0) = 1"));
    CHECK(diamond.strong_components().front() == indices{3});
    CHECK(diamond.strong_components().back() == indices{0});
    CHECK(diamond.weak_components() == partition{{0, 1, 2, 3}});
    // Implicit equations are treated as solved: x' = (2 t + x)/3, y' = (t - x)/3.
    const dependency_graph implicit(solved("x' + y' = t; x' - 2*y' = x; x(0) = 0; y(0) = 0"));
    CHECK(implicit.direct(0) == indices{0});
    CHECK(implicit.direct(1) == indices{0});
    CHECK(implicit.strong_components() == partition{{0}, {1}});
}

TEST_CASE("long chains and cycles of unknowns", "[ode][dependency]") {
    constexpr std::size_t n = 60;
    const dependency_graph open(chain(n, false));
    REQUIRE(open.strong_components().size() == n);
    CHECK(open.strong_components().front() == indices{n - 1});
    CHECK(open.closure(0).size() == n);
    CHECK(open.closure(n - 1) == indices{n - 1});
    const dependency_graph closed(chain(n, true));
    REQUIRE(closed.strong_components().size() == 1);
    CHECK(closed.strong_components().front().size() == n);
}

TEST_CASE("subsystems keep what belongs to them", "[ode][dependency]") {
    const auto whole = solved(
        "u' = v*u; v' = 1; x'' = -k*x; x(2) = 3; x'(2) = 4; u(2) = 5; v(2) = 6; k = 7; "
        "invariant x'^2 + k*x^2; invariant u + x; exact v = t + 4");
    const auto all = independent_subsystems(whole);
    REQUIRE(all.size() == 2);
    CHECK(all[0].unknowns == indices{0, 1});  // u, v
    CHECK(all[0].leaves == indices{0, 1});
    CHECK(whole.unknowns()[1].name == "v");
    CHECK(all[0].system.invariants().empty());
    REQUIRE(all[0].system.exact().size() == 1);
    CHECK(all[0].system.exact().front().name == "v");
    const auto& x = all[1];
    CHECK(x.unknowns == indices{2});
    CHECK(x.leaves == indices{2, 3});
    CHECK(x.leaves_of_whole == 4);
    CHECK(same_form(x.system.right()[0], whole.right()[2]));
    CHECK(x.system.point().plain()->coefficient == 2);
    REQUIRE(x.system.starts().front().size() == 2);
    CHECK(x.system.starts().front()[1].plain()->coefficient == 4);
    CHECK(x.system.invariants().size() == 1);
    CHECK(x.system.exact().empty());
    CHECK(subsystem_of(whole, {1}).system.unknowns().front().name == "v");
    CHECK_THROWS_AS(subsystem_of(whole, {0}), error);  // u needs v
    CHECK(independent_subsystems(solved("y' = y; y(0) = 1")).front().leaves == indices{0});
}

TEST_CASE("subsystems without starts", "[ode][dependency]") {
    const auto a = unknown("a");
    const auto b = unknown("b");
    const auto whole = explicit_system::first_order({a, b}, {a * a, b + 1}, number(rational(1)));
    const auto part = subsystem_of(whole, {1});
    CHECK(part.system.unknowns().front().name == "b");
    CHECK(part.system.starts().empty());
    CHECK(same_form(part.system.right()[0], b + 1));
    const auto coupled = explicit_system::first_order({a, b}, {a * b, b + 1}, number(rational(1)));
    CHECK_THROWS_AS(subsystem_of(coupled, {0}), error);
}

// Each unknown has the same coefficients, in fractions, in its closure as in the whole system, also about a singular
// initial point.
TEST_CASE("the series of a subsystem are those of the whole", "[ode][dependency]") {
    for (const auto& text :
         {"p' = p*q - s^2; q' = 1/(1 + q^2) + s; s' = -s; r'' = r'*t - p; x'' + 2*x'/(t + 1) = x^2; p(0) = 1/3; "
          "q(0) = 2; s(0) = 1/7; r(0) = 0; r'(0) = 1; x(0) = 1; x'(0) = 0",
          "t*y'' + 2*y' = -t*y^5; z' = z^2 + z*w; w' = y*w; y(0) = 1; y'(0) = 0; z(0) = 2; w(0) = 1/3"}) {
        const auto whole = solved(text);
        constexpr int order = 16;
        const tape tape_of_whole = tape::about_start(whole);
        taylor_expansion<rational> series(tape_of_whole, order);
        series.about_start();
        const dependency_graph graph(whole);
        for (std::size_t i = 0; i < graph.size(); ++i) {
            const auto part = subsystem_of(whole, graph.closure(i));
            const tape tape_of_part = tape::about_start(part.system);
            taylor_expansion<rational> of_part(tape_of_part, order);
            of_part.about_start();
            for (std::size_t k = 0; k < part.unknowns.size(); ++k) {
                for (int n = 0; n <= order; ++n) {
                    CHECK(of_part.coefficients(static_cast<int>(k))[n] ==
                          series.coefficients(static_cast<int>(part.unknowns[k]))[n]);
                }
            }
        }
    }
}

// Powers of the square root of t occur in y alone.
TEST_CASE("a subsystem has its own singular start", "[ode][dependency]") {
    const auto whole = solved("sqrt(t)*y'' = y^(3/2); z' = z^2; y(0) = 1; y'(0) = -1; z(0) = 1");
    CHECK(tape::about_start(whole).root() == 2);
    CHECK(tape::about_start(subsystem_of(whole, {0}).system).root() == 2);
    CHECK_FALSE(subsystem_of(whole, {1}).system.singular());
}

}  // namespace equation_dependency_test
