// The figures of --plot: their files, what is drawn in them, the table that remains, and errors of the input.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"
#include "libration/series/power_series.hpp"
#include "plot/figure_file.hpp"
#include "problem/coefficient_tables.hpp"

namespace command_plot_test {

using namespace libration;
using namespace libration::tests;

namespace {

const std::string circle = "x' = y; y' = -x; x(0) = 1; y(0) = 0";

std::string svg_of(const words& line) {
    const temporary_folder folder;
    const auto done = run_libration(line + words{"--out", "drawn.svg"}, folder.path());
    INFO(command_line(line) << "\n" << done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(done.err.find("arning") == std::string::npos);
    return text_of_file(folder.path() / "drawn.svg");
}

bool shows(const std::string& svg, const std::string& text) { return svg.find(text) != std::string::npos; }

void write_list(const temporary_folder& folder, const std::string& text) {
    std::ofstream(folder.path() / "list.csv", std::ios::binary) << text;
}

}  // namespace

TEST_CASE("a figure is of the kind of its ending, and of all three without one", "[command][plot]") {
    const temporary_folder folder;
    const words line{"trajectory", "--problem", circle, "--times", "0:6:13", "--scalar", "double", "--plot", "x,y"};
    const auto one = run_libration(line + words{"--out", "one.png"}, folder.path());
    CHECK(one.err == "libration: wrote one.png\n");
    CHECK(one.out == run_libration(words(line.begin(), line.end() - 2), folder.path()).out);
    CHECK(std::filesystem::exists(folder.path() / "one.png"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "one.svg"));
    const auto three = run_libration(line + words{"--out", "three"}, folder.path());
    CHECK(three.exit_code == 0);
    for (const std::string kind : {"svg", "pdf", "png"}) {
        CHECK(std::filesystem::exists(folder.path() / ("three." + kind)));
    }
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 4);
}

TEST_CASE("a time series, a phase plane and a family show their quantities", "[command][plot]") {
    const auto series = svg_of({"trajectory", "--problem", circle, "--times", "0:6:61", "--plot", "t,x,y"});
    CHECK(shows(series, "time t"));
    CHECK_FALSE(shows(series, ">start<"));
    const auto plane =
        svg_of({"reference", "--problem", circle, "--times", "0:6:7", "--digits", "10", "--plot", "x,y"});
    CHECK(shows(plane, ">start<"));
    const auto family = svg_of({"trajectory", "--problem", "y' = k*y; y(0) = 1", "--set", "k=-1,1/2", "--times",
                                "0:1:11", "--plot", "time,y"});
    CHECK(shows(family, "k = -1"));
    CHECK(shows(family, "k = 1/2"));
    CHECK(shows(svg_of({"trajectory", "--energy", "1.71", "--times", "0:5:21", "--plot", "theta,omega"}), "θ"));
}

TEST_CASE("events are marked on the curve up to the last of them", "[command][plot]") {
    const auto svg = svg_of({"reference", "--problem", "x'' = -x; x(0) = 1; x'(0) = 0", "--until", "x = 0", "--count",
                             "3", "--digits", "10", "--plot", "t,x"});
    CHECK(shows(svg, "x = 0"));
}

TEST_CASE("the solutions of a family follow each other in one table", "[command][plot]") {
    for (const std::string command : {"trajectory", "reference"}) {
        const auto rows = rows_of({command, "--problem", "y' = k*y + c", "--set", "k=1,2", "--set", "y(0)=0:1:2",
                                   "--set", "c=0", "--times", "0,1", "--digits", "10"});
        REQUIRE(rows.size() == 8);
        CHECK(rows[3].at("k") == "1");
        CHECK(rows[3].at("y(0)") == "1");
        CHECK(rows[3].at("y") == "2.718281828");
        CHECK(rows[7].at("k") == "2");
        CHECK(rows[7].at("y") == "7.389056099");
    }
}

TEST_CASE("radius --plot draws the form of Domb and Sykes, or of Mercer and Roberts for a pair", "[command][plot]") {
    const auto single = svg_of({"radius", "--problem", "y' = y^2; y(0) = 1", "--order", "40", "--plot"});
    CHECK(shows(single, "Domb-Sykes"));
    CHECK(shows(single, "exponent −1"));
    CHECK(shows(single, "|t| = R"));
    const auto pair = svg_of({"radius", "--problem", "y' = -2*t*y^2 + y^2; y(0) = 1/2", "--order", "60", "--plot"});
    CHECK(shows(pair, "Mercer-Roberts"));
    const temporary_folder folder;
    std::string list;
    for (int n = 1; n < 40; ++n) {
        list += "1/" + std::to_string(n) + "\n";
    }
    write_list(folder, list);
    const auto done =
        run_libration({"radius", "--coefficients", "list.csv", "--plot", "--out", "mine.svg"}, folder.path());
    CHECK(done.exit_code == 0);
    CHECK(shows(done.out, "heuristic estimate"));
    CHECK(shows(text_of_file(folder.path() / "mine.svg"), "Padé"));
}

TEST_CASE("singularities --plot draws each kind and the circle", "[command][plot]") {
    const auto svg = svg_of({"singularities", "--problem", "x' = 1 + x^2; x(0) = 0", "--plot"});
    CHECK(shows(svg, "pole of order 1"));
    CHECK(shows(svg, "radius 1.5708"));
}

TEST_CASE("what cannot be drawn is refused before anything is computed", "[command][plot]") {
    const words values{"trajectory", "--problem", circle, "--times", "0:1:3"};
    check_refused(values + words{"--plot", "x,y"}, {"--plot", "--out"});
    check_refused(values + words{"--plot", "x,y", "--out", "drawn.jpg"}, {"--out", "'drawn.jpg'", ".svg"});
    check_refused(values + words{"--plot", "x,y", "--out", "no/such/folder.svg"}, {"--out", "no/such"});
    check_refused(values + words{"--plot", "x", "--out", "drawn.svg"}, {"--plot", "'x'"});
    check_refused(values + words{"--plot", "x,z", "--out", "drawn.svg"}, {"--plot", "'z'", "x", "y"});
    check_refused(values + words{"--set", "x(0)=0:1", "--plot", "x,y", "--out", "drawn.svg"}, {"--set", "'x(0)=0:1'"});
    check_refused({"radius", "--problem", "y' = y^2; y(0) = 1", "--plot", "--prove", "--out", "a.svg"}, {"--plot"});
    check_refused(
        {"radius", "--problem", "y' = y^2; y(0) = 1", "--at", "i", "--order", "20", "--plot", "--out", "a.svg"},
        {"--plot", "complex"});
}

TEST_CASE("names of equations are text of a figure", "[command][plot]") {
    CHECK(name_in_figure("x''") == "x′′");
    CHECK(name_in_figure("x_12") == "x_{12}");
    CHECK(name_in_figure("x_1'") == "x_{1}′");
    CHECK(name_in_figure("theta") == "θ");
    CHECK(name_in_figure("thetas") == "thetas");
    CHECK(name_in_figure("a_b_c") == "a_{b c}");
    CHECK(name_in_figure("y(0)") == "y(0)");
    CHECK(text_in_figure("x^2 = a_1") == "x\\^2 = a\\_1");
    CHECK(words_for_script({"k = 1", "x"}) == "\"k = 1\" \"x\"");
}

// 1/(1 - 2 c t + t^2) has the coefficients U_n(c) of Chebyshev, with U_{n+1} U_{n-1} - U_n^2 = -1.
TEST_CASE("the generalised ratios of a pair of simple poles are 1/R", "[command][plot]") {
    const precision_scope scope(40);
    std::vector<mpfr> chebyshev{mpfr(1), mpfr(1)};  // c = 1/2
    for (std::size_t n = 2; n < 20; ++n) {
        chebyshev.push_back(mpfr(chebyshev[n - 1] - chebyshev[n - 2]));
    }
    const table data = ratios_of(series::power_series<mpfr>(std::move(chebyshev)), 10);
    REQUIRE(data.columns().back().name == "pair_ratio");
    CHECK(data.rows()[0].back().is_empty());  // n = 1: a_(n-2) does not exist
    CHECK(data.rows()[1].back().text() == "1.000000000");
    CHECK(data.rows()[17].back().text() == "1.000000000");
    CHECK(data.rows()[18].back().is_empty());
}

}  // namespace command_plot_test
