// Eigenvalues compared with closed forms, with zeros of Airy's function, and with the Rayleigh-Ritz method.
#include "libration/query/well/eigenvalues.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "proved.hpp"
#include "reference_table.hpp"

namespace query_well_test {

using namespace libration;
using namespace libration::ode;
using tests::within_a_unit;

namespace {

eigenvalues found(const std::string& text, long count, long digits, std::optional<double> near = {}) {
    const separated_text separated = with_limits_separated(text);
    eigenvalue_question question;
    question.system = changed(parse(separated.problem), "E = 1");
    question.energy = "E";
    question.count = count;
    question.near = near;
    question.digits = digits;
    for (const std::string& each : separated.limits) {
        question.limits.push_back(parse_limit(question.system, each));
    }
    return proved_eigenvalues(question);
}

eigenvalues on_line(const std::string& potential, long count, long digits) {
    return found("psi'' = (" + potential + " - E)*psi; psi(-inf) = 0; psi(inf) = 0", count, digits);
}

void require_values(const eigenvalues& all, const std::vector<rational>& exact, long digits) {
    const precision_scope scope(digits + 30);
    REQUIRE(all.values.size() == exact.size());
    for (std::size_t n = 0; n < exact.size(); ++n) {
        CHECK(all.values[n].index == static_cast<long>(n));
        REQUIRE(all.values[n].value.decimal);
        CHECK(within_a_unit(*all.values[n].value.decimal, from_rational<ball>(exact[n]), digits));
    }
}

std::string refusal(const std::string& text) {
    try {
        found(text, 1, 10);
    } catch (const error& problem) {
        return problem.what();
    }
    return "no refusal";
}

}  // namespace

// |x|: even eigenfunctions have the zeros of Ai' as -E, odd ones those of Ai [DLMF 9.9].
TEST_CASE("wells with functions of the sign of x", "[query][proved]") {
    const precision_scope scope(60);
    const auto linear = on_line("abs(x)", 3, 30);
    REQUIRE(linear.values.size() == 3);
    const std::vector<std::string> zeros{"1.018792971647471089017324783399743824",
                                         "2.338107410459767038489197252446735441",
                                         "3.248197582179836537875423770775843384"};
    for (std::size_t n = 0; n < zeros.size(); ++n) {
        CHECK(linear.values[n].index == static_cast<long>(n));
        CHECK(within_a_unit(*linear.values[n].value.decimal, ball(mpfr(zeros[n])), 30));
    }
    const auto mirrored = on_line("if(x > 0, 3*x, -3*x) + 0*x", 1, 20);  // E of |x| times 3^(2/3)
    CHECK(within_a_unit(*mirrored.values[0].value.decimal, ball(mpfr("2.119174779362881818207937523132437134")), 20));
    const auto turned = on_line("abs(-2*x)", 1, 20);  // times 2^(2/3)
    CHECK(within_a_unit(*turned.values[0].value.decimal, ball(mpfr("1.61723303493100362822802676223227861")), 20));
    // From a point on the smooth side abs(x) is x; from 0 with psi = 0 the zeros of Ai.
    const auto half = found("psi'' = (abs(x) - E)*psi; psi(0) = 0; psi(inf) = 0", 1, 20);
    CHECK(within_a_unit(*half.values[0].value.decimal, ball(mpfr(zeros[1])), 20));
    CHECK_THAT(refusal("psi'' = (abs(x) + x/2 - E)*psi; psi(-inf) = 0; psi(inf) = 0"), Catch::Contains("not even"));
    CHECK_THAT(refusal("psi'' = (abs(x-1) - E)*psi; psi(-inf) = 0; psi(inf) = 0"), Catch::Contains("abs(x-1)"));
    CHECK_THAT(refusal("psi'' = (abs(x) - E)*psi; psi(-1) = 0; psi(inf) = 0"), Catch::Contains("sign"));
}

TEST_CASE("eigenvalues on the line in closed form", "[ode][proved]") {
    require_values(on_line("x^2", 4, 40), {1, 3, 5, 7}, 40);
    require_values(on_line("(x-1/3)^2", 3, 30), {1, 3, 5}, 30);
    // Wide, narrow and far.
    require_values(on_line("x^2/10^12", 2, 20), {rational(1, 1000000), rational(3, 1000000)}, 20);
    require_values(on_line("10^12*x^2", 2, 20), {1000000, 3000000}, 20);
    require_values(on_line("(x-1000)^2", 2, 20), {1, 3}, 20);
    // -l (l + 1) sech^2: -(l - n)^2, and Morse's well: -(a - n - 1/2)^2 for exp(-2 x) - 2 a exp(-x).
    require_values(on_line("-6*sech(x)^2", 2, 40), {-4, -1}, 40);
    require_values(on_line("-3/4*sech(x)^2", 1, 20), {rational(-1, 4)}, 20);
    require_values(on_line("exp(-2*x) - 6*exp(-x)", 3, 30), {rational(-25, 4), rational(-9, 4), rational(-1, 4)}, 30);
    // psi = (1 + sqrt(2) x^2) exp(-x^4/4) has no zero: E_0 = -2 sqrt(2).
    const precision_scope scope(70);
    CHECK(within_a_unit(*on_line("x^6 - 7*x^2", 1, 40).values[0].value.decimal, -sqrt(ball(8)), 40));
    // psi'' = 2 (x^2/2 - E) psi.
    require_values(found("psi'' = (x^2 - 2*E)*psi; psi(-inf) = 0; psi(inf) = 0", 2, 20),
                   {rational(1, 2), rational(3, 2)}, 20);
}

TEST_CASE("eigenvalues on half-lines and intervals", "[ode][proved]") {
    require_values(found("psi'' = (2/x^2 + x^2 - E)*psi; psi(0) = 0; psi(inf) = 0", 3, 30), {5, 9, 13}, 30);
    require_values(found("psi'' = (-2/x - E)*psi; psi(0) = 0; psi(inf) = 0", 3, 30),
                   {-1, rational(-1, 4), rational(-1, 9)}, 30);
    require_values(found("psi'' = (x^2 - E)*psi; psi(0) = 0; psi(inf) = 0", 2, 30), {3, 7}, 30);
    require_values(found("psi'' = (x^2 - E)*psi; psi'(0) = 0; psi(-inf) = 0", 2, 30), {1, 5}, 30);
    // 1.39787564, 3.47508655: finite differences on two grids, extrapolated.
    const auto linear = found("psi'' = (x - 1/x - E)*psi; psi(0) = 0; psi(inf) = 0", 2, 8);
    CHECK(linear.values[0].value.decimal->text == "1.3978756");
    CHECK(linear.values[1].value.decimal->text == "3.4750865");
    const precision_scope scope(60);
    const auto airy = found("psi'' = (x - E)*psi; psi(0) = 0; psi(inf) = 0", 3, 30);
    for (long n = 0; n < 3; ++n) {
        fmpz_t which;
        fmpz_init_set_si(which, n + 1);
        ball zero;
        arb_hypgeom_airy_zero(zero.handle(), nullptr, nullptr, nullptr, which, ball::working_bits());
        fmpz_clear(which);
        CHECK(within_a_unit(*airy.values[static_cast<std::size_t>(n)].value.decimal, -zero, 30));
    }
    const auto interval = found("psi'' = -E*psi; psi(0) = 0; psi(1) = 0", 3, 30);
    const ball square = pi<ball>() * pi<ball>();
    for (long n = 0; n < 3; ++n) {
        CHECK(
            within_a_unit(*interval.values[static_cast<std::size_t>(n)].value.decimal, square * (n + 1) * (n + 1), 30));
    }
}

TEST_CASE("eigenvalues by the Rayleigh-Ritz method", "[ode][proved]") {
    std::string last;
    eigenvalues all;
    for (const auto& row : tests::reference_table("eigenvalues.csv")) {
        const std::string potential = row.at("potential");
        if (potential != last) {
            all = on_line(potential, 5, 30);
            last = potential;
        }
        const std::string text = row.at("value");
        const auto& value = all.values[static_cast<std::size_t>(std::stol(row.at("index")))].value;
        const precision_scope scope(60);
        mpfr expected;
        mpfr_set_str(handle(expected), text.c_str(), 10, MPFR_RNDN);
        const long digits = std::min(30L, static_cast<long>(text.size()) - 3);
        INFO(potential << " " << text << " " << value.decimal->text);
        CHECK(within_a_unit(*value.decimal, ball(expected), digits - 1));
    }
}

TEST_CASE("pairs that tunnelling separates are told apart", "[ode][proved]") {
    const precision_scope scope(60);
    const auto pair = on_line("(x^2-16)^2/4", 2, 50);
    mpfr even;
    mpfr odd;
    mpfr_set_str(handle(even), pair.values[0].value.decimal->text.c_str(), 10, MPFR_RNDN);
    mpfr_set_str(handle(odd), pair.values[1].value.decimal->text.c_str(), 10, MPFR_RNDN);
    CHECK(odd > even);
    CHECK(odd - even < mpfr("1e-15"));
    // The same well about x = 1, without a symmetry that is used.
    const auto moved = on_line("((x-1)^2-16)^2/4", 2, 30);
    CHECK(within_a_unit(*moved.values[1].value.decimal, ball(odd), 30));
    CHECK(within_a_unit(*moved.values[0].value.decimal, ball(even), 30));
}

TEST_CASE("the eigenvalue near a first guess, with its index", "[ode][proved]") {
    const std::string text = "psi'' = (x^4 - E)*psi; psi(0) = 1; psi'(0) = 0; psi(inf) = 0";
    CHECK(found(text, 1, 30, 1.06).values[0].value.decimal->text == "1.06036209048418289964704601669");
    CHECK(found(text, 1, 20, 8.).values[0].index == 1);
    CHECK(found(text, 1, 20, -3.).values[0].index == 0);
}

TEST_CASE("an eigenvalue 0, and one that does not exist", "[ode][proved]") {
    const auto all = on_line("x^2 - 1", 2, 20);
    CHECK(!all.values[0].value.decimal);
    CHECK(!all.values[0].value.bound.empty());
    CHECK(all.values[1].value.decimal->text == "2.0000000000000000000");
    const auto few = on_line("-2*sech(x)^2", 2, 20);
    CHECK(few.values.size() == 1);
    REQUIRE(few.missing);
    CHECK_THAT(few.missing->what(), Catch::Contains("continuous spectrum"));
}

TEST_CASE("wells that are refused, with the term", "[ode][proved]") {
    const std::string ends = "; psi(-inf) = 0; psi(inf) = 0";
    CHECK_THAT(refusal("psi'' = (exp(-x^2) - E)*psi" + ends), Catch::Contains("another argument than k*x"));
    CHECK_THAT(refusal("psi'' = (x^2*sech(x) - E)*psi" + ends), Catch::Contains("the variable x"));
    CHECK_THAT(refusal("psi'' = (sin(x) - E)*psi" + ends), Catch::Contains("other than exp"));
    CHECK_THAT(refusal("psi'' = (x^2 + E)*psi" + ends), Catch::Contains("another factor"));
    CHECK_THAT(refusal("psi'' = (x^2 - E*x)*psi" + ends), Catch::Contains("another factor"));
    CHECK_THAT(refusal("psi'' = (x^2 - E^2)*psi" + ends), Catch::Contains("'E'"));
    CHECK_THAT(refusal("psi'' = x*psi' + (x^2 - E)*psi" + ends), Catch::Contains("psi'"));
    CHECK_THAT(refusal("psi'' = (x^2 - E)*psi + psi^3" + ends), Catch::Contains("linear"));
    CHECK_THAT(refusal("psi'' = (-x^2 - E)*psi" + ends), Catch::Contains("tends to -infinity"));
    CHECK_THAT(refusal("psi'' = (x^3 - E)*psi" + ends), Catch::Contains("tends to -infinity"));
    CHECK_THAT(refusal("psi'' = (x^2 - 1/(5*x^2) - E)*psi; psi(0) = 0; psi(inf) = 0"), Catch::Contains("pole"));
    CHECK_THAT(refusal("psi'' = (x^2 + 1/(x-1) - E)*psi" + ends), Catch::Contains("singular point"));
    CHECK_THAT(refusal("psi'' = (x^2 - E)*psi; psi(inf) = 0"), Catch::Contains("of the two ends"));
    CHECK_THAT(refusal("psi'' = (x^2 - E)*psi; psi(0) = 1; psi(inf) = 0"), Catch::Contains("is one nonzero number"));
}

}  // namespace query_well_test
