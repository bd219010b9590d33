// The proved digits of `libration reference` compared with the reference tables, closed forms, symmetries and its
// second route.
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/reference_motion.hpp"
#include "command/refusal.hpp"

namespace command_reference_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> reference_of(words motion) {
    motion.insert(motion.begin(), "reference");
    return rows_of(motion);
}

table_row single_reference(const words& motion) {
    auto rows = reference_of(motion);
    REQUIRE(rows.size() == 1);
    return rows.front();
}

}  // namespace

TEST_CASE("every state of the reference table is proved to 50 digits and confirmed by the second route",
          "[command][reference]") {
    std::size_t states = 0;
    for (const reference_motion& motion : reference_motions()) {
        INFO(command_line(motion.options));
        const auto rows = reference_of(motion.options + words{motion.times(), "--check"});
        REQUIRE(rows.size() == motion.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            INFO("time " << rows[i].at("time"));
            for (const std::string name : {"theta", "omega", "period", "tstar"}) {
                CHECK_THAT(rows[i].at(name), right_to_the_last_digit(motion.rows[i].at(name)));
            }
            if (!motion.rows[i].at("radius").empty()) {
                CHECK_THAT(rows[i].at("radius"), right_to_the_last_digit(motion.rows[i].at("radius")));
            }
            CHECK(rows[i].at("rigour") == "proved");
            ++states;
        }
    }
    CHECK(states > 200);
}

TEST_CASE("the columns of a reference keep their order", "[command][reference]") {
    const std::string csv = output_of({"reference", "--energy", "1.71", "--time", "1", "--format", "csv"});
    CHECK(lines_of(csv).front() ==
          "energy,gap,regime,theta0,omega0,time,theta,omega,period,tstar,radius,digits,rigour,direction,"
          "time_typed,energy_typed,gap_typed,theta0_typed,omega0_typed");
}

TEST_CASE("half way down theta is 2 asin of k over the root of 1 + k'", "[command][reference]") {
    const precision_scope scope(150);
    for (const std::string energy : {"1e-20", "0.5", "1", "1.71"}) {
        INFO(energy);
        const mpfr e = from_exact<mpfr>(read_exact(energy));
        const mpfr k = sqrt(e / 2);
        const mpfr complement = sqrt((2 - e) / 2);
        const mpfr expected = asin(k / sqrt(1 + complement)) * 2;
        const auto row = single_reference({"--energy", energy, "--time", "T/8", "--digits", "80"});
        CHECK_THAT(row.at("theta"), right_to_the_last_digit_of(expected));
    }
}

TEST_CASE("the swing from 90 degrees is lemniscatic and exactly 0 after a quarter", "[command][reference]") {
    const precision_scope scope(150);
    const mpfr gamma = tgamma(mpfr("0.25"));
    const auto rows = reference_of({"--theta0", "90deg", "--omega0", "0", "--time", "0,T/4,T/2,3T/4,1e30T"});
    REQUIRE(rows.size() == 5);
    CHECK_THAT(rows[0].at("period"), right_to_the_last_digit_of(gamma * gamma / sqrt(pi<mpfr>())));
    const std::vector<std::string> thetas{"+", "0", "-", "0", "+"};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const mpfr expected = pi<mpfr>() / 2 * (thetas[i] == "-" ? -1 : thetas[i] == "0" ? 0 : 1);
        CHECK_THAT(rows[i].at("theta"), right_to_the_last_digit_of(expected));
    }
    CHECK_THAT(rows[1].at("omega"), right_to_the_last_digit_of(-sqrt(mpfr(2))));
    CHECK(rows[2].at("omega") == "0");
}

TEST_CASE("symmetric starts by state agree with the canonical motion moved by quarters", "[command][reference]") {
    // From -90deg the state at t is minus that from +90deg; from 0 with omega0 = sqrt(2E) it is a quarter later.
    const auto above = reference_of({"--energy", "1", "--time", "0.3,7,T/3"});
    const auto below = reference_of({"--theta0", "-90deg", "--omega0", "0", "--time", "0.3,7,T/3"});
    for (std::size_t i = 0; i < above.size(); ++i) {
        CHECK_THAT(below[i].at("theta"), right_to_the_last_digit_of(-number_of(above[i].at("theta"))));
        CHECK_THAT(below[i].at("omega"), right_to_the_last_digit_of(-number_of(above[i].at("omega"))));
    }
    const auto falling = reference_of({"--theta0", "0", "--omega0", "-1", "--time", "T/8", "--check"});
    const auto canonical = reference_of({"--energy", "0.5", "--time", "3T/8"});
    CHECK(falling[0].at("theta") == canonical[0].at("theta"));
    const auto turned = single_reference({"--theta0", "3pi", "--omega0", "-0.2", "--time", "T/3", "--check"});
    const auto clockwise = single_reference({"--energy", "2.02", "--direction", "-", "--time", "T/3"});
    const precision_scope scope(100);
    CHECK_THAT(turned.at("theta"), right_to_the_last_digit_of(number_of(clockwise.at("theta")) + pi<mpfr>() * 2));
}

