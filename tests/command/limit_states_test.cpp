// Conditions at infinity in reference, trajectory and find --show; manifolds of equilibria; and what is not accepted.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_limit_states_test {

using namespace libration::tests;

namespace {

const words soliton{"--problem", "y'' = y - y^3; y'(0) = 0; y(inf) = 0", "--guess", "y(0)=1.4", "--digits", "20"};
const words front{"--problem", "u'' + c*u' + u*(1-u)*(u-1/4) = 0; u(-inf) = 1; u(inf) = 0", "--digits", "20"};
const words pendulum{"trajectory", "--problem", "x'' = -sin(x)", "--equilibrium", "x=pi"};

// The rows of a command that also prints on stderr.
std::vector<table_row> rows_and(words line, std::string* remarks = nullptr) {
    line.insert(line.end(), {"--format", "csv"});
    const auto done = run_libration(line);
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    if (remarks != nullptr) {
        *remarks = done.err;
    }
    return csv_rows(done.out);
}

}  // namespace

// sqrt 2 sech t.
TEST_CASE("reference finds what conditions at infinity leave open", "[command][reference][proved]") {
    std::string remarks;
    const auto rows =
        rows_and(words{"reference"} + soliton + words{"--times", "1,inf", "--show", "amplitude"}, &remarks);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("y") == "0.91648714296931200255");
    CHECK(rows[0].at("amplitude of y") == "2.8284271247461900976");
    CHECK(rows[1].at("y") == "0");
    CHECK(rows[1].at("time") == "inf");
    CHECK(remarks.find("y(0): 1.4142135623730950488") != std::string::npos);
    CHECK(remarks.find("amplitude") == std::string::npos);
    CHECK(remarks.find("rate 1: 1.0000000000000000000") != std::string::npos);
}

TEST_CASE("find and trajectory know orbits with two ends", "[command][find][proved]") {
    const auto rows = rows_and(words{"find"} + front + words{"--unknown", "c", "--show", "rate,angle"});
    REQUIRE(rows.size() == 4);
    CHECK(rows[1].at("name") == "rate 1");
    CHECK(rows[1].at("value") == "0.70710678118654752440");
    CHECK(rows[3].at("name") == "angle of intersection");
    CHECK(rows[3].at("value").starts_with("0.732302248989508"));
    std::string remarks;
    const auto states = rows_and(words{"trajectory"} + front + words{"--times", "-inf,0,20"}, &remarks);
    CHECK(states[1].at("u") == "0.50000000000000000000");
    CHECK(states[0].at("u") == "1.0000000000000000000");
    CHECK(states[2].at("rigour") == "proved");
    CHECK(remarks.find("phase: u = u(-inf) - exp(0.70710678") != std::string::npos);
}

TEST_CASE("a figure of a front reaches as far as anything moves", "[command][plot]") {
    const temporary_folder folder;
    words line = words{"trajectory"} + front + words{"--plot", "t,u", "--out", "front.svg", "--format", "csv"};
    const auto done = run_libration(line, folder.path());
    REQUIRE(done.exit_code == 0);
    CHECK(std::filesystem::exists(folder.path() / "front.svg"));
    const auto rows = csv_rows(done.out);
    CHECK(rows.size() > 200);
    CHECK(rows.front().at("u").starts_with("0.99"));
    CHECK(rows.back().at("u").starts_with("0.00"));
}

