// Expressions of any depth, and expressions with shared parts: no traversal recurses, and none visits a part twice.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/equation/parametric_system.hpp"
#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/expansion/taylor_expansion.hpp"
#include "libration/scalar/error.hpp"

namespace equation_deep_expressions_test {

using namespace libration;
using namespace libration::ode;
using libration::ode::expression;

namespace {

constexpr int deep = 30'000;  // recursion overflows a stack of 8 MB
constexpr int levels = 60;    // 2^60 visits would never end

enum class kind { left_sum, right_sum, product, quotients, functions, differences };

// One expression in y and t, nested `depth` deep. At y = t = 1 quotients are 1, and the derivatives d(n) by y of
// quotients and differences are 1 - d(n - 1), d(1) = 0.
expression nested(kind of, int depth) {
    const expression y = unknown("y");
    expression e = of == kind::quotients || of == kind::differences ? variable() : y;
    for (int i = 1; i < depth; ++i) {
        switch (of) {
            case kind::left_sum: e = e + y; break;
            case kind::right_sum: e = y + e; break;
            case kind::product: e = y * e; break;
            case kind::quotients: e = y / e; break;
            case kind::functions: e = sin(e); break;
            case kind::differences: e = y - e; break;
        }
    }
    return e;
}

// y' = e from y(0) = 1.
equation_system problem_of(const expression& e) {
    equation_system made;
    made.add(derivative(unknown("y")), e);
    made.begin(unknown("y"), 1);
    return made;
}

double value_at_one(const expression& e) {
    expression_values<double> values({unknown("y")}, 1.0);
    values.push_back(1);
    return values.of(e);
}

// 2^60 times y, of 61 nodes.
expression doubled(expression e) {
    for (int i = 0; i < levels; ++i) {
        e = e + e;
    }
    return e;
}

std::string chain_of(const std::string& operation, const std::string& last) {
    std::string text = "y' = k0*y; y(0) = 1; k" + std::to_string(levels) + " = " + last;
    for (int i = 0; i < levels; ++i) {
        const std::string next = "k" + std::to_string(i + 1);
        text += "; k" + std::to_string(i) + " = " + next + operation + next;
    }
    return text;
}

std::string refusal_of(const std::string& text) {
    try {
        const explicit_system solved(parse(text));
        static_cast<void>(constant_value<mpfr>::of(partial(solved.right().front(), unknown("y")).constant()));
        return "nothing is wrong";
    } catch (const error& problem) {
        return problem.what();
    }
}

}  // namespace

TEST_CASE("expressions of any depth are made, compared, replaced, differentiated and destroyed", "[ode][deep]") {
    const auto [of, slope] = GENERATE(Catch::Generators::table<kind, double>({{kind::left_sum, deep},
                                                                              {kind::right_sum, deep},
                                                                              {kind::product, deep},
                                                                              {kind::quotients, 1},
                                                                              {kind::differences, 1}}));
    const expression e = nested(of, deep);
    const expression again = nested(of, deep);
    CHECK(e.hash() == again.hash());
    CHECK(same_form(e, again));
    CHECK_FALSE(same_form(e, nested(of, deep + 1)));
    const expression in_z = replaced(e, [](const expression& leaf) {
        return leaf.kind() == node_kind::unknown ? std::optional(unknown("z")) : std::nullopt;
    });
    int leaves = 0;
    each_leaf(in_z, [&](const expression& leaf) { leaves += leaf.name() == "z" ? 1 : 0; });
    CHECK(leaves == 1);
    CHECK(value_at_one(partial(e, unknown("y"))) == slope);
}

TEST_CASE("a system with deep right sides is solved, lifted and expanded", "[ode][deep]") {
    const kind of = GENERATE(kind::left_sum, kind::right_sum, kind::product);
    const explicit_system system(problem_of(nested(of, deep)));
    CHECK(has_entire_solutions(system) == (of != kind::product));
    CHECK(first_order_form(system).slopes.size() == 1);
    CHECK(lifted(system).added.empty());
    const tape made = tape::about_start(system);
    taylor_expansion<rational> series(made, 3);
    series.about_start();
    const rational* const y = series.coefficients(0);
    // y' = n y: n^k/k!; y' = y^n: y'' = n y^(2n - 1), y''' = n (2n - 1) y^(3n - 2).
    const rational n = deep;
    CHECK(y[1] == (of == kind::product ? rational(1) : n));
    CHECK(y[2] == (of == kind::product ? rational(n / 2) : rational(n * n / 2)));
    CHECK(y[3] == (of == kind::product ? rational(n * (2 * n - 1) / 6) : rational(n * n * n / 6)));
}

TEST_CASE("functions nested as deep are expanded", "[ode][deep]") {
    equation_system made = problem_of(nested(kind::functions, deep));
    made.starts.front().value = 0;
    const explicit_system system(made);
    const tape of_start = tape::about_start(system);
    taylor_expansion<double> series(of_start, 1);
    series.about_start();
    CHECK(series.coefficients(0)[1] == 0);  // sin 0 = 0
}

TEST_CASE("a highest derivative comes out of deep equations", "[ode][deep]") {
    const expression slope = unknown("y", 1);
    expression left = slope;
    for (int i = 1; i < deep; ++i) {
        left = left + slope;
    }
    equation_system made;
    made.add(left, unknown("y"));
    made.begin(unknown("y"), 1);
    const explicit_system system(made);
    CHECK(partial(system.right().front(), unknown("y")).fraction() == rational(1, deep));
}

TEST_CASE("shared parts are visited once", "[ode][deep]") {
    const expression e = doubled(unknown("y"));
    CHECK(same_form(e, doubled(unknown("y"))));
    CHECK(value_at_one(e) == std::ldexp(1.0, levels));
    CHECK(value_at_one(partial(e, unknown("y"))) == std::ldexp(1.0, levels));
    const explicit_system system(problem_of(e));
    CHECK(tape::about_points(system).steps().size() == levels + 1);
    CHECK(has_entire_solutions(system));
    CHECK(lifted(system).leaves.size() == 1);
    equation_system singular = problem_of(doubled(unknown("y") / variable()));
    singular.starts.front().value = 0;
    CHECK(explicit_system(singular).singular().has_value());
}

TEST_CASE("parameters that share others are evaluated once", "[ode][deep]") {
    const explicit_system system(parse(chain_of("+", "1")));
    CHECK(partial(system.right().front(), unknown("y")).fraction() == rational(integer(1) << levels));
    const explicit_system irrational(parse(chain_of("+", "pi")));
    const auto of_pi = partial(irrational.right().front(), unknown("y")).constant().plain();
    CHECK((of_pi && of_pi->coefficient == rational(integer(1) << levels) && of_pi->measure == unit::pi));
    CHECK(refusal_of(chain_of("*", "2")).find("is beyond the range 1e-100000 .. 1e100000") != std::string::npos);
    CHECK(refusal_of(chain_of("*", "pi")).find("is beyond the range of numbers") != std::string::npos);
    // (1 + 1e-30)^(2^60) = exp(2^60 1e-30 (1 + O(1e-30))), with 2^60 < 1.16e18.
    const explicit_system near_one(parse(chain_of("*", "1 + sqrt(2)*1e-30")));
    const precision_scope scope(40);
    const auto k = constant_value<mpfr>::of(partial(near_one.right().front(), unknown("y")).constant());
    const mpfr exponent = ldexp(mpfr(1), levels) * sqrt(mpfr(2)) / mpfr("1e30");
    CHECK(abs(mpfr(k - exp(exponent))) < mpfr("1e-40") * ldexp(mpfr(1), levels));
}

TEST_CASE("a long chain of parameters has values, a long circle has none", "[ode][deep]") {
    constexpr int names = 10'000;
    std::string text = "y' = k0*y; y(0) = 1";
    for (int i = 0; i < names; ++i) {
        text += "; k" + std::to_string(i) + " = 1 + k" + std::to_string(i + 1);
    }
    const std::string last = "; k" + std::to_string(names) + " = ";
    const equation_system given = parse(text + last + "0");
    const explicit_system system(given);
    CHECK(partial(system.right().front(), unknown("y")).fraction() == rational(names));
    const parametric_system open = opened(given, {"k" + std::to_string(names)});
    CHECK(open.values.front().fraction() == rational(0));
    const std::string told = refusal_of(text + last + "k0");
    CHECK(told.find("needs itself: k0 -> k1 -> ") != std::string::npos);
    CHECK(told.ends_with(" -> ... -> k0: give one of them a number"));
}

TEST_CASE("a derivative by a parameter in an exponent is one", "[ode]") {
    const expression k = parameter("k");
    CHECK(same_form(partial(pow(2, k), k), log(expression(2)) * pow(2, k)));
    CHECK_THROWS_AS(parse_complex_constant("2^i"), error);
}

}  // namespace equation_deep_expressions_test