TEST_CASE("gaps of 1e-1000 keep every digit of a tiny omega", "[command][reference]") {
    // Near the top pi - theta grows from its initial value k' 2 as cosh: omega = -2 k' sinh t (1 + O(k'^2 e^2t)), k'^2
    // = gap/2.
    const precision_scope scope(120);
    const mpfr t = 5;
    const mpfr expected = -sqrt(mpfr(2)) * pow(mpfr(10), -500) * sinh(t);
    const auto row = single_reference({"--gap", "1e-1000", "--time", "5", "--digits", "60", "--check"});
    CHECK_THAT(row.at("omega"), right_to_the_last_digit_of(expected));
    CHECK_THAT(row.at("theta"), right_to_the_last_digit_of(pi<mpfr>()));
}

TEST_CASE("fewer digits are the beginning of more digits", "[command][reference]") {
    for (const words& motion :
         {words{"--energy", "1.71", "--time", "1e20"}, words{"--theta0", "2.5", "--omega0", "-0.3", "--time", "1e20"},
          words{"--gap", "-1e-20", "--time", "1e3"}}) {
        INFO(command_line(motion));
        const auto few = single_reference(motion + words{"--digits", "7"});
        const auto many = single_reference(motion + words{"--digits", "1000"});
        for (const std::string name : {"theta", "omega", "period", "tstar", "radius", "gap"}) {
            CHECK_THAT(few.at(name), right_to_the_last_digit(many.at(name)));
        }
        CHECK(significant_digits(many.at("theta")) == 1000);
    }
}

TEST_CASE("equilibria and the separatrix are their closed forms", "[command][reference]") {
    const precision_scope scope(120);
    const auto up = single_reference({"--theta0", "pi", "--omega0", "0", "--time", "5"});
    CHECK_THAT(up.at("theta"), right_to_the_last_digit_of(pi<mpfr>()));
    CHECK((up.at("omega") == "0" && up.at("radius") == "inf" && up.at("tstar") == "inf"));
    const auto down = single_reference({"--energy", "0", "--time", "T/3"});
    CHECK((down.at("theta") == "0" && down.at("omega") == "0" && down.at("radius") == "inf"));
    CHECK_THAT(down.at("period"), right_to_the_last_digit_of(pi<mpfr>() * 2));
    const auto between = single_reference({"--energy", "2", "--time", "3", "--check"});
    CHECK_THAT(between.at("theta"), right_to_the_last_digit_of(atan(sinh(mpfr(3))) * 2));
    CHECK_THAT(between.at("omega"), right_to_the_last_digit_of(2 / cosh(mpfr(3))));
    CHECK_THAT(between.at("radius"), right_to_the_last_digit_of(pi<mpfr>() / 2));
}

TEST_CASE("a length of 4 at a gravity of 1 doubles times and halves omega", "[command][reference]") {
    for (const words& motion :
         {words{"--energy", "1.71"}, words{"--energy", "2"}, words{"--energy", "1.71", "--theta0", "1"}}) {
        const auto plain = single_reference(motion + words{"--time", "0.35", "--digits", "60"});
        const auto scaled =
            single_reference(motion + words{"--time", "0.7", "--length", "4", "--gravity", "1", "--check"});
        CHECK_THAT(scaled.at("theta"), right_to_the_last_digit(plain.at("theta")));
        CHECK_THAT(scaled.at("omega"), right_to_the_last_digit_of(number_of(plain.at("omega")) / 2));
        CHECK_THAT(scaled.at("radius"), right_to_the_last_digit_of(number_of(plain.at("radius")) * 2));
    }
}

TEST_CASE("each row of a file is a motion of its own at its own time", "[command][reference]") {
    const temporary_folder folder;
    const auto of_file = [&](const std::string& csv, const words& more = {}) {
        std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
        const auto done =
            run_libration(words{"reference", "--motions", "f.csv", "--format", "csv"} + more, folder.path());
        INFO(done.err);
        REQUIRE(done.exit_code == 0);
        return csv_rows(done.out);
    };
    const auto rows = of_file(
        "theta0;omega0;gap;energy;direction;t\n2.5;-0.3;;;;1e20\n;;1e-30;;-;5\n;;1e-30;;-;T/8\n1;;;3;;7\n;;;1.71;;T/"
        "4\n");
    REQUIRE(rows.size() == 5);
    const std::vector<words> alone{{"--theta0", "2.5", "--omega0", "-0.3", "--time", "1e20"},
                                   {"--gap", "1e-30", "--direction", "-", "--time", "5"},
                                   {"--gap", "1e-30", "--direction", "-", "--time", "T/8"},
                                   {"--energy", "3", "--theta0", "1", "--time", "7"},
                                   {"--energy", "1.71", "--time", "T/4"}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(rows[i] == single_reference(alone[i]));
    }
    // One list of times for all, seconds, and printed values as input.
    const auto with_times = of_file("E,L,g\n1.71,4,1\n0.5,1,1\n", {"--times", "0.7,1.4"});
    REQUIRE(with_times.size() == 4);
    CHECK(with_times[0] == single_reference({"--energy", "1.71", "--length", "4", "--gravity", "1", "--time", "0.7"}));
    CHECK(with_times[3] == single_reference({"--energy", "0.5", "--time", "1.4"}));
    const std::string printed =
        output_of({"reference", "--theta0", "2.5", "--omega0", "-0.3", "--time", "1,T/3", "--format", "csv"});
    CHECK(of_file(printed) == csv_rows(printed));
    std::ofstream(folder.path() / "f.csv") << "E,t\n1.71,0.7\n3,1\n";
    const auto text = run_libration({"reference", "--motions", "f.csv", "--digits", "5"}, folder.path());
    CHECK(text.out.find("regime    libration") < text.out.find("regime    rotation"));
}

