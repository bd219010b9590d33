// From words to the parameters of a study.
#include "sweep/study_order.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "text/input_error.hpp"

namespace sweep_study_order_test {

using namespace libration;
using Catch::Contains;

namespace {

// A study with every parameter there is.
const study& with_all() {
    static const study result{.name = "all",
                              .title = "All",
                              .label = "",
                              .question = "What is asked for?",
                              .reading = "Nothing.",
                              .parameters = {{"--energies", "1,0.5", "E"},
                                             {"--gaps", "1e-3", "2 - E"},
                                             {"--orders", "5,10", "N"},
                                             {"--times", "0:T:3", "t"},
                                             {"--points", "0,1/2,1", "of T*"},
                                             {"--digits", "10,20", "D"},
                                             {"--periods", "1,1e9", "periods"},
                                             {"--period-by", "agm,series:100", "ways to T*"},
                                             {"--step", "1e-5", "dt"},
                                             {"--scalar", "mpfr:50, and double", "arithmetic"}},
                              .quick = {},
                              .seconds = 1,
                              .run = {}};
    return result;
}

const study& with_none() {
    static const study result{.name = "none",
                              .title = "None",
                              .label = "",
                              .question = "?",
                              .reading = ".",
                              .parameters = {},
                              .quick = {},
                              .seconds = 1,
                              .run = {}};
    return result;
}

}  // namespace

TEST_CASE("what is not said has its usual value", "[sweep][study]") {
    const study_request usual = order_of(with_all(), {}, 3).request;
    REQUIRE(usual.energies.size() == 3);
    CHECK(usual.energies[0].energy == "0.5");  // by size, gaps among them
    CHECK(usual.energies[2].gap == "1e-3");
    CHECK(usual.orders == std::vector<int>{5, 10});
    REQUIRE(usual.times.size() == 3);
    CHECK(usual.times[1].text == "0.5T");
    REQUIRE(usual.points.size() == 3);
    CHECK(usual.points[1].coefficient == rational(1, 2));
    CHECK(usual.digits == std::vector<int>{10, 20});
    CHECK(usual.periods == std::vector<integer>{1, 1'000'000'000});
    REQUIRE(usual.period_rules.size() == 2);
    CHECK(usual.period_rules[0].rule.method == period_method::agm);
    CHECK(usual.period_rules[1].rule.method == period_method::series);
    CHECK(usual.period_rules[1].rule.order == 100);
    CHECK(usual.period_rules[1].text == "series:100");
    CHECK(usual.step.coefficient == rational(1, 100'000));
    CHECK_FALSE(usual.scalar.has_value());  // what a study takes by itself
    CHECK(usual.jobs == 3);
}

TEST_CASE("what is said replaces it, and energies and gaps go together", "[sweep][study]") {
    const study_request said =
        order_of(with_all(), {{"--gaps", "-1e-30"}, {"--orders", "7"}, {"--scalar", "quad"}}, 1).request;
    REQUIRE(said.energies.size() == 1);
    CHECK(said.energies[0].gap == "-1e-30");
    CHECK(said.orders == std::vector<int>{7});
    CHECK(said.scalar->kind == scalar_kind::binary128);
    CHECK(said.digits.size() == 2);
}

TEST_CASE("the command of a study names what was said, in one order", "[sweep][study]") {
    CHECK(order_of(with_all(), {}, 1).command == "libration study all");
    CHECK(order_of(with_all(), {{"--orders", "7"}, {"--gaps", "-1e-30"}, {"--energies", "1"}}, 8).command ==
          "libration study all --energies 1 --gaps=-1e-30 --orders 7");
}

TEST_CASE("a parameter that the study does not have is refused", "[sweep][study]") {
    CHECK_THROWS_WITH(order_of(with_none(), {{"--orders", "5"}}, 1),
                      Contains("--orders '5'") && Contains("study none") && Contains("leave it out"));
    CHECK(order_of(with_none(), {}, 1).request.energies.empty());
}

TEST_CASE("words that mean nothing are refused with option, value and remedy", "[sweep][study]") {
    const auto refused = [](const std::string& option, const std::string& words) {
        INFO(option << " " << words);
        CHECK_THROWS_WITH(order_of(with_all(), {{option, words}}, 1),
                          Contains(option + " '" + words + "'") && Contains(": write "));
        CHECK_THROWS_AS(order_of(with_all(), {{option, words}}, 1), input_error);
    };
    refused("--energies", "pi");
    refused("--gaps", "3");
    refused("--orders", "-1");
    refused("--times", "90deg");
    refused("--times", "");
    refused("--points", "1.5");
    refused("--points", "T/4");
    refused("--digits", "0");
    refused("--digits", "99999");
    refused("--periods", "1.5");
    refused("--periods", "-1");
    refused("--period-by", "series");
    refused("--period-by", "agm,");
    refused("--period-by", "agm:5");
    refused("--period-by", "resummed:x");
    refused("--step", "0");
    refused("--step", "T/4");
    refused("--scalar", "float");
}

}  // namespace sweep_study_order_test
