// Maps of systems: every unknown has the singularities of its closed form, and no others.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "libration/equation/first_order_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/plane/proved_singularity.hpp"
#include "libration/plane/singularity_map.hpp"
#include "libration/scalar/constants.hpp"
#include "libration/scalar/decimal.hpp"

namespace plane_systems_test {

using namespace libration;
using namespace libration::ode;

namespace {

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

singularity_map map_within(const std::string& text, double within) {
    singularity_request request;
    request.within = within;
    return singularities_of(typed(text), request);
}

// Of the unknown with this index, which counts lower derivatives.
std::vector<found_singularity> of_unknown(const singularity_map& map, std::size_t unknown) {
    std::vector<found_singularity> found;
    std::ranges::copy_if(map.all, std::back_inserter(found),
                         [&](const found_singularity& each) { return each.unknown == unknown; });
    return found;
}

bool is_at(const found_singularity& each, const mpfr& re, const mpfr& im = 0) {
    const complex_number<mpfr> away{mpfr(each.offset.re - re), mpfr(each.offset.im - im)};
    return mpfr(modulus_of(away)) <= each.uncertainty;
}

// A problem in one unknown, denoted by `name`, and its singularities in closed form.
struct solved_problem {
    std::string text;
    std::vector<complex_number<mpfr>> places;
    double exponent = 0;
};

// Half of them corner cases: powers of two, numbers next to 1.
std::string drawn_number(std::mt19937& random) {
    const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    switch (pick(8)) {
        case 0: return "1";
        case 1: return "(2/3)";
        case 2: return std::to_string(1 << pick(3));
        case 3: return "(1 - 10^(-" + std::to_string(3 + pick(30)) + "))";
        default: return "(" + std::to_string(50 + pick(150)) + "/100)";
    }
}

mpfr value_of(const std::string& text) {
    return constant_value<mpfr>::of(explicit_system(parse("y' = y; y(0) = " + text)).starts()[0][0]);
}

solved_problem drawn_problem(const std::string& name, std::mt19937& random) {
    const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    const std::string typed_a = drawn_number(random);
    const std::string typed_b = drawn_number(random);
    const mpfr a = value_of(typed_a);
    const mpfr b = value_of(typed_b);
    const auto text = [&](const std::string& right) {
        return name + "' = " + right + "; " + name + "(0) = " + typed_b + "; ";
    };
    switch (pick(5)) {
        case 0: return {text(typed_a + "*" + name + "^2"), {complex_number<mpfr>(1 / (a * b))}, -1};
        case 1: {  // tan(a t + atan b)
            std::vector<complex_number<mpfr>> poles;
            for (int k = -4; k < 4; ++k) {
                poles.emplace_back(mpfr((pi<mpfr>() / 2 + k * pi<mpfr>() - atan(b)) / a));
            }
            return {text(typed_a + "*(1 + " + name + "^2)"), poles, -1};
        }
        case 2: return {text("-" + typed_a + "/(2*" + name + ")"), {complex_number<mpfr>(b * b / a)}, 0.5};
        case 3: return {text("-" + typed_a + "/(3*" + name + "^2)"), {complex_number<mpfr>(b * b * b / a)}, 1.0 / 3};
        default: {  // u'' = 6 a u^2, a u = 1/(b - t)^2
            const std::string starts = name + "(0) = 1/(" + typed_a + "*" + typed_b + "^2); " + name + "'(0) = 2/(" +
                                       typed_a + "*" + typed_b + "^3); ";
            return {name + "'' = 6*" + typed_a + "*" + name + "^2; " + starts, {complex_number<mpfr>(b)}, -2};
        }
    }
}

// Unknowns that depend on the problem `on` of one of these kinds: with its singularities, or without any.
struct tally {
    int rows = 0, covered = 0, missed = 0, doubled = 0, foreign = 0, exponents = 0;