TEST_CASE("a row that is no motion is refused with its line and column", "[command][reference]") {
    const auto refused = [](const std::string& csv, const words& more, const std::string& mentioned) {
        const temporary_folder folder;
        std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
        INFO(csv);
        check_refused(words{"reference", "--motions", "f.csv"} + more, {mentioned}, folder);
    };
    refused("E,t\n1,0\n-1,0\n", {}, "f.csv:3: E '-1' is a negative energy");
    refused("E,t\n1,x\n", {}, "f.csv:2: t 'x' is not a number");
    refused("E,t\n2,T/4\n", {}, "f.csv:2: t 'T/4' is a multiple of an infinite period");
    refused("E,t\n1,0\n,0\n", {}, "f.csv:3: the row has no motion");
    refused("E,t\n1\n", {}, "f.csv:2: the row has 1 cells, the header has 2");
    refused("E,gap,t\n1,0.5,0\n", {}, "f.csv:2: gap '0.5' contradicts E '1'");
    refused("E\n1\n", {}, "--motions 'f.csv' has no column 'time': add --times LIST");
    refused("E,t\n1,0\n", {"--times", "1"}, "--motions 'f.csv' has times, and --times too");
    refused("E,t\n1,0\n", {"--gap", "0.5"}, "f.csv:2: --gap '0.5' contradicts E '1'");
    refused("E,t\n", {}, "f.csv has no row");
    refused("E,t\n1,0\n", {"--columns", "x=time"}, "--columns 'x=time' has 'x'");
    check_refused({"reference", "--energy", "1"}, {"add --times LIST"});
    check_refused({"reference", "--energy", "1", "--time", "1", "--until", "theta = 0"},
                  {"--until 'theta = 0'", "--problem"});
    check_refused({"reference", "--energy", "1", "--time", "1", "--count", "2"}, {"--count '2'"});
    check_refused({"reference", "--energy", "1", "--time", "1", "--columns", "t=time"}, {"--columns 't=time'"});
    check_refused({"reference", "--motions", "none.csv"}, {"--motions 'none.csv'"});
}

TEST_CASE("what a reference cannot answer is refused with the reason", "[command][reference]") {
    const words motion{"reference", "--energy", "1.71"};
    check_refused(motion + words{"--time", "1", "--digits", "100001"}, {"--digits '100001'"});
    check_refused(motion + words{"--time", "1", "--digits", "0"}, {"--digits '0'"});
    check_refused(motion + words{"--time", "30deg"}, {"30deg"});
    check_refused(motion + words{"--time", "1", "--digits", "20000", "--check"}, {"--check"});
    check_refused({"reference", "--energy", "2", "--time", "T/4"}, {"infinite period"});
    check_refused({"reference", "--energy", "2", "--time", "1e30"}, {"--times '1e30'"});
    check_refused({"reference", "--theta0", "1", "--omega0", "pi", "--time", "1"}, {"--omega0 'pi'"});
}

// x = cos(t), x' = -sin(t), at 1/2: the state transition matrix is a rotation.
TEST_CASE("derivatives by all initial values and chosen columns are printed", "[command][reference]") {
    const words of{"--problem", "x'' = -x; x(0) = 1; x'(0) = 0", "--time", "1/2", "--digits", "10"};
    const auto all = output_of(words{"reference", "--derivatives", "initial", "--format", "csv"} + of);
    CHECK(all.find("dx(t)/dx(0)") != std::string::npos);
    CHECK(all.find("dx'(t)/dx'(0)") != std::string::npos);
    CHECK(output_of(words{"reference", "--columns", "x',time", "--format", "csv"} + of) ==
          "x',time\n-0.4794255386,0.5\n");
    check_refused(words{"reference", "--columns", "v"} + of, {"--columns 'v' is not a column of this table"});
}

}  // namespace command_reference_test
