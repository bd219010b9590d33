// Inputs of any size and kind end in bounded time and memory: with a result, or with one line that has the remedy.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <string>

#include "command/refusal.hpp"

namespace command_bounded_work_test {

using namespace libration::tests;

namespace {

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

// k0 = k1 OPERATION k1; ...; k60 = LAST
std::string chain_of(const std::string& operation, const std::string& last) {
    std::string text = "y' = k0*y; y(0) = 1; k60 = " + last;
    for (int i = 0; i < 60; ++i) {
        const std::string next = "k" + std::to_string(i + 1);
        text += "; k" + std::to_string(i) + " = " + next + operation + next;
    }
    return text;
}

void write_file(const temporary_folder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
}

// Whether the program succeeds and prints a line.
void check_prints(const words& line, const std::string& expected, const temporary_folder& folder) {
    const finished_process done = run_libration(line, folder.path());
    INFO(command_line(line).substr(0, 200) << "\n" << done.err);
    CHECK(done.exit_code == 0);
    CHECK(("\n" + done.out).find("\n" + expected + "\n") != std::string::npos);
}

}  // namespace

// y' = n y from 1: n^2/2; y' = y^n: n/2.
TEST_CASE("long sums and products are expanded, proved and printed", "[command][bounded work]") {
    const temporary_folder folder;
    write_file(folder, "sum.ode", "y' = y" + repeated(" + y", 29'999) + "; y(0) = 1");
    write_file(folder, "product.ode", "y' = y" + repeated("*y", 19'999) + "; y(0) = 1");
    const words coefficients{"coefficients", "--order", "2", "--digits", "9", "--format", "csv", "--problem"};
    check_prints(coefficients + words{"./sum.ode"}, "2,450000000", folder);
    check_prints(coefficients + words{"./product.ode"}, "2,10000.0000", folder);
    const std::string sum = "1" + repeated("+1", 29'999);
    check_prints({"trajectory", "--problem", "y' = 1; y(0) = 0", "--times", sum, "--digits", "5", "--format", "csv",
                  "--columns", "y"},
                 "30000", folder);
}

TEST_CASE("the command evaluates parameters that share others once", "[command][bounded work]") {
    const temporary_folder folder;
    const words coefficients{"coefficients", "--order", "1", "--digits", "19", "--format", "csv", "--problem"};
    check_prints(coefficients + words{chain_of("+", "1")}, "1,1152921504606846976", folder);  // 2^60
    check_refused(coefficients + words{chain_of("*", "2")}, {"--problem", "is beyond the range"});
    check_refused(coefficients + words{chain_of("*", "pi")},
                  {"--problem 'equation'", "is beyond the range of numbers"});
}

TEST_CASE("files without an end are read to a limit", "[command][bounded work]") {
    check_refused({"coefficients", "--order", "1", "--problem", "/dev/zero"},
                  {"--problem '/dev/zero'", "is longer than 1000000 characters"});
    check_refused({"verify", "/dev/zero"}, {"FILE '/dev/zero'", "has more than 16777216 characters in line 1"});
    check_refused({"reference", "--motions", "/dev/zero", "--time", "1"}, {"--motions '/dev/zero'", "in line 1"});
}

TEST_CASE("folders are not read", "[command][bounded work]") {
    const temporary_folder folder;
    check_refused({"coefficients", "--order", "1", "--problem", "./"}, {"--problem './'"}, folder);
    check_refused({"radius", "--coefficients", "./"}, {"--coefficients './'"}, folder);
    check_refused({"verify", "./"}, {"FILE './'"}, folder);
}

TEST_CASE("deep, long and broken texts are refused with the limit", "[command][bounded work]") {
    const words coefficients{"coefficients", "--order", "1", "--problem"};
    const auto y_is = [&](const std::string& right) { return coefficients + words{"y' = " + right + "; y(0) = 1"}; };
    check_refused(y_is(repeated("(", 50'000) + "y"), {"more than 100 deep"});
    check_refused(y_is("y" + repeated(")", 50'000)), {"closes nothing"});
    check_refused(y_is(repeated("-", 50'000) + "y"), {"more than 100 deep"});
    check_refused(y_is("y" + repeated("^1", 50'000)), {"more than 100 deep"});
    check_refused(y_is(repeated("sin(", 20'000) + "y" + repeated(")", 20'000)), {"more than 100 deep"});
    check_refused(y_is(repeated("a", 50'000)), {"has more than 200 characters"});
    check_refused(y_is("y*1" + repeated("0", 50'000) + " 1"), {"multiplies without *"});
    check_refused(y_is("1e99999999*y"), {"is beyond the range 1e-100000 .. 1e100000"});
    check_refused(y_is("2^(2^60)*y"), {"is beyond the range 1e-100000 .. 1e100000"});
    check_refused(y_is("y \xff"), {"is not allowed in a problem"});
    check_refused({"period", "--energy", "1" + repeated("+1", 60'000)}, {"--energy", "is longer than 100000"});
    check_refused({"period", "--energy", repeated("(", 90'000)}, {"--energy", "more than 100 deep"});
    check_refused({"period", "--energy", "pi" + repeated("*pi", 300)}, {"--energy", "more than 200 products"});
    const temporary_folder folder;
    write_file(folder, "nul.ode", std::string("y' = y; y(0) = 1\0", 17));
    check_refused({"coefficients", "--order", "1", "--problem", "./nul.ode"}, {"is not allowed in a problem"}, folder);
}

TEST_CASE("a row that no proof reaches leaves the others their verdicts", "[command][bounded work]") {
    const temporary_folder folder;
    write_file(folder, "rows.csv", "time,y\n1e400,1\n1/2,1.6487212707\n-1e300,1\n1e401,1\n1,2.5\n");
    const auto done = run_libration({"verify", "rows.csv", "--problem", "y' = y; y(0) = 1"}, folder.path());
    INFO(done.err);
    CHECK(done.exit_code == 1);
    CHECK(done.out.find("\n1e400,1,,,,undecided,\n1/2,1.6487212707,1.6487212707") != std::string::npos);
    CHECK(done.out.find("\n-1e300,1,,,,undecided,\n1e401,1,,,,undecided,\n1,2.5,2.7182818") != std::string::npos);
    CHECK(done.err.find("rows.csv:2: time '1e400' is not reached: the proof has reached ") != std::string::npos);
    CHECK(done.err.find("rows.csv:5: time '1e401' is beyond the time of another row") != std::string::npos);
    CHECK(done.err.find("rows.csv: 5 rows, 1 ok, 1 miss, 0 malformed, 3 undecided") != std::string::npos);
}

// y = exp(t): of all times the same digits as of one. A minute would be quadratic time.
TEST_CASE("long lists of times take time in proportion to their length", "[command][bounded work]") {
    const temporary_folder folder;
    const auto before = std::chrono::steady_clock::now();
    const auto done = run_libration(
        {"reference", "--problem", "y' = y; y(0) = 1", "--times", "1e-4:3:30000", "--digits", "10", "--format", "csv"},
        folder.path());
    INFO(done.err);
    CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(20));
    CHECK(done.exit_code == 0);
    CHECK(std::ranges::count(done.out, '\n') == 30'001);
    CHECK_THAT(done.out, Catch::Contains(",20.08553692,"));  // exp(3)
}

// y' = y (1 + t + ... + t^4999), of which 1/(1 - t) differs by less than 1e-29000 at 1e-6; and y' = 80000 y.
TEST_CASE("sums of thousands of terms are proved in seconds", "[command][bounded work]") {
    const temporary_folder folder;
    std::string terms;
    for (int i = 1; i < 5000; ++i) {
        terms += " + y*t^" + std::to_string(i);
    }
    write_file(folder, "powers.ode", "y' = y" + terms + "; y(0) = 1");
    write_file(folder, "equal.ode", "y' = y" + repeated(" + y", 79'999) + "; y(0) = 1");
    write_file(folder, "power.ode", "y' = 66*t^65; x' = x^1000*y; y(0) = 1; x(0) = 0");
    const words at{"reference", "--digits", "10", "--format", "csv", "--problem"};
    const auto before = std::chrono::steady_clock::now();
    check_prints(at + words{"./powers.ode", "--time", "1e-6"}, "1e-6,1.000001000,10,proved,1e-6", folder);
    check_prints(at + words{"./equal.ode", "--time", "1e-6"}, "1e-6,1.083287068,10,proved,1e-6", folder);  // exp(0.08)
    CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(30));
    check_prints(at + words{"./power.ode", "--time", "1"}, "1,2.000000000,0,10,proved,1", folder);
}

}  // namespace command_bounded_work_test
