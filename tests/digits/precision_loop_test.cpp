#include "libration/digits/precision_loop.hpp"

#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "libration/digits/agreed_values.hpp"
#include "libration/digits/bounded_value.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/decimal.hpp"

namespace digits_precision_loop_test {

using namespace libration;

namespace {

// (1 + 10^-lost) - 1 in the precision in force: a loss of so many digits by cancellation.
mpfr with_loss(int lost) {
    const mpfr small = sqrt(mpfr(2)) / pow(mpfr(10), lost);
    return ((mpfr(1) + small) - mpfr(1)) * pow(mpfr(10), lost);
}

constexpr const char* root = "1.4142135623730950488016887242096980785696718753769";  // sqrt(2) to 50 digits

// Runs of a proof of 15 digits of a value, each with a step, whose enclosure has lost so many bits.
struct proved_runs {
    std::vector<long> bits = {};
    known_value value = {};
    std::optional<error> missing = {};
};

proved_runs runs_for(const ball& exactly, long lost, long steps = 1) {
    proved_runs made;
    made.missing = prove_digits(15, "number", [&](const run_bits& run, run_demand& demand) {
        const precision_scope scope(decimal_digits(run.bits));
        made.bits.push_back(run.bits);
        demand.improve(made.value, enclose(exactly, pow(ball(2), lost - run.bits)), "1", "x");
        demand.cost(steps);
    });
    return made;
}

constexpr long first = bits_of_first_run(15);

}  // namespace

TEST_CASE("a decimal digit has 3.32 bits", "[digits]") {
    CHECK(bits_of_digits(1000) >= 3322);
    CHECK(bits_of_digits(1000) < 3330);
    CHECK(first == bits_of_digits(15) + 64);
}

TEST_CASE("the next run has the bits that a value lacks", "[digits]") {
    CHECK(runs_for(ball(3) / 7, 50).bits == std::vector<long>{first});
    for (const long lost : {80L, 100L, 110L, 400L}) {
        INFO(lost);
        const auto made = runs_for(ball(3) / 7, lost);
        CHECK_FALSE(made.missing);
        CHECK(made.value.decimal->text == "0.428571428571429");
        CHECK(made.bits.size() <= 2 + static_cast<std::size_t>(lost) / 60);
        CHECK(made.bits.back() >= lost + 50);
        CHECK(made.bits.back() <= lost + lost / 16 + 130);
    }
    const auto exact_zero = prove_digits(15, "number", [](const run_bits&, run_demand& demand) {
        known_value zero;
        demand.improve(zero, ball(0), "", "x");
        CHECK(zero.decimal->text == "0");
    });
    CHECK_FALSE(exact_zero);
}

TEST_CASE("the largest demand of a run counts, and digits are kept", "[digits]") {
    std::vector<long> seen;
    std::vector<known_value> kept;
    const auto missing = prove_digits(15, "number", [&](const run_bits& run, run_demand& demand) {
        seen.push_back(run.bits);
        const bool is_first = seen.size() == 1;
        demand.improve(kept, {is_first ? ball(1) / 3 : ball(7), ball(1) / 7}, "", {"x", "y"});
        if (is_first) {
            demand.again();
            demand.more_bits(500, "a");
            demand.more_bits(300, "b");
            CHECK(demand.repeats());
        }
    });
    CHECK_FALSE(missing);
    CHECK(seen == std::vector<long>{first, 500});
    CHECK(kept[0].decimal->text == "0.333333333333333");
}

TEST_CASE("a value about 0 has three runs, and six if they are short", "[digits]") {
    const std::vector<long> all{first, 2 * first, 4 * first, 8 * first, 16 * first, 32 * first};
    const auto brief = runs_for(ball(0), 50, 0);
    CHECK(brief.bits == all);
    CHECK(brief.missing->value() == "1");
    CHECK(brief.missing->reason() == "has a value of x that " + std::to_string(32 * first) +
                                         " bits do not distinguish from 0: |x| < " + brief.value.bound);
    CHECK(runs_for(ball(0), 50, 1'000'000).bits == std::vector<long>(all.begin(), all.begin() + 3));
    // Steps times the square of the bits of the next run are at most 2^23.
    CHECK(runs_for(ball(0), 50, 100).bits == std::vector<long>(all.begin(), all.begin() + 3));
    CHECK(runs_for(ball(0), 50, 8).bits == std::vector<long>(all.begin(), all.begin() + 4));
}

// Runs for twenty values 2^(-60 k), and as many as given that contain 0 in each run, with these steps.
proved_runs runs_for_ever_smaller_values(int about_zero, long steps) {
    proved_runs made;
    std::vector<known_value> kept;
    made.missing = prove_digits(15, "time", [&](const run_bits& run, run_demand& demand) {
        const precision_scope scope(decimal_digits(run.bits));
        made.bits.push_back(run.bits);
        std::vector<ball> values(static_cast<std::size_t>(about_zero));
        for (long k = 1; k <= 20; ++k) {
            values.push_back(pow(ball(2), -60 * k));
        }
        for (ball& each : values) {
            each = enclose(each, pow(ball(2), -run.bits));
        }
        demand.improve(kept, values, "1", std::vector<std::string>(values.size(), "x"));
        demand.cost(steps);
    });
    return made;
}

TEST_CASE("the bits of values that are ever smaller are predicted", "[digits]") {
    // The first run distinguishes one from 0, the second one three.
    const auto predicted =
        static_cast<long>(2 * first + bits_of_digits(15) + 1.1 * static_cast<double>(first) * 17 / 2);
    const auto small = runs_for_ever_smaller_values(0, 1);
    CHECK_FALSE(small.missing);
    CHECK(small.bits == std::vector<long>{first, 2 * first, predicted});
    // Not if the run would be long, nor again for values that it does not distinguish from 0.
    CHECK(runs_for_ever_smaller_values(0, 1'000'000).bits[2] == 4 * first);
    const auto zeros = runs_for_ever_smaller_values(10, 1);
    CHECK(zeros.missing);
    CHECK(zeros.bits.size() == 3);
}

TEST_CASE("bits lost on a part of the way are extrapolated to all of it", "[digits]") {
    const auto second_run = [](double part) {
        std::vector<long> seen;
        const auto missing = prove_digits(15, "time", [&](const run_bits& run, run_demand& demand) {
            seen.push_back(run.bits);
            if (seen.size() == 1) {
                demand.ended_part_way(part, "2");
            }
        });
        CHECK_FALSE(missing);
        return seen.back();
    };
    CHECK(second_run(0.5) == static_cast<long>(2.1 * first) + first);
    CHECK(second_run(0.01) == 6 * first + first);
    CHECK(second_run(0) == 6 * first + first);
    CHECK(second_run(1) == static_cast<long>(1.05 * first) + first);
}

TEST_CASE("a question that bits may decide has a last precision", "[digits]") {
    std::vector<long> seen;
    const auto missing = prove_digits(15, "event", [&](const run_bits& run, run_demand& demand) {
        seen.push_back(run.bits);
        demand.undecided("3", "is open", 4 * first);
        demand.undecided("4", "is open, too", 4 * first);
    });
    CHECK(seen == std::vector<long>{first, 2 * first, 4 * first});
    CHECK(std::string(missing->what()) == "event '3' is open");
    CHECK(missing->kind() == error_kind::undecided);
}

TEST_CASE("error maps get bits of their own", "[digits]") {
    std::vector<long> of_errors;
    long last = 0;
    const auto missing = prove_digits(15, "time",
                                      [&](const run_bits& run, run_demand& demand) {
                                          of_errors.push_back(run.error_bits);
                                          last = run.bits;
                                          if (of_errors.size() < 3) {
                                              demand.more_error_bits("2");
                                          }
                                      },
                                      {.bits = 100, .error_bits = 40});
    CHECK_FALSE(missing);
    CHECK(of_errors == std::vector<long>{40, 80, 160});
    CHECK(last == 100 + 20 + 40);
}

TEST_CASE("a proof ends after a million bits, by what no run helps, and by errors", "[digits]") {
    const auto endless =
        prove_digits(15, "time", [](const run_bits& run, run_demand& demand) { demand.more_bits(10 * run.bits, "7"); });
    CHECK(std::string(endless->what()) == "time '7' is not proved by a million bits");
    int runs = 0;
    const auto ended = prove_digits(15, "time", [&](const run_bits&, run_demand& demand) {
        ++runs;
        known_value zero;
        demand.improve(zero, enclose(ball(0), ball(1)), "1", "x");
        demand.ended("8", "is not reached");
        demand.leave_zeros();
    });
    CHECK(runs == 1);
    CHECK(std::string(ended->what()) == "time '8' is not reached");
    const auto thrown = prove_digits(15, "time", [](const run_bits&, run_demand& demand) {
        demand.twice_the_bits("1");
        throw precision_exhausted("a sign");
    });
    CHECK(thrown->subject() == "a sign");
    CHECK_THROWS_WITH(prove_digits(15, "time",
                                   [](const run_bits&, run_demand&) {
                                       throw error(error_kind::argument, error_subject::time, "-1", "is negative");
                                   }),
                      "time '-1' is negative");
}

TEST_CASE("bits grow twofold or by half, up to the last", "[digits]") {
    std::vector<long> seen;
    const auto never = [&](long bits) -> std::optional<long> {
        seen.push_back(bits);
        return std::nullopt;
    };
    CHECK_FALSE(with_doubled_bits(30, 120, never));
    CHECK_FALSE(with_half_more_bits(20, 3, never));
    CHECK(seen == std::vector<long>{30, 60, 120, 20, 30, 45});
    CHECK(with_doubled_bits(30, 120, [](long bits) { return bits > 50 ? std::optional(bits) : std::nullopt; }) == 60);
}

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

}  // namespace digits_precision_loop_test
