#include "libration/digits/growing_precision.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <vector>

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/bounded_value.hpp"
#include "libration/scalar/decimal.hpp"

namespace digits_growing_precision_test {

using namespace libration;

namespace {

// (1 + 10^-lost) - 1 in the precision in force: a loss of so many digits by cancellation.
mpfr with_loss(int lost) {
    const mpfr small = sqrt(mpfr(2)) / pow(mpfr(10), lost);
    return ((mpfr(1) + small) - mpfr(1)) * pow(mpfr(10), lost);
}

constexpr const char* root = "1.4142135623730950488016887242096980785696718753769";  // sqrt(2) to 50 digits

}  // namespace

TEST_CASE("precisions grow as they are told and end", "[digits]") {
    const auto runs_of = [](const growing_digits& digits) {
        std::vector<long> seen;
        bool last = false;
        CHECK_THROWS_AS(with_growing_precision(digits, "nothing",
                                               [&](const precision_run& run) -> std::optional<int> {
                                                   CHECK_FALSE(last);
                                                   last = run.last;
                                                   CHECK(working_digits() == digits.wanted + run.more);
                                                   seen.push_back(run.more);
                                                   return std::nullopt;
                                               }),
                        error);
        CHECK(last);
        return seen;
    };
    CHECK(runs_of({50, 20, 170}) == std::vector<long>{20, 40, 80, 160});
    CHECK(runs_of({0, 41, 100, digit_growth::by_half}) == std::vector<long>{41, 61, 91});
    CHECK(runs_of({0, 30, 150, digit_growth::by_first}) == std::vector<long>{30, 60, 90, 120, 150});
    CHECK(runs_of({0, 1, 2, digit_growth::by_half}) == std::vector<long>{1, 2});
}

TEST_CASE("what no precision decides is undecided, by name", "[digits]") {
    try {
        with_growing_precision({0, 20, 40}, "the sign of x", [](const precision_run& /*run*/) -> std::optional<int> {
            throw precision_exhausted("x");
        });
        FAIL("an answer");
    } catch (const error& problem) {
        CHECK(problem.kind() == error_kind::undecided);
        CHECK(problem.subject() == "the sign of x");
        CHECK(problem.reason() == "is not decided by 40 digits");
    }
}

TEST_CASE("a computation that knows its digits asks for them", "[digits]") {
    std::vector<long> seen;
    const auto attempt = [&](long& digits) -> std::optional<long> {
        seen.push_back(working_digits());
        if (digits < 90) {
            digits = digits < 50 ? 90 : 0;  // asking for less still grows
            return std::nullopt;
        }
        return digits;
    };
    CHECK(with_asked_precision(30, 100, "it", attempt) == 90);
    CHECK(with_asked_precision(60, 100, "it", attempt) == 90);
    CHECK(std::vector<long>(seen.begin(), seen.begin() + 3) == std::vector<long>{30, 90, 60});
    CHECK_THROWS_AS(with_asked_precision(30, 80, "it", attempt), error);
}

TEST_CASE("two runs find every planted loss", "[digits]") {
    for (const int lost : {0, 10, 17, 19, 44, 100, 1000}) {
        INFO(lost);
        int runs = 0;
        const auto compute = [&](long guard) {
            ++runs;
            const precision_scope scope(50 + guard);
            return std::vector<mpfr>{with_loss(lost), mpfr(3)};
        };
        const auto values = agreed_values(50, compute);
        CHECK(to_decimal(values[0], 50) == root);
        CHECK(to_decimal(values[1], 2) == "3.0");
        CHECK((runs == 2) == (lost <= 17));
    }
}

TEST_CASE("a value that is exactly 0 ends", "[digits]") {
    // Rounding noise around 0, at every precision another one.
    const auto noise = [](long guard) {
        const precision_scope scope(50 + guard);
        return std::vector<mpfr>{mpfr(1) - epsilon<mpfr>() * static_cast<int>(guard) - mpfr(1), mpfr(2)};
    };
    CHECK_THROWS_AS(agreed_values(50, noise), error);
    int asked = 0;
    const auto values = agreed_values(50, noise, [&] {
        ++asked;
        return std::vector<bool>{true, false};
    });
    CHECK(asked == 1);
    CHECK(values[0] == 0);
    CHECK(values[1] == 2);
}

TEST_CASE("a bound of the error makes one run enough, and a loss that it does not foresee several", "[digits]") {
    for (const int lost : {0, 20, 500}) {
        for (const int foreseen : {0, 20, 500}) {
            INFO(lost << " of which " << foreseen);
            int runs = 0;
            const auto compute = [&] {
                ++runs;
                return bounded_value{with_loss(lost), epsilon<mpfr>() * 2 * pow(mpfr(10), lost)};
            };
            CHECK(to_decimal(value_within_bound(50, foreseen, compute), 50) == root);
            CHECK((runs == 1) == (foreseen >= lost));
        }
    }
    CHECK_THROWS_AS(value_within_bound(50, 0, [] { return bounded_value{mpfr(0), epsilon<mpfr>()}; }), error);
}

}  // namespace digits_growing_precision_test
