// `libration series`: a list from a file compared with closed forms: values, Pade and endpoint approximants, errors,
// poles and zeros, files and figures, and errors of the input.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_series_test {

using namespace libration;
using namespace libration::tests;

namespace {

void write_file(const temporary_folder& folder, const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name, std::ios::binary) << text;
}

// 1/n!, n = 0 .. count - 1.
std::string exponential(int count) {
    std::string text;
    integer factorial = 1;
    for (int n = 0; n < count; ++n) {
        factorial *= n == 0 ? 1 : n;
        text += "1/" + factorial.str() + "\n";
    }
    return text;
}

std::vector<table_row> rows_about(const std::string& text, const words& options) {
    const temporary_folder folder;
    write_file(folder, "list.csv", text);
    const auto done =
        run_libration(words{"series", "--coefficients", "list.csv", "--format", "csv"} + options, folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    return csv_rows(done.out);
}

void check_refused(const words& line, const words& mentioned) {
    const temporary_folder folder;
    write_file(folder, "list.csv", exponential(5));
    write_file(folder, "pairs.csv", "time,value\n1,2.718\n");
    tests::check_refused(words{"series"} + line, mentioned, folder);
}

}  // namespace

TEST_CASE("series evaluates a list by its partial sum and by its Pade approximant", "[command][series]") {
    const auto rows = rows_about(exponential(5), {"--times", "0,1,-1/2", "--digits", "20"});
    REQUIRE(rows.size() == 9);
    CHECK(rows[3].at("method") == "series");
    CHECK(rows[3].at("value") == "1.0000000000000000000");
    CHECK(rows[4].at("value") == "2.7083333333333333333");   // 65/24
    CHECK(rows[4].at("uncertainty") == "0.208");             // 1/6 + 1/24
    CHECK(rows[5].at("value") == "0.60677083333333333333");  // 233/384
    CHECK(rows[7].at("method") == "pade");
    CHECK(rows[7].at("value") == "2.7142857142857142857");   // [2/2] of e^t at 1: 19/7
    CHECK(rows[8].at("value") == "0.60655737704918032787");  // at -1/2: (1 - 1/4 + 1/48)/(1 + 1/4 + 1/48) = 37/61
    CHECK(rows[8].at("time") == "-0.5");
    CHECK(rows[8].at("time_typed") == "-1/2");
    CHECK(rows[8].at("order") == "4");
}

TEST_CASE("the verdict comes first, with an uncertainty that holds and without uncertain digits", "[command][series]") {
    const precision_scope scope(60);
    std::string list = "0\n";  // log(1 + t)
    for (int n = 1; n < 21; ++n) {
        list += (n % 2 == 0 ? "-1/" : "1/") + std::to_string(n) + "\n";
    }
    const auto rows = rows_about(list, {"--times", "0,1/2,3,-3", "--reference", "log((1+t)^2)/2"});
    REQUIRE(rows.size() == 12);
    CHECK(rows[0].at("value") == "0");
    CHECK(rows[0].at("uncertainty") == "0");
    for (const std::size_t i : {1U, 2U}) {
        CHECK(rows[i].at("method") == "verdict");
        CHECK(number_of(rows[i].at("error")) <= number_of(rows[i].at("uncertainty")));
        CHECK(number_of(rows[i].at("uncertainty")) < mpfr("1e-18"));
        CHECK_THAT(rows[i].at("methods"), Catch::Contains("pade"));
        CHECK_THAT(rows[i].at("note"), Catch::StartsWith("heuristic"));
    }
    CHECK(rows[3].at("value").empty());
    CHECK(rows[3].at("uncertainty").empty());
    CHECK_THAT(rows[3].at("note"), Catch::StartsWith("no value: the singularity at -1.000"));
    // The partial sum at 3 is far from log 4.
    CHECK(number_of(rows[6].at("error")) <= number_of(rows[6].at("uncertainty")));
}

