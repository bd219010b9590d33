// Limits at stable equilibria, compared with closed forms; solutions that have none.
#include "libration/query/limit.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/manifold/stable_equilibrium.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/scalar.hpp"

namespace limit_at_equilibrium_test {

using namespace libration;

ode::partial_trajectory limit_of(const std::string& text, long digits) {
    return ode::limit_at_equilibrium(ode::explicit_system(ode::parse(text)), digits);
}

std::vector<std::string> decimals_of(const std::string& text, long digits) {
    const auto found = limit_of(text, digits);
    REQUIRE(!found.missing);
    std::vector<std::string> all;
    for (const auto& each : found.states.front()) {
        all.push_back(each.decimal.value().text);
    }
    return all;
}

std::string reason_of(const std::string& text) {
    try {
        limit_of(text, 10);
    } catch (const error& problem) {
        CHECK(problem.kind() == error_kind::undecided);
        return problem.what();
    }
    return {};
}

using Catch::Contains;

TEST_CASE("limits at equilibria are those of closed forms", "[ode][proved][limit]") {
    // 1/7 of the equation 7 y = 1.
    CHECK(decimals_of("y' = 1 - 7*y; y(0) = 3", 20) == std::vector<std::string>{"0.14285714285714285714"});
    // The fixed point of the cosine [OEIS A003957].
    CHECK(decimals_of("y' = cos(y) - y; y(0) = 3", 30) == std::vector<std::string>{"0.739085133215160641655312087674"});
    // A focus; the velocity is exactly 0 there.
    CHECK(decimals_of("x'' = 1 - x - x'/5; x(0) = 3; x'(0) = -1", 10) == std::vector<std::string>{"1.000000000", "0"});
    // Critical damping, without a second eigenvector; with a cubic spring, and with two such pairs that are coupled.
    CHECK(decimals_of("x'' = -x - 2*x' - x^3; x(0) = 5; x'(0) = 0", 10) == std::vector<std::string>{"0", "0"});
    CHECK(decimals_of("x'' = 1 - x - 2*x'; y'' = x - y - 2*y'; x(0) = 0; x'(0) = 0; y(0) = 0; y'(0) = 1", 10) ==
          std::vector<std::string>{"1.000000000", "0", "1.000000000", "0"});
    // (d/dt + 1)^3 y = 2.
    CHECK(decimals_of("y''' = 2 - y - 3*y' - 3*y''; y(0) = 1; y'(0) = 0; y''(0) = 0", 10) ==
          std::vector<std::string>{"2.000000000", "0", "0"});
    // Modes that are nearly parallel, far from normal: (0, 0) is approached through values near 50.
    CHECK(decimals_of("x' = 100*y - x; y' = -2*y; x(0) = 1; y(0) = 1", 10) == std::vector<std::string>{"0", "0"});
}

// a/b = 3/2 in equilibrium, a + b = 1.
TEST_CASE("conserved sums are eliminated", "[ode][proved][limit]") {
    CHECK(decimals_of("a' = 3*b - 2*a; b' = 2*a - 3*b; a(0) = 1; b(0) = 0", 12) ==
          std::vector<std::string>{"0.600000000000", "0.400000000000"});
    // A + B <-> C with a rate from the law of Arrhenius: A + C and B + C are conserved, k A B = C, k = e: with A(0) = 1,
    // B(0) = 2, C(0) = 0, C = x solves e (1 - x)(2 - x) = x.
    const auto found =
        decimals_of("A' = C - exp(1)*A*B; B' = C - exp(1)*A*B; C' = exp(1)*A*B - C; A(0) = 1; B(0) = 2; C(0) = 0", 25);
    const precision_scope scope(40);
    const mpfr e = exp(mpfr(1));
    const mpfr p = 3 + 1 / e;
    const mpfr x = (p - sqrt(mpfr(p * p - 8))) / 2;
    CHECK(abs(mpfr(mpfr(found[2]) - x)) <= pow(mpfr(10), -25));
    CHECK(abs(mpfr(mpfr(found[0]) - (1 - x))) <= pow(mpfr(10), -25));
}

// What an epidemic leaves: N - S = -g/b log(S/S(0)), N all of those at the beginning, by Lambert's W.
mpfr left_by_epidemic(const char* b, const char* g, long susceptible, long others) {
    const mpfr rate = mpfr(g) / mpfr(b);
    ball w(mpfr(-susceptible / rate * exp(mpfr(-(susceptible + others) / rate))));
    arb_lambertw(w.handle(), w.handle(), 0, ball::working_bits());
    return mpfr(-rate * midpoint_of(w));
}

TEST_CASE("epidemics end on the manifold of their logarithmic sum", "[ode][proved][limit]") {
    const auto left = [](const std::string& problem) { return decimals_of(std::string(problem_text(problem)), 20); };
    const auto check = [](const std::string& decimal, const mpfr& truth) {
        CHECK(abs(mpfr(mpfr(decimal) - truth)) <= truth * pow(mpfr(10), -19));
    };
    const precision_scope scope(40);
    const auto seir = left("seir");
    check(seir[0], left_by_epidemic("0.0178", "2.73", 254, 7));
    CHECK((seir[1] == "0" && seir[2] == "0"));
    const auto japan = left("sir_japan");
    check(japan[0], left_by_epidemic("2.9236e-5", "0.0164", 4206, 2));
    CHECK(japan[1] == "0");
    // In the other order of the unknowns, so that S is the first choice for elimination.
    const auto turned = decimals_of("I' = S*I/10 - I; S' = -S*I/10; I(0) = 1; S(0) = 20", 20);
    check(turned[1], left_by_epidemic("0.1", "1", 20, 1));
    CHECK(turned[0] == "0");
    // A negative unknown: S = log(-S), the omega constant.
    CHECK(decimals_of("S' = -S*I; I' = S*I - I; S(0) = -1; I(0) = 1", 20)[0] == "-0.56714329040978387300");
}

ode::reduced_field field_of(const std::string& text) {
    return ode::reduced_field(ode::explicit_system(ode::parse(text)));
}

// f_y has -1 on its diagonal everywhere, and 2 x and 2 y beside it: solutions from beyond the saddle at (1, 1) grow.
TEST_CASE("a neighborhood of a zero is bounded by its modes and by what couples them", "[ode][proved][limit]") {
    const auto f = field_of("x' = y^2 - x; y' = x^2 - y; x(0) = 0; y(0) = 0");
    const std::vector<ball> zero{ball(0), ball(0)};
    CHECK(ode::is_approached(f, zero, {ball(1) / 10, ball(1) / 10}));
    CHECK(!ode::is_approached(f, zero, {ball(2), ball(2)}));
}

TEST_CASE("a field without a zero has none that is enclosed", "[ode][proved][limit]") {
    const precision_scope scope(20);
    CHECK(ode::enclosed_zero(field_of("y' = y^2 - 2; y(0) = 1"), {ball(1)}));
    CHECK(!ode::enclosed_zero(field_of("y' = y^2 + 1e-30; y(0) = 1"), {ball(1)}));
}

TEST_CASE("an equilibrium of HIRES satisfies its equations", "[ode][proved][limit][.long]") {
    const ode::explicit_system system(ode::parse(std::string(problem_text("hires"))));
    const auto found = ode::limit_at_equilibrium(system, 40);
    REQUIRE(!found.missing);
    const precision_scope scope(60);
    std::vector<mpfr> y;
    for (const auto& each : found.states.front()) {
        y.emplace_back(each.decimal.value().text);
    }
    const mpfr unit = pow(mpfr(10), -37);
    CHECK(abs(mpfr(y[6] + y[7] - mpfr("0.0057"))) <= unit);
    CHECK(abs(mpfr(mpfr("1.71") * y[0] - mpfr("8.75") * y[1])) <= unit);
    CHECK(abs(mpfr(280 * y[5] * y[7] - mpfr("1.81") * y[6])) <= unit);
    CHECK(abs(mpfr(mpfr("-10.03") * y[2] + mpfr("0.43") * y[3] + mpfr("0.035") * y[4])) <= unit);
}

TEST_CASE("solutions without a stable equilibrium have the reason", "[ode][proved][limit]") {
    CHECK_THAT(reason_of("y' = t - y; y(0) = 1"), Contains("that contain the variable"));
    CHECK_THAT(reason_of("y' = 1 + y^2; y(0) = 0"), Contains("exist up to 1.570796326"));
    CHECK_THAT(reason_of("x'' = -x; x(0) = 1; x'(0) = 0"), Contains("no stable equilibrium") && !Contains("algebraic"));
    // An unstable equilibrium, which the solution approaches exponentially.
    CHECK_THAT(reason_of("x' = x; y' = x - y; x(0) = 0; y(0) = 1"),
               Contains("more than 20000 steps") && !Contains("nan") && !Contains("algebraic"));
}

// The solutions are 1/(1 + t), (1 + 2 t)^(-1/2) and log(1 + t), which has no limit though its slope decreases like 1/t.
TEST_CASE("approach of a limit like a power of the time is called algebraic", "[ode][proved][limit]") {
    CHECK_THAT(reason_of("y' = -y^2; y(0) = 1"), Contains("no stable equilibrium") && Contains("algebraic") &&
                                                     Contains("decrease like t^-1.00, algebraically"));
    CHECK_THAT(reason_of("x' = -x^3; x(0) = 1"), Contains("decrease like t^-0.50"));
    CHECK_THAT(reason_of("y' = exp(-y); y(0) = 0"), !Contains("algebraic"));
}

// y1 is nearly 1/(4.8e-4 t) [Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.1].
TEST_CASE("the decay of Robertson's reaction is algebraic", "[ode][proved][limit][.long]") {
    CHECK_THAT(reason_of(std::string(problem_text("robertson"))), Contains("decrease like t^-1.00, algebraically"));
}

}  // namespace limit_at_equilibrium_test