    void judge(const std::vector<found_singularity>& found, const solved_problem& truth, double within) {
        std::vector<int> hits(truth.places.size(), 0);
        for (const auto& each : found) {
            std::size_t nearest = 0;
            mpfr least(1000);
            for (std::size_t k = 0; k < truth.places.size(); ++k) {
                const mpfr away = modulus_of(each.offset - truth.places[k]);
                if (away < least) {
                    least = away;
                    nearest = k;
                }
            }
            ++rows;
            foreign += least < mpfr("1e-6") ? 0 : 1;
            covered += least <= each.uncertainty ? 1 : 0;
            exponents += std::abs(each.exponent - truth.exponent) < 1e-9 ? 1 : 0;
            ++hits[nearest];
        }
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const bool is_inside = static_cast<double>(mpfr(modulus_of(truth.places[k]))) < 0.999 * within;
            missed += is_inside && hits[k] == 0 ? 1 : 0;
            doubled += hits[k] > 1 ? 1 : 0;
        }
    }
};

tally tallied(int systems, unsigned seed) {
    const precision_scope scope(60);
    std::mt19937 random(seed);
    tally all;
    const std::vector<std::string> names{"y", "z", "w"};
    for (int i = 0; i < systems; ++i) {
        std::vector<solved_problem> parts;
        std::string text;
        const std::size_t count = 2 + random() % 2;
        for (std::size_t k = 0; k < count; ++k) {
            // One in four is a copy of the first in another unknown: equal positions.
            std::mt19937 again = random;
            parts.push_back(drawn_problem(names[k], random));
            if (k + 1 < count && random() % 4 == 0) {
                parts.push_back(drawn_problem(names[++k], again));
            }
        }
        for (const auto& each : parts) {
            text += each.text;
        }
        const double within = 2.5;
        const auto map = map_within(text, within);
        const auto system = typed(text);
        std::size_t leaf = 0;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const tally before = all;
            all.judge(of_unknown(map, leaf), parts[k], within);
            INFO(text << " unknown " << names[k]);
            CHECK(all.missed == before.missed);
            CHECK(all.doubled == before.doubled);
            CHECK(all.foreign == before.foreign);
            leaf += static_cast<std::size_t>(system.unknowns()[k].order);
        }
    }
    return all;
}

}  // namespace

// 1/(1 - t) and tan t: the tangent is regular at 1, and 1/(1 - t) elsewhere.
TEST_CASE("unknowns that do not influence each other have maps of their own", "[ode][singularity][systems]") {
    const precision_scope scope(40);
    const auto map = map_within("y' = y^2; z' = 1 + z^2; y(0) = 1; z(0) = 0", 5);
    CHECK(map.complete);
    const auto y = of_unknown(map, 0);
    REQUIRE(y.size() == 1);
    CHECK(is_at(y[0], 1));
    const auto z = of_unknown(map, 1);
    REQUIRE(z.size() == 4);
    CHECK(is_at(z[0], pi<mpfr>() / 2));
    CHECK(is_at(z[3], -3 * pi<mpfr>() / 2));
    CHECK(map.all.size() == 5);

    const auto two = map_within("y' = y^2; z' = 2*z^2; y(0) = 1; z(0) = 1", 2);
    REQUIRE(two.all.size() == 2);
    CHECK((is_at(two.all[0], mpfr(1) / 2) && two.all[0].unknown == 1));
    CHECK((is_at(two.all[1], 1) && two.all[1].unknown == 0));

    const auto tangents = map_within("y' = 1 + y^2; z' = 1 + z^2; y(0) = 0; z(0) = 1", 4);
    CHECK(of_unknown(tangents, 0).size() == 2);
    REQUIRE(of_unknown(tangents, 1).size() == 3);
    CHECK(is_at(of_unknown(tangents, 1)[1], -3 * pi<mpfr>() / 4));

    const auto near = map_within("y' = y^2; z' = z^2; y(0) = 1; z(0) = 2/3", 3);
    REQUIRE(near.all.size() == 2);
    for (const auto& each : near.all) {
        CHECK(each.exponent == -1.0);
    }
    CHECK(map_within("x' = x^2; y' = y^2; z' = z^2; x(0) = 1; y(0) = 1/2; z(0) = 1/3", 4).all.size() == 3);
}

TEST_CASE("equal places, and places close together", "[ode][singularity][systems]") {
    const precision_scope scope(40);
    const auto equal = map_within("y' = y^2; z' = -1/(2*z); y(0) = 1; z(0) = 1", 2);
    REQUIRE(equal.all.size() == 2);
    CHECK(equal.all[0].unknown != equal.all[1].unknown);
    CHECK(of_unknown(equal, 0)[0].exponent == -1.0);
    CHECK(of_unknown(equal, 1)[0].exponent == 0.5);
    const auto close = map_within("y' = y^2; z' = z^2; y(0) = 1; z(0) = 1 - 10^(-9)", 2);
    REQUIRE(close.all.size() == 2);
    CHECK(is_at(of_unknown(close, 0)[0], 1));
    CHECK(is_at(of_unknown(close, 1)[0], 1 / (1 - mpfr("1e-9"))));
}

