// What is known of problems beyond their text, asked by name and by equations.
#include "libration/problem/known_facts.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/error.hpp"

namespace problem_known_facts_test {

using namespace libration;

namespace {

ode::equation_system of_catalogue(const std::string& name) { return ode::parse(problem_text(name)); }

}  // namespace

TEST_CASE("facts are named by problems of the catalogue in order, and say something", "[problem]") {
    const auto& all = all_known_facts();
    CHECK(std::ranges::is_sorted(all, {}, &known_facts::problem));
    for (const known_facts& each : all) {
        INFO(each.problem);
        CHECK_NOTHROW(problem_text(each.problem));
        CHECK((each.condition || each.limits || each.far || each.closed_form));
        CHECK(known_facts_of(each.problem) == &each);
        CHECK(known_facts_of(of_catalogue(each.problem)) == &each);
    }
    CHECK(known_facts_of("lorenz") == nullptr);
    CHECK(known_facts_of(of_catalogue("lorenz")) == nullptr);
}

// OEIS A256522; S(inf) of Eyam is 76.0563587702 where it is cut off [PROBLEMS].
TEST_CASE("conditions and limits at infinity have the digits in print", "[problem][proved]") {
    const auto k = proved_for_infinity(of_catalogue("blasius"), {"k"}, "f'(inf) = 1", 18);
    CHECK(k.front().text == "0.332057336215196299");
    const auto left = *limits_by_lemma(ode::changed(of_catalogue("sir"), "S(0) = 254"), 12);
    REQUIRE(left.size() == 2);
    CHECK(left[0].text == "76.0563587703");
    CHECK(left[1].text == "0");
}

// tests/reference/hiemenz.py. f'' falls to 1e-67 before the two sides part, while f' tends to 1.
TEST_CASE("the shear of stagnation point flow has the digits of mpmath", "[problem][proved]") {
    const auto flow = ode::changed(of_catalogue("falkner_skan"), "b = 1; s = 1.23");
    CHECK(proved_for_infinity(flow, {"s"}, "f'(inf) = 1", 50).front().text ==
          "1.2325876568202810201739472989284030394576534278655");
}

TEST_CASE("what no lemma is about is refused", "[problem][proved]") {
    CHECK(is_at_infinity("u( -inf ) = 1"));
    CHECK_FALSE(is_at_infinity("f'(5) = 1"));
    const auto refused = [](const char* name, const char* unknown, const char* condition) {
        try {
            proved_for_infinity(of_catalogue(name), {unknown}, condition, 5);
        } catch (const error& problem) {
            return problem.subject() == "condition" ? std::optional(problem.kind()) : std::nullopt;
        }
        return std::optional<error_kind>();
    };
    CHECK(refused("blasius", "k", "f'(inf) = -1") == error_kind::argument);
    CHECK(refused("blasius", "q", "f'(inf) = 1") == error_kind::undecided);
    CHECK(refused("lorenz", "r", "x(inf) = 1") == error_kind::undecided);
    CHECK(!limits_by_lemma(of_catalogue("lorenz"), 5));
}

}  // namespace problem_known_facts_test