TEST_CASE("decimals have no more digits than they determine, and --method verdict is alone", "[command][series]") {
    const precision_scope scope(60);
    std::string list;  // 1/(1 - t/3) + 1/(1 + t/2) to five digits
    for (int n = 0; n < 20; ++n) {
        const mpfr a = pow(mpfr(3), -n) + pow(mpfr(-2), -n);
        list += to_decimal(a, 5) + "\n";
    }
    const auto rows = rows_about(list, {"--times", "1,4", "--reference", "3/(3-t)+2/(2+t)", "--method", "verdict"});
    REQUIRE(rows.size() == 2);
    CHECK(number_of(rows[0].at("error")) <= number_of(rows[0].at("uncertainty")));
    CHECK(rows[0].at("value").size() <= 7);
    CHECK(rows[1].at("value").empty());  // beyond the pole at 3
    // The other methods state what the rounding of the coefficients does to them.
    const auto others = rows_about(list, {"--times", "1,2", "--reference", "3/(3-t)+2/(2+t)"});
    for (const auto& row : others) {
        INFO(row.at("method") << " at " << row.at("time"));
        CHECK((row.at("uncertainty").empty() || number_of(row.at("error")) <= number_of(row.at("uncertainty"))));
    }
}

TEST_CASE("series takes decimals as exact or as rounded if told so", "[command][series]") {
    // (1 - t/2)^-1 at 1: 2. Its coefficients are decimals, exact ones.
    std::string halves;
    for (int n = 0; n < 25; ++n) {
        halves += to_decimal(ldexp(mpfr(1), -n), 30) + "\n";
    }
    const auto value = [&](const words& how) {
        return rows_about(halves, words{"--times", "1", "--method", "verdict", "--digits", "40"} + how).front();
    };
    const precision_scope scope(60);
    const auto uncertainty = [](const table_row& row) { return mpfr(row.at("uncertainty")); };
    CHECK(uncertainty(value({"--exact"})) < uncertainty(value({"--rounded", "8"})));
    CHECK(uncertainty(value({"--rounded", "8"})) > mpfr(1) / pow(mpfr(10), 9));
    CHECK(abs(mpfr(mpfr(value({"--rounded", "8"}).at("value")) - 2)) <= uncertainty(value({"--rounded", "8"})));
    check_refused({"--coefficients", "list.csv", "--exact", "--rounded", "8"}, {"--exact", "--rounded 8"});
    check_refused({"--coefficients", "list.csv", "--rounded", "none"}, {"--rounded", "none", "1 to 1000"});
}

TEST_CASE("an endpoint approximant reproduces the polynomial of degree N + m", "[command][series]") {
    // 1 + 2t - t^4 from a_0, a_1, a_2 and its value, first and second derivative at 3.
    const auto rows = rows_about("1\n2\n0\n", {"--method", "endpoint", "--endpoint", "3", "--endpoint-values",
                                               "-74,-106,-108", "--times", "1,5/2"});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("value") == "2.0000000000000000000");
    CHECK(rows[1].at("value") == "-33.062500000000000000");
}

TEST_CASE("errors are those against a value, a file and a formula", "[command][series]") {
    const precision_scope scope(60);
    const mpfr truth = exp(mpfr(1)) - mpfr(65) / 24;
    const auto by_formula =
        rows_about(exponential(5), {"--times", "1,2", "--reference", "exp(t)", "--method", "series"}).at(0);
    CHECK(abs(number_of(by_formula.at("error")) / truth - 1) < mpfr("1e-5"));
    CHECK(by_formula.at("reference").starts_with("2.718281828459045235"));
    const auto by_value =
        rows_about(exponential(5), {"--times", "1", "--reference", "2.75", "--method", "series"}).at(0);
    CHECK(abs(number_of(by_value.at("error")) * 24 - 1) < mpfr("1e-5"));  // 2.75 - 65/24 = 1/24
    const temporary_folder folder;
    write_file(folder, "list.csv", exponential(5));
    write_file(folder, "known.csv", "time,value\n0.5,1.6487\n1,2.75\n");
    const auto done = run_libration({"series", "--coefficients", "list.csv", "--times", "1", "--reference", "known.csv",
                                     "--method", "series", "--format", "csv"},
                                    folder.path());
    CHECK(csv_rows(done.out).at(0).at("error") == by_value.at("error"));
}

TEST_CASE("without times the poles and zeros of the Pade approximant are printed", "[command][series]") {
    // (1 - x/5)/((1 - x/2)(1 + x^2/9)): poles at 2 and 3i, a zero at 5.
    std::string list;
    std::vector<rational> a;
    for (int n = 0; n < 20; ++n) {
        rational next = n == 0 ? rational(1) : n == 1 ? rational(-1, 5) : rational(0);
        next += n > 0 ? rational(a[static_cast<std::size_t>(n - 1)] / 2) : rational(0);
        next -= n > 1 ? rational(a[static_cast<std::size_t>(n - 2)] / 9) : rational(0);
        next += n > 2 ? rational(a[static_cast<std::size_t>(n - 3)] / 18) : rational(0);
        a.push_back(next);
        list += next.str() + "\n";
    }
    const auto rows = rows_about(list, {"--digits", "15"});
    const precision_scope scope(40);
    REQUIRE(rows.size() >= 3);
    CHECK(rows[0].at("kind") == "pole");
    CHECK(abs(number_of(rows[0].at("position_re")) - 2) < mpfr("1e-13"));
    CHECK(rows[1].at("kind") == "pole");
    CHECK(abs(number_of(rows[1].at("position_im")) - 3) < mpfr("1e-13"));
    CHECK(rows[2].at("kind") == "zero");
    CHECK(abs(number_of(rows[2].at("position_re")) - 5) < mpfr("1e-13"));
}