// p = y + z and q = y - z of poles at 1 and at 1/s: both are singular at both, in one component.
TEST_CASE("two poles of one unknown that are close together", "[ode][singularity][systems]") {
    const precision_scope scope(40);
    for (const char* const s : {"2", "2/3", "0.98", "0.999"}) {
        INFO(s);
        const std::string start(s);
        const auto map = map_within("p' = (p + q)^2/4 + (p - q)^2/4; q' = (p + q)^2/4 - (p - q)^2/4; p(0) = 1 + " +
                                        start + "; q(0) = 1 - " + start,
                                    2);
        const mpfr other = 1 / value_of(start);
        REQUIRE(map.all.size() == 2);
        const bool is_first = other < 1;
        CHECK(is_at(map.all[is_first ? 1 : 0], 1));
        CHECK(is_at(map.all[is_first ? 0 : 1], other));
        CHECK(map.all[0].exponent == -1.0);
        CHECK(map.all[1].exponent == -1.0);
    }
}

TEST_CASE("what an unknown depends on shows where it is singular itself", "[ode][singularity][systems]") {
    const precision_scope scope(40);
    // y = 1/(1 - t): z = 1/(1 - t); -log(1 - t); t - t^2/2, which is entire.
    const auto product = map_within("y' = y^2; z' = y*z; y(0) = 1; z(0) = 1", 3);
    REQUIRE(product.all.size() == 2);
    CHECK(of_unknown(product, 1)[0].kind == singularity_kind::pole);
    const auto logarithm = of_unknown(map_within("y' = y^2; z' = y; y(0) = 1; z(0) = 0", 3), 1);
    REQUIRE(logarithm.size() == 1);
    CHECK(logarithm[0].kind == singularity_kind::logarithm);
    CHECK(std::abs(logarithm[0].coefficient + 1.0) < 1e-6);
    const auto none = map_within("y' = y^2; z' = 1/y; y(0) = 1; z(0) = 0", 3);
    CHECK(of_unknown(none, 0).size() == 1);
    CHECK(of_unknown(none, 1).empty());
    // z = tan(t) + t y: the poles of the tangent and that of y.
    const auto both = map_within("y' = y^2; x' = 1 + x^2; z' = 1 + x^2 + y + t*y^2; y(0) = 1; x(0) = 0; z(0) = 0", 3);
    const auto z = of_unknown(both, 2);
    REQUIRE(z.size() == 3);
    CHECK(is_at(z[0], 1));
    CHECK(is_at(z[1], pi<mpfr>() / 2));
    CHECK(is_at(z[2], -pi<mpfr>() / 2));
    // z = 1/(1 - 2 (1 - e^-t)) has the poles log 2 + 2 pi i k; w = e^-t has none.
    const auto driven = map_within("w' = -w; z' = 2*w*z^2; w(0) = 1; z(0) = 1", 7);
    CHECK(of_unknown(driven, 0).empty());
    const auto poles = of_unknown(driven, 1);
    REQUIRE(poles.size() == 3);
    CHECK(is_at(poles[0], log(mpfr(2))));
    CHECK(is_at(poles[2], log(mpfr(2)), 2 * pi<mpfr>()));
}

// z = 1/(1 + log(1 - t)) has a pole at 1 - 1/e, and 1/log at 1, which is not a power.
TEST_CASE("an exponent that does not settle is not stated", "[ode][singularity][systems]") {
    const precision_scope scope(40);
    const auto z = of_unknown(map_within("y' = y^2; z' = y*z^2; y(0) = 1; z(0) = 1", 2), 1);
    REQUIRE(z.size() == 2);
    CHECK(is_at(z[0], 1 - exp(mpfr(-1))));
    CHECK(z[0].exponent == -1.0);
    CHECK(is_at(z[1], 1));
    CHECK(z[1].kind == singularity_kind::unclear);
}

// Linear in the unknown, with coefficients that are entire functions of the others.
TEST_CASE("chains of linear equations are entire", "[ode][singularity][systems]") {
    CHECK(has_entire_solutions(typed("y' = y; z' = y^2*z + sin(y); y(0) = 1; z(0) = 1")));
    CHECK_FALSE(has_entire_solutions(typed("y' = z; z' = y^2*z; y(0) = 1; z(0) = 1")));
    CHECK_FALSE(has_entire_solutions(typed("y' = y; z' = z/y; y(0) = 1; z(0) = 1")));
    const auto map = map_within("y' = y; x' = x^2; z' = y^2*z; y(0) = 1; z(0) = 1; x(0) = 1", 2);
    CHECK(map.all.size() == 1);
    CHECK(map_within("y' = y; z' = y^2*z; y(0) = 1; z(0) = 1", 2).entire);
}

