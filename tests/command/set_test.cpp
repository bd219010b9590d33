// Sets of initial values and parameters, and spans of time, on the command line.
#include <catch2/catch.hpp>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_set_test {

using namespace libration;
using namespace libration::tests;

namespace {

// The output, with the parts and steps on stderr.
std::string bounds_by(const words& line) {
    const auto done = run_libration(line);
    INFO(command_line(line) << "\n" << done.err);
    CHECK(done.exit_code == 0);
    CHECK_THAT(done.err, Catch::Contains(" enclosed in "));
    return done.out;
}

std::vector<table_row> rows_by(words line) {
    line.insert(line.end(), {"--format", "csv"});
    return csv_rows(bounds_by(line));
}

}  // namespace

TEST_CASE("reference prints bounds of all solutions of a set, rounded outwards", "[command][sets]") {
    const auto rows =
        rows_by({"reference", "--problem", "x' = -x; y' = y; x(0) = [0.9, 1.1]; y(0) = 1 +- 0", "--times", "1,1/3"});
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].at("time") == "1");
    CHECK(rows[0].at("unknown") == "x");
    CHECK(rows[0].at("rigour") == "proved");
    CHECK(rows[2].at("time_typed") == "1/3");
    const precision_scope scope(100);
    const mpfr lower = mpfr("0.9") * exp(mpfr(-1));
    const mpfr upper = mpfr("1.1") * exp(mpfr(-1));
    CHECK(number_of(rows[0].at("lower")) <= lower);
    CHECK(number_of(rows[0].at("upper")) >= upper);
    // A thousandth of the width.
    CHECK(number_of(rows[0].at("lower")) > lower - (upper - lower) / 1000);
    CHECK(number_of(rows[0].at("upper")) < upper + (upper - lower) / 1000);
    CHECK(number_of(rows[1].at("lower")) < exp(mpfr(1)));
    CHECK(number_of(rows[1].at("upper")) > exp(mpfr(1)));
    // A single number in the digits of --digits, which the bounds differ in.
    const auto one = rows_by({"reference", "--problem", "x' = x; x(0) = [1, 1]", "--time", "1", "--digits", "30"});
    CHECK(significant_digits(one[0].at("lower")) == 30);
    CHECK(number_of(one[0].at("lower")) < exp(mpfr(1)));
    CHECK(number_of(one[0].at("upper")) > exp(mpfr(1)));
    CHECK(number_of(one[0].at("upper")) - number_of(one[0].at("lower")) <= 2 * last_place(one[0].at("lower")));
}

// e^(-bt) is 1/a at ln(a)/b.
TEST_CASE("reference --until prints bounds of the events of all solutions", "[command][sets]") {
    const std::string set = "x' = -b*x; x(0) = 1; b = [1, 3]; a = [2, 4]";
    const words line{"reference", "--problem", set, "--until", "x = 1/a"};
    const auto rows = rows_by(line);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("event") == "1");
    CHECK(rows[0].at("quantity") == "time");
    CHECK(rows[0].at("rigour") == "proved");
    const precision_scope scope(100);
    const mpfr lower = log(mpfr(2)) / 3;
    const mpfr upper = log(mpfr(4));
    CHECK(number_of(rows[0].at("lower")) <= lower);
    CHECK(number_of(rows[0].at("upper")) >= upper);
    // Within a sixteenth of the range, as the parts of the set are.
    CHECK(number_of(rows[0].at("lower")) > lower - (upper - lower) / 16);
    CHECK(number_of(rows[0].at("upper")) < upper + (upper - lower) / 16);
    CHECK(rows[1].at("quantity") == "x");
    CHECK_THAT(bounds_by(line), Catch::StartsWith("event  1\ntime   in [0.23"));
    // What the condition determines is a number.
    CHECK_THAT(bounds_by({"reference", "--problem", set, "--until", "x = 1/2"}),
               Catch::EndsWith("x      in [0.5, 0.5]\n"));
    // Some solutions reach 1/3 after that time.
    const auto done = run_libration({"reference", "--problem", set, "--until", "x = 1/3", "--before", "1"});
    CHECK(done.exit_code == 1);
    CHECK(done.out.empty());
    CHECK_THAT(done.err, Catch::Contains("event '1' is not found before that time: 0 were found for b in [1.0000"));
}