TEST_CASE("series --out writes the tables and draws the figures", "[command][series]") {
    const temporary_folder folder;
    write_file(folder, "list.csv", exponential(9));
    const auto done = run_libration({"series", "--coefficients", "list.csv", "--times", "1,2", "--reference", "exp(t)",
                                     "--out", "mine", "--format", "csv"},
                                    folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    for (const std::string name : {"values.csv", "errors.csv", "poles.csv", "ratios.csv", "radius.csv", "errors.svg",
                                   "errors.png", "poles.svg", "domb_sykes.svg", "roots.png"}) {
        INFO(name);
        CHECK(std::filesystem::exists(folder.path() / "mine" / name));
    }
    std::ifstream file(folder.path() / "mine" / "ratios.csv");
    const std::string csv((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const auto ratios = csv_rows(csv);
    REQUIRE(ratios.size() == 8);
    CHECK(ratios[3].at("n") == "4");
    CHECK(ratios[3].at("ratio").starts_with("0.25"));
    CHECK(ratios[0].at("root").starts_with("1.0"));
}

TEST_CASE("series draws an odd list in t^2, and where it is 0 at 0", "[command][series]") {
    const temporary_folder folder;
    // arctan t: its approximants are 0 at t = 0, as the sum is.
    std::string list;
    for (int n = 0; n < 12; ++n) {
        list += (n % 2 == 0 ? "0" : (n % 4 == 1 ? "1/" : "-1/") + std::to_string(n)) + "\n";
    }
    write_file(folder, "list.csv", list);
    const auto done = run_libration({"series", "--coefficients", "list.csv", "--times", "0,1/2", "--reference",
                                     "atan(t)", "--out", "mine", "--format", "csv"},
                                    folder.path());
    INFO(done.err);
    REQUIRE(done.exit_code == 0);
    CHECK(done.err.find("Warning") == std::string::npos);
    for (const std::string name : {"errors.svg", "poles.svg", "roots.svg", "domb_sykes.svg"}) {
        INFO(name);
        CHECK(std::filesystem::exists(folder.path() / "mine" / name));
    }
    std::ifstream file(folder.path() / "mine" / "ratios.csv");
    const auto ratios = csv_rows({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
    REQUIRE(ratios.size() == 11);
    CHECK(ratios[4].at("n") == "5");
    CHECK(ratios[4].at("ratio").empty());
    CHECK(ratios[4].at("power") == "2");
    CHECK(ratios[4].at("ratio_in_power").starts_with("-0.6000"));  // (1/5)/(-1/3)
    CHECK(ratios[3].at("ratio_in_power").empty());
}

TEST_CASE("series refuses what it cannot evaluate or compare", "[command][series][bad input]") {
    const words list{"--coefficients", "list.csv"};
    check_refused({"--coefficients", "missing.csv"}, {"--coefficients 'missing.csv'"});
    check_refused(list + words{"--method", "euler"}, {"--method 'euler'", "write verdict"});
    check_refused(list + words{"--method", "endpoint", "--times", "1"}, {"--endpoint"});
    check_refused(list + words{"--endpoint", "1"}, {"--endpoint-values"});
    check_refused(list + words{"--endpoint", "0", "--endpoint-values", "1"}, {"--endpoint '0'"});
    check_refused(list + words{"--reference", "1"}, {"--times"});
    check_refused(list + words{"--times", "1", "--reference", "exp("}, {"--reference 'exp('", "formula in t"});
    check_refused(list + words{"--times", "2", "--reference", "pairs.csv"}, {"has no row of the time '2'"});
    check_refused(list + words{"--order", "9"}, {"--order '9'", "is 4"});
    check_refused(list + words{"--format", "xml"}, {"--format 'xml'"});
    check_refused(list + words{"--times", "1,,2"}, {"--times"});
}

}  // namespace command_series_test
