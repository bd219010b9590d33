// From words to the parameters of a study.
#include "sweep/study_order.hpp"

#include "sweep/cell_engine.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/problem/known/pendulum.hpp"
#include "text/input_error.hpp"

namespace sweep_study_order_test {

using namespace libration;
using namespace libration::pendulum;
using Catch::Contains;

namespace {

// A study with every parameter there is.
const study& with_all() {
    static const study result{.name = "all",
                              .title = "All",
                              .label = "",
                              .question = "What is asked for?",
                              .reading = "Nothing.",
                              .of = &pendulum_problem(),
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
                              .excluded = no_answer_at_limits("it rests", "the period is infinite"),
                              .plan = {}};
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
                              .excluded = {},
                              .plan = {}};
    return result;
}

}  // namespace

TEST_CASE("what is not said has its usual value", "[sweep][study]") {
    const study_request usual = order_of(with_all(), {}, 3).request;
    const pendulum_sweep sweep(usual.values);
    REQUIRE(sweep.energies.size() == 3);
    CHECK(sweep.energies[0].energy == "0.5");  // by size, gaps among them
    CHECK(sweep.energies[2].gap == "1e-3");
    CHECK(usual.orders() == std::vector<int>{5, 10});
    REQUIRE(sweep.times.size() == 3);
    CHECK(sweep.times[1].text == "0.5T");
    REQUIRE(sweep.points.size() == 3);
    CHECK(sweep.points[1].coefficient == rational(1, 2));
    CHECK(usual.digits() == std::vector<int>{10, 20});
    CHECK(sweep.periods == std::vector<integer>{1, 1'000'000'000});
    REQUIRE(sweep.period_rules.size() == 2);
    CHECK(sweep.period_rules[0].rule.method == period_method::agm);
    CHECK(sweep.period_rules[1].rule.method == period_method::series);
    CHECK(sweep.period_rules[1].rule.order == 100);
    CHECK(sweep.period_rules[1].text == "series:100");
    CHECK(usual.step().coefficient == rational(1, 100'000));
    CHECK_FALSE(usual.scalar.has_value());  // what a study takes by itself
    CHECK(usual.jobs == 3);
}

TEST_CASE("what is said replaces it, and energies and gaps go together", "[sweep][study]") {
    const study_request said =
        order_of(with_all(), {{"--gaps", "-1e-30"}, {"--orders", "7"}, {"--scalar", "quad"}}, 1).request;
    const pendulum_sweep sweep(said.values);
    REQUIRE(sweep.energies.size() == 1);
    CHECK(sweep.energies[0].gap == "-1e-30");
    CHECK(said.orders() == std::vector<int>{7});
    CHECK(said.scalar->kind == scalar_kind::binary128);
    CHECK(said.digits().size() == 2);
}

TEST_CASE("the command of a study names what was said, in one order", "[sweep][study]") {
    CHECK(order_of(with_all(), {}, 1).command == "libration study all");
    CHECK(order_of(with_all(), {{"--orders", "7"}, {"--gaps", "-1e-30"}, {"--energies", "1"}}, 8).command ==
          "libration study all --energies 1 --gaps=-1e-30 --orders 7");
}

TEST_CASE("every list takes ranges, and those of whole numbers come out whole", "[sweep][study]") {
    const auto request = [](const study_words& words) { return order_of(with_all(), words, 1).request; };
    CHECK(request({{"--orders", "5:100:20"}}).orders().size() == 20);
    CHECK(request({{"--orders", "5:40:8,7"}}).orders() == std::vector<int>{5, 7, 10, 15, 20, 25, 30, 35, 40});
    CHECK(request({{"--digits", "10:30:3"}}).digits() == std::vector<int>{10, 20, 30});
    CHECK(pendulum_sweep(request({{"--periods", "1:1e6:4log"}}).values).periods ==
          std::vector<integer>{1, 100, 10'000, 1'000'000});
    CHECK(pendulum_sweep(request({{"--points", "0:1:3"}}).values).points[1].coefficient == rational(1, 2));
    CHECK_THROWS_WITH(request({{"--orders", "5:100:10"}}),
                      Contains("--orders '5:100:10'") && Contains("are not whole") && Contains("6 and 20"));
}

TEST_CASE("a range leaves out where there is no answer and says so, a typed value is refused", "[sweep][study]") {
    const study_order order = order_of(with_all(), {{"--energies", "1.5:2.5:11"}}, 1);
    CHECK(pendulum_sweep(order.request.values).energies.size() == 10);
    CHECK(order.left_out == "the energy 2 of --energies, where the period is infinite");
    CHECK(order.command == "libration study all --energies 1.5:2.5:11");
    CHECK(order_of(with_all(), {{"--gaps", "-1:1:3"}}, 1).left_out ==
          "the gap 0 of --gaps, where the period is infinite");
    CHECK(order_of(with_all(), {{"--energies", "1,1.5"}}, 1).left_out.empty());
    CHECK_THROWS_WITH(order_of(with_all(), {{"--energies", "1:3:2,2"}}, 1),
                      Contains("has the energy 2, where the period is infinite"));
    CHECK_THROWS_WITH(order_of(with_all(), {{"--gaps", "2"}}, 1), Contains("has the energy 0, where it rests"));
    CHECK_THROWS_AS(order_of(with_all(), {{"--energies", "2:2:2"}}, 1), input_error);  // nothing is left
}

TEST_CASE("the options of studies are the axes of their problems and their own", "[sweep][study]") {
    const auto options = options_of({&with_all(), &with_none()});
    std::vector<std::string> names;
    for (const study_option& each : options) {
        names.push_back(each.option);
    }
    CHECK(names == std::vector<std::string>{"--energies", "--gaps", "--times", "--points", "--periods", "--period-by",
                                            "--orders", "--digits", "--step", "--recurrence", "--lists", "--prove",
                                            "--seed", "--scalar"});
    CHECK(options.back().help == "double, long-double, quad or mpfr:DIGITS");
}

TEST_CASE("a column of what was typed that says nothing new is left out", "[sweep][study]") {
    study what = with_none();
    const auto in_one_cell = [](const table& data) {
        return [data](const study_request&) {
            return plan_of_cells(
                {{"", read_scalar("double"), table(data.columns())}}, {}, 1, [](std::size_t) { return cell_inputs(); },
                [data](std::size_t) { return std::vector<table>{data}; });
        };
    };
    what.plan = in_one_cell(table({{"a", ""}, {"a_typed", ""}, {"b", ""}, {"b_typed", ""}},
                                  {{"1", "1", "0.5", "1/2"}, {"2", "", "2", "2"}}));
    CHECK(to_csv(tables_of(order_of(what, {}, 1)).front().data) == "a,b,b_typed\n1,0.5,1/2\n2,2,2\n");
    // Decimals are exact in whatever was derived from them.
    what.plan = in_one_cell(table({{"a", ""}, {"b_typed", ""}, {"c_typed", ""}}, {{1, "1e-3", "1/3"}}));
    CHECK(to_csv(tables_of(order_of(what, {}, 1)).front().data) == "a,c_typed\n1,1/3\n");
}

TEST_CASE("a parameter that the study does not have is refused", "[sweep][study]") {
    CHECK_THROWS_WITH(order_of(with_none(), {{"--orders", "5"}}, 1),
                      Contains("--orders '5'") && Contains("study none") && Contains("leave it out"));
    CHECK(order_of(with_none(), {}, 1).request.orders().empty());
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