// The amplitude of x is in [0.5, 2].
TEST_CASE("reference --how-many prints the possible numbers of events", "[command][sets]") {
    const words line{"reference", "--problem", "x'' = -x; x(0) = 0; x'(0) = [0.5, 2]", "--until", "x = 1"};
    const auto with = [&](const words& more) {
        words all = line;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    CHECK(bounds_by(with({"--before", "3", "--how-many"})) == "events  0 or 2\n");
    const auto rows = rows_by(with({"--before", "3", "--how-many", "--crossing", "up"}));
    REQUIRE(rows.size() == 2);
    CHECK(rows[1].at("events") == "1");
    CHECK(rows[1].at("rigour") == "proved");
    CHECK(bounds_by({"reference", "--problem", "x'' = -x; x(0) = 1; x'(0) = 0", "--until", "x = 0", "--before", "9",
                     "--how-many"}) == "events  3\n");
    const auto done = run_libration(with({"--before", "pi/6", "--how-many", "--parts", "4"}));
    CHECK(done.exit_code == 1);
    CHECK(done.out.empty());
    CHECK_THAT(done.err, Catch::Contains("number of events before '0.523598775598' is not decided: the condition may "
                                         "hold in [0."));
    check_refused(with({"--how-many"}), {"--how-many", "--before"});
    check_refused(with({"--before", "3", "--how-many", "--count", "2"}), {"--count", "'2'", "--how-many"});
    check_refused(with({"--before", "3", "--how-many", "--horizon", "9"}), {"--horizon", "'9'", "--how-many"});
    check_refused(with({"--before", "3", "--how-many", "--from-start"}), {"--from-start", "--how-many"});
    check_refused(with({"--before", "3", "--how-many", "--check"}), {"--check", "--how-many"});
    check_refused(with({"--before", "1,2", "--how-many"}), {"--before", "'1,2'"});
    check_refused(with({"--before", "0", "--how-many"}), {"--before", "'0'"});
    check_refused({"reference", "--problem", "pendulum", "--times", "1", "--how-many"}, {"--how-many", "--until"});
}

TEST_CASE("reference --over prints bounds over spans of time", "[command][sets]") {
    const auto rows = rows_by({"reference", "--problem", "x' = x; x(0) = 1", "--over", "0:1:4"});
    REQUIRE(rows.size() == 4);
    CHECK(rows[1].at("from") == "0.25");
    CHECK(rows[1].at("to") == "0.5");
    const precision_scope scope(100);
    CHECK(number_of(rows[1].at("lower")) <= exp(mpfr("0.25")));
    CHECK(number_of(rows[1].at("upper")) >= exp(mpfr("0.5")));
    CHECK(number_of(rows[1].at("upper")) < exp(mpfr("0.501")));
    const auto text = bounds_by({"reference", "--problem", "x' = x", "--set", "x(0) = [1,2]", "--over", "0:1"});
    CHECK_THAT(text, Catch::StartsWith("time  0 to 1\nx     in [0.99"));
}

TEST_CASE("the parts of a set are stated on stderr, and what is known beyond the last time", "[command][sets]") {
    const auto done = run_libration({"reference", "--problem", "x' = x^2; x(0) = [0.5, 1.5]", "--times", "0.5,1",
                                     "--parts", "8", "--format", "csv"});
    CHECK(done.exit_code == 1);
    CHECK_THAT(done.err, Catch::Contains("was enclosed in 8 parts and "));
    CHECK_THAT(done.err, Catch::Contains("time '1' is not reached by every solution: all of them are proved to exist "
                                         "up to 0."));
    CHECK(csv_rows(done.out).size() == 1);
}

TEST_CASE("what does not support sets says so in one line", "[command][sets]") {
    const std::string set = "x' = -b*x; x(0) = 1; b = [1, 3]";
    for (const words& line :
         {words{"trajectory", "--problem", set, "--times", "1"},
          words{"coefficients", "--problem", set, "--order", "3"}, words{"radius", "--problem", set, "--order", "9"},
          words{"radius", "--problem", set, "--prove"}, words{"singularities", "--problem", set},
          words{"find", "--problem", set, "--unknown", "x(0)", "--such-that", "x(1) = 1"},
          words{"table", "--problem", set, "--times", "1"}}) {
        check_refused(line, {"'b' at line 1, column 22 is a set of values"});
    }
    for (const words& more : {words{"--check"}, words{"--plot", "t,x"}, words{"--certificate", "c.json"},
                              words{"--trace", "steps.csv"}, words{"--derivatives", "b"}}) {
        words line{"reference", "--problem", set, "--times", "1"};
        line.insert(line.end(), more.begin(), more.end());
        check_refused(line, {more.front(), "is not supported with sets"});
    }
    for (const words& more : {words{"--check"}, words{"--from-start"}, words{"--certificate", "c.json"}}) {
        words line{"reference", "--problem", set, "--until", "x = 1/2"};
        line.insert(line.end(), more.begin(), more.end());
        check_refused(line, {more.front(), "is not supported with sets"});
    }
    check_refused({"reference", "--problem", set, "--until", "x = c"}, {"--problem", "'c'"});
    check_refused({"reference", "--problem", set, "--times", "inf"}, {"--times", "inf"});
    check_refused({"reference", "--problem", set}, {"--times", "--over"});
    check_refused({"reference", "--problem", set, "--set", "x(0)=1,2", "--times", "1"}, {"--set", "list"});
    check_refused({"reference", "--problem", set, "--times", "1", "--over", "0:1"}, {"--over", "--times"});
    check_refused({"reference", "--problem", set, "--over", "1"}, {"--over", "'1'"});
    check_refused({"reference", "--problem", set, "--over", "1:0"}, {"--over", "'1:0'"});
    check_refused({"reference", "--problem", set, "--over", "0:1:0"}, {"--over", "'0:1:0'"});
    check_refused({"reference", "--problem", set, "--times", "1", "--parts", "0"}, {"--parts", "'0'"});
    check_refused({"reference", "--problem", "x' = x; x(0) = 1", "--times", "1", "--parts", "2"}, {"--parts", "'2'"});
    check_refused({"reference", "--theta0", "1", "--omega0", "0", "--over", "0:1"}, {"--over", "--problem"});
    check_refused({"reference", "--problem", "x' = x; x(0) = [2, 1]", "--times", "1"},
                  {"'x(0)'", "the lower end first"});
    check_refused({"reference", "--problem", "x' = x; x(0) = [2]", "--times", "1"}, {"is not an interval"});
    check_refused({"reference", "--problem", "x' = -abs(x); x(0) = [1, 2]", "--times", "1"}, {"abs(x)"});
}

TEST_CASE("sets that are singular at the start end with status 1 and one line", "[command][sets]") {
    for (const std::string problem : {"x' = sqrt(x); x(0) = [0,1]", "x' = 1/x; x(0) = [0,1]",
                                      "x' = log(x); x(0) = [0,1]", "x' = x/a; x(0) = 1; a = [0,1]"}) {
        for (const words& more :
             {words{"--time", "1"}, words{"--time", "1", "--parts", "4"}, words{"--over", "0:1"},
              words{"--until", "x = 20", "--before", "1"}, words{"--until", "x = 20", "--before", "1", "--how-many"}}) {
            const auto done = run_libration(words{"reference", "--problem", problem} + more);
            INFO(problem << " " << command_line(more) << ": " << done.err);
            CHECK(done.exit_code == 1);
            CHECK(done.out.empty());
            CHECK_THAT(done.err, Catch::Contains("no step from the initial point is proved"));
        }
    }
}

// Near the maximum of sin 2t, about 1, the two sides may touch.
TEST_CASE("the possible numbers of events of one solution are called that", "[command][sets]") {
    const words line{
        "reference",    "--problem", "y'' = -4*y; y(0) = 0; y'(0) = 2", "--until", "(y - 1/3)*(y - 1/7) = 1/2",
        "--before=-12", "--how-many"};
    const auto text = bounds_by(line);
    INFO(text);
    CHECK(text.starts_with("events  "));
    const bool several = text.find(" or ") != std::string::npos;
    CHECK(several == (text.find("proved: one of these is the number of changes of sign") != std::string::npos));
}

}  // namespace command_set_test
