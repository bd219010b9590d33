// reference and trajectory: --integrator, the line that states the use of collocation, and --trace.
#include <catch2/catch.hpp>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "command/temporary_folder.hpp"

namespace command_integrator_test {

using namespace libration;
using namespace libration::tests;

namespace {

// y = cos(t) + exp(-1e4 t).
const words stiff{"--problem", "y' = -1e4*(y - cos(t)) - sin(t); y(0) = 2", "--digits", "15"};
const std::string value_at_3 = "-0.989992496600445";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("the use of collocation is stated on stderr", "[command][reference]") {
    const auto chosen = run_libration(words{"reference"} + stiff + words{"--time", "3"});
    CHECK(chosen.exit_code == 0);
    CHECK(contains(chosen.out, value_at_3));
    CHECK(contains(chosen.err, "libration: integrated by collocation (theorem K) from t = "));
    CHECK(contains(chosen.err, " to 3: "));
    const auto forced = run_libration(words{"reference", "--integrator", "collocation"} + stiff + words{"--time", "3"});
    CHECK(contains(forced.out, value_at_3));
    CHECK(contains(forced.err, "from t = 0 to 3: "));
    const auto taylor = run_libration(words{"reference", "--integrator", "taylor"} + stiff + words{"--time", "1/10"});
    CHECK(taylor.exit_code == 0);
    CHECK(taylor.err.empty());
    const auto trajectory = run_libration(words{"trajectory", "--scalar", "ball:15", "--integrator", "collocation"} +
                                          stiff + words{"--times", "3"});
    CHECK(contains(trajectory.out, value_at_3));
    CHECK(contains(trajectory.err, "from t = 0 to 3: "));
}

TEST_CASE("rounded trajectories of stiff equations are integrated by collocation, which is not called a proof",
          "[command][trajectory]") {
    const words robertson{"trajectory", "--problem", "robertson", "--times", "40,1e11", "--scalar"};
    for (const char* scalar : {"double", "mpfr:15"}) {
        const auto done = run_libration(robertson + words{scalar});
        CHECK(done.exit_code == 0);
        CHECK(contains(done.out, "2.0833401497012"));
        CHECK(contains(done.out, "0.71582706871940"));
        CHECK(contains(done.err, "libration: integrated by collocation from t = "));
        CHECK_FALSE(contains(done.err, "theorem"));
    }
    const auto forced = run_libration(robertson + words{"double", "--integrator", "collocation"});
    CHECK(contains(forced.err, "from t = 0 to 1e+11: "));
    const auto lists = run_libration({"trajectory", "--problem", "y' = -k*(y - cos(t)) - sin(t); y(0) = 2", "--set",
                                      "k=1e8,2e8", "--times", "3", "--scalar", "double"});
    CHECK(lists.exit_code == 0);
    CHECK(contains(lists.err, "to 3: "));
}

TEST_CASE("events of stiff equations are found by collocation, or by a chosen integrator", "[command][reference]") {
    const words until{"reference", "--until", "y = 0"};
    const auto chosen = run_libration(until + stiff);
    CHECK(chosen.exit_code == 0);
    CHECK(contains(chosen.out, "1.57079632679490"));
    CHECK(contains(chosen.err, "libration: integrated by collocation (theorem K) from t = "));
    const auto taylor = run_libration(words{"reference", "--until", "y = 3/2", "--integrator", "taylor"} + stiff);
    CHECK(taylor.exit_code == 0);
    CHECK(taylor.err.empty());
    check_refused(until + stiff + words{"--integrator", "colocation"}, {"--integrator", "colocation", "collocation?"});
    check_refused(until + stiff + words{"--trace", "steps.csv"}, {"--trace", "--until"});
}

TEST_CASE("a chosen integrator replaces closed forms", "[command][reference]") {
    const auto done = run_libration(
        {"reference", "--integrator", "taylor", "--problem", "pendulum", "--time", "1", "--digits", "20"});
    CHECK(done.exit_code == 0);
    CHECK(done.err.empty());
    CHECK(done.out == output_of({"reference", "--general", "--problem", "pendulum", "--time", "1", "--digits", "20"}));
}

TEST_CASE("a trace has a row for each step", "[command][reference]") {
    const temporary_folder folder;
    const auto done =
        run_libration(words{"reference", "--trace", "steps.csv"} + stiff + words{"--time", "3"}, folder.path());
    REQUIRE(done.exit_code == 0);
    REQUIRE(folder.content().size() == 1);
    const auto rows = csv_rows(text_of_file(folder.path() / "steps.csv"));
    REQUIRE(rows.size() > 8);
    double reached = 0;
    for (const table_row& row : rows) {
        CHECK(std::stod(row.at("time")) == Approx(reached));
        reached = std::stod(row.at("time")) + std::stod(row.at("length"));
        CHECK(std::stol(row.at("bits")) > 50);
        CHECK(std::stol(row.at("order")) > 10);
        CHECK(std::stod(row.at("log2_relative_width")) < -40);
    }
    CHECK(reached >= 3);
    CHECK(rows.front().at("log2_relative_width") == "-inf");
    CHECK(rows.front().at("method") == "taylor");
    CHECK(rows.back().at("method") == "collocation");
}

TEST_CASE("many unknowns are followed by a comparison system, as the trace states", "[command][reference]") {
    // A ring of springs with q = cos(2 pi i/16 + 1/3) cos(w t), w = 2 sin(pi/16).
    const words ring{"--problem",
                     "q[i]'' = q[(i+1) mod 16] - 2*q[i] + q[(i-1) mod 16] for i = 0..15; "
                     "q[i](0) = cos(2*pi*i/16 + 1/3) for i = 0..15; q[i]'(0) = 0 for i = 0..15",
                     "--integrator",
                     "comparison",
                     "--time",
                     "1",
                     "--digits",
                     "15",
                     "--check"};
    const temporary_folder folder;
    const auto done = run_libration(words{"reference", "--trace", "steps.csv"} + ring, folder.path());
    REQUIRE(done.exit_code == 0);
    CHECK(contains(done.out, "q[2] "));
    CHECK(contains(done.out, "0.403992353167"));
    for (const table_row& row : csv_rows(text_of_file(folder.path() / "steps.csv"))) {
        CHECK(row.at("method") == "comparison");
    }
}

TEST_CASE("a trace is written if the integration fails", "[command][reference]") {
    const temporary_folder folder;
    const auto done = run_libration(
        {"reference", "--problem", "y' = y^2; y(0) = 1", "--time", "2", "--digits", "10", "--trace", "steps.csv"},
        folder.path());
    CHECK(done.exit_code == 1);
    REQUIRE(folder.content().size() == 1);
    CHECK(csv_rows(text_of_file(folder.path() / "steps.csv")).size() > 3);
}

TEST_CASE("an integrator is refused where it has no meaning or is not possible", "[command][reference]") {
    const words decay{"--problem", "y' = -y; y(0) = 1"};
    check_refused(words{"reference", "--integrator", "colocation", "--time", "1"} + decay,
                  {"--integrator", "colocation", "collocation?", "automatic"});
    check_refused(words{"reference", "--integrator", "collocation", "--time", "1", "--digits", "400"} + decay,
                  {"--integrator", "collocation", "1024 bits"});
    check_refused(words{"reference", "--integrator", "comparison", "--time", "1", "--derivatives", "y(0)"} + decay,
                  {"--integrator", "comparison", "derivative of the flow", "automatic or taylor"});
    check_refused(words{"trajectory", "--integrator", "comparison", "--time", "1"} + decay,
                  {"--integrator", "comparison", "ball:D"});
    check_refused({"reference", "--integrator", "taylor", "--energy", "1", "--time", "1"},
                  {"--integrator", "--problem"});
    check_refused({"reference", "--trace", "steps.csv", "--energy", "1", "--time", "1"}, {"--trace", "--problem"});
    check_refused(words{"reference", "--trace", "missing/steps.csv", "--time", "1"} + decay,
                  {"--trace", "missing/steps.csv"});
    check_refused(words{"trajectory", "--integrator", "collocation", "--times", "1", "--energy", "1"},
                  {"--integrator", "--problem"});
}

}  // namespace command_integrator_test