// 1/(s - t) times a factor: s from 10^-100 to 10^100.
TEST_CASE("maps at any scale of time and unknowns", "[ode][singularity][systems]") {
    const precision_scope scope(40);
    for (const char* const scale : {"1e-100", "1e-10", "1e-4", "1e4", "1e10", "1e100"}) {
        INFO(scale);
        const std::string s(scale);
        const auto pole = singularities_of(typed("y' = y^2; y(0) = 1/" + s), {}).all;
        REQUIRE(pole.size() == 1);
        CHECK(is_at(pole[0], mpfr(scale)));
        CHECK(pole[0].exponent == -1.0);
        // 1/(s - t)^2
        const auto square = singularities_of(typed("u'' = 6*u^2; u(0) = 1/" + s + "^2; u'(0) = 2/" + s + "^3"), {}).all;
        REQUIRE(square.size() == 1);
        CHECK(is_at(square[0], mpfr(scale)));
        CHECK(square[0].exponent == -2.0);
        // a t with all its poles, and an unknown of another size.
        const auto tangent =
            singularities_of(typed("y' = " + s + "*(1 + (y/" + s + ")^2)*" + s + "; y(0) = 0"), {}).all;
        REQUIRE(tangent.size() == 2);
        CHECK(is_at(tangent[0], pi<mpfr>() / 2 / mpfr(scale)));
        CHECK(tangent[0].exponent == -1.0);
    }
}

// The evidence belongs to the unknown of the row: a regular unknown has none.
TEST_CASE("a proof is for the unknown of its row", "[ode][proved][singularity][systems]") {
    const precision_scope scope(40);
    // x' = 0, in a form in which y occurs.
    const auto system = typed(
        "y' = y^2; z' = 1 + z^2; x' = (y + 1)^2 - y^2 - 2*y - 1; w' = -w; y(0) = 1; z(0) = 0; x(0) = 0; w(0) = 1");
    singularity_request request;
    request.within = 2;
    request.digits = 20;
    const auto map = singularities_of(system, request);
    REQUIRE(map.all.size() == 3);
    for (const auto& each : map.all) {
        const auto proved = prove_singularity(system, each, mpfr("1e-15"));
        CHECK(proved.evidence.unknown == each.unknown);
        CHECK(proved.pole_order == 1);
    }
    for (const std::size_t regular : {std::size_t{2}, std::size_t{3}}) {
        auto of_another = map.all.front();
        of_another.unknown = regular;
        const auto refused = prove_singularities(system, {map.all.front(), of_another}, 3);
        CHECK(refused[0].refusal.empty());
        CHECK_THAT(refused[1].refusal, Catch::Contains("no change or integral"));
    }
}

TEST_CASE("the radius of a system is that of its nearest unknown", "[ode][proved][singularity][systems]") {
    const precision_scope scope(40);
    const auto radius = prove_radius(typed("y' = 1 + y^2; z' = 2*z^2; w' = -w; y(0) = 0; z(0) = 1; w(0) = 1"), 8);
    CHECK(certainly_less(radius.lower, ball(1) / 2));
    CHECK(certainly_less(ball(1) / 2, radius.upper));
    CHECK(radius.evidence->evidence.unknown == 1);
    CHECK(radius.systems == 2);
    // Each covering begins with a disc about the initial point.
    CHECK(std::ranges::count_if(radius.cover.discs, [](const auto& each) { return each.centre == 0.0; }) == 2);
    // 1/(s - t)
    for (const char* const scale : {"1e-100", "1e-4", "1e100"}) {
        const auto scaled = prove_radius(typed("y' = y^2; y(0) = 1/" + std::string(scale)), 8);
        const ball exact = ball(mpfr(scale));
        CHECK(certainly_less(scaled.lower, exact));
        CHECK(certainly_less(exact, scaled.upper));
    }
}

TEST_CASE("products of problems in closed form", "[ode][singularity][systems]") {
    const tally all = tallied(12, 1);
    CHECK(all.rows > 20);
    CHECK(all.covered == all.rows);
    CHECK(all.exponents == all.rows);
}

TEST_CASE("many products of problems in closed form", "[.long][singularity][systems]") {
    const tally all = tallied(400, 2);
    WARN(all.rows << " rows, " << all.covered << " covered, " << all.exponents << " exponents");
    CHECK(100 * all.covered >= 95 * all.rows);
    CHECK(100 * all.exponents >= 95 * all.rows);
}

}  // namespace plane_systems_test