// x'^2/2 - cos x = 1.
TEST_CASE("the manifolds of an equilibrium as a table and a figure", "[command][plot]") {
    const temporary_folder folder;
    const auto done = run_libration(
        pendulum + words{"--manifold", "both", "--plot", "--out", "portrait.svg", "--format", "csv"}, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(text_of_file(folder.path() / "portrait.svg").find("unstable manifold") != std::string::npos);
    const auto rows = csv_rows(done.out);
    REQUIRE(rows.size() > 400);
    for (std::size_t i = 0; i < rows.size(); i += 50) {
        const double x = std::stod(rows[i].at("x"));
        const double v = std::stod(rows[i].at("x'"));
        CHECK(std::fabs(v * v / 2 - std::cos(x) - 1) < 1e-8);
    }
    CHECK(rows.front().at("manifold") == "stable");
    CHECK(rows.back().at("branch") == "2");
    const auto stable = rows_and(pendulum + words{"--manifold", "stable"});
    CHECK(std::ranges::all_of(stable, [](const auto& row) { return row.at("manifold") == "stable"; }));
}

TEST_CASE("what is not accepted with conditions at infinity and manifolds", "[command][bad input]") {
    check_refused(words{"reference"} + soliton, {"--times"});
    check_refused(words{"reference"} + soliton + words{"--until", "y = 1"},
                  {"--until 'y = 1'", "conditions at infinity"});
    check_refused(words{"reference"} + soliton + words{"--times", "-inf"}, {"-inf", "without conditions"});
    check_refused({"reference", "--problem", "y' = -y; y(0) = 1", "--times", "1", "--guess", "y(0)=2"},
                  {"--guess 'y(0)=2'", "the problem has none"});
    check_refused(words{"reference"} + soliton + words{"--times", "1", "--guess", "y(0)=1,2"}, {"--guess"});
    // All directions decay, in one block.
    check_refused({"find", "--problem", "x' = c - x; x(0) = 5; x(inf) = c; c = 1", "--unknown", "c"},
                  {"--unknown", "has too many names"});
    // 6/(t + sqrt 6)^2 is the only positive solution that decays.
    check_refused({"find", "--problem", "y'' = y^2; y(0) = 1; y(inf) = 0 exponentially", "--unknown", "y'(0)"},
                  {"without a direction of exponential decay"});
    check_refused({"reference", "--problem", "y' = -y; y(0) = 1; y(inf) = 0", "--times", "1"}, {"leaves nothing open"});
    const words kink{"--problem", "u'' = sin(u); u(0) = 3; u(-inf) = 0; u(inf) = 2*pi", "--unknown", "u'(0)"};
    check_refused(words{"find"} + kink, {"--problem 'u'", "limits at both ends", "one of the ends"});
    check_refused(words{"reference"} + kink + words{"--times", "1"}, {"--problem 'u'", "limits at both ends"});
    check_refused({"trajectory", "--problem", "y' = -y; y(0) = 1"}, {"--times"});
    check_refused(pendulum, {"--equilibrium 'x=pi'", "--manifold both"});
    check_refused(pendulum + words{"--manifold", "left"}, {"--manifold 'left'", "stable, unstable or both"});
    check_refused(pendulum + words{"--manifold", "both", "--times", "1"}, {"--times '1'"});
    check_refused({"trajectory", "--problem", "x'' = -sin(x)", "--manifold", "both"}, {"--equilibrium"});
    check_refused({"trajectory", "--problem", "x'' = -sin(x)", "--manifold", "both", "--equilibrium", "x=1"},
                  {"--equilibrium 'x=1'", "exactly"});
    check_refused({"trajectory", "--problem", "x'' = -sin(x)", "--manifold", "both", "--equilibrium", "x=0"},
                  {"--equilibrium 'x=0'", "decay or growth"});
    check_refused({"trajectory", "--problem", "x'' = -sin(x)", "--manifold", "both", "--equilibrium", "pi"},
                  {"--equilibrium 'pi'", "x=0,y=0"});
}

// x tends to 0 at twice the rate of 1 - u as t -> -inf: u fixes t = 0, where 1 - u has the amplitude 1, in either order.
TEST_CASE("the phase of an orbit is that of the first unknown with the slowest rate", "[command][find]") {
    const std::string carried = "x' = -x + (1-u)^2; ";
    const std::string front = "u'' + c*u' + u*(1-u)*(u-1/4) = 0; ";
    const std::string limits = "x(-inf)=0; x(inf)=1; u(-inf)=1; u(inf)=0";
    std::vector<std::string> values;
    for (const std::string& text : {carried + front + limits, front + carried + limits}) {
        const auto rows =
            rows_and({"reference", "--problem", text, "--unknown", "c", "--digits", "8", "--times", "0,5"});
        REQUIRE(rows.size() == 2);
        for (const auto& row : rows) {
            values.push_back(row.at("u"));
        }
    }
    // u = 1/(1 + exp(t/sqrt 2)), which is 1 - exp(t/sqrt 2) and smaller terms.
    CHECK(values[0] == "0.50000000");
    CHECK(values[0] == values[2]);
    CHECK(values[1] == values[3]);
}

}  // namespace command_limit_states_test
