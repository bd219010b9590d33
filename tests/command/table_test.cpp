// `libration table`: its values compared with the reference tables of mpmath, its condition numbers with derivatives by
// mpmath, and its files as read by their users: a compiler, a reader of columns, and `libration verify`.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/reference_motion.hpp"
#include "command/refusal.hpp"

namespace command_table_test {

using namespace libration;
using namespace libration::tests;

namespace {

std::vector<table_row> table_of(words line) {
    line.insert(line.begin(), "table");
    return csv_rows(output_of(line));
}

void check_refused(const words& line, const std::string& mentioned) {
    tests::check_refused(words{"table"} + line, {mentioned});
}

// A table as NumPy reads it: the names of its last comment, and rows with that many numbers.
std::vector<table_row> numpy_rows(const std::string& text) {
    words names;
    std::vector<table_row> rows;
    for (const std::string& line : lines_of(text)) {
        std::istringstream cells(line);
        words row;
        for (std::string cell; cells >> cell;) {
            row.push_back(cell);
        }
        if (line.starts_with('#')) {
            names.assign(row.begin() + 1, row.end());
            continue;
        }
        REQUIRE(row.size() == names.size());
        table_row named;
        for (std::size_t i = 0; i < row.size(); ++i) {
            char* end = nullptr;
            std::strtod(row[i].c_str(), &end);
            CHECK(*end == '\0');
            named[names[i]] = row[i];
        }
        rows.push_back(std::move(named));
    }
    return rows;
}

// Compiles FOLDER/main.cpp with the compiler of the tests and its warnings, and returns the output of the program.
std::string compiled_and_run(const std::filesystem::path& folder, const std::string& program) {
    std::ofstream(folder / "main.cpp") << program;
    const std::string in_folder = "cd '" + folder.string() + "' && ";
    const std::string compile = std::string("'") + LIBRATION_COMPILER +
                                "' -idirafter '" LIBRATION_BOOST
                                "' -std=c++17 -Wall -Wextra -Wpedantic -Werror main.cpp -o main > log 2>&1";
    const int status = std::system((in_folder + compile).c_str());
    INFO(text_of_file(folder / "log"));
    REQUIRE(status == 0);
    REQUIRE(std::system((in_folder + "./main > printed").c_str()) == 0);
    return text_of_file(folder / "printed");
}

const words near_the_top{"pendulum", "--gaps=1e-3,-1e-30", "--times", "1,T/8"};

}  // namespace

TEST_CASE("tables of motions have the digits of the reference table", "[command][table]") {
    std::size_t states = 0;
    for (const reference_motion& motion : reference_motions()) {
        INFO(command_line(motion.options));
        const auto rows = table_of(words{"pendulum"} + motion.options + words{motion.times()});
        REQUIRE(rows.size() == motion.rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            INFO("time " << rows[i].at("time"));
            for (const std::string name : {"theta", "omega", "period", "tstar", "radius"}) {
                if (!motion.rows[i].at(name).empty()) {
                    CHECK_THAT(rows[i].at(name), right_to_the_last_digit(motion.rows[i].at(name)));
                }
            }
            CHECK((rows[i].at("rigour") == "proved" && rows[i].at("digits") == "50"));
            ++states;
        }
    }
    CHECK(states > 200);
}

TEST_CASE("a grid is every motion at every time, in the order in which they were typed", "[command][table]") {
    words seen;
    for (const table_row& row :
         table_of({"pendulum", "--energies", "3,1.71", "--gaps", "1e-1:1e-3:3log", "--times", "0:T/4:2,1/3"})) {
        seen.push_back(row.at("energy") + " " + row.at("gap") + " " + row.at("time_typed"));
    }
    CHECK(seen == words{"3 -1 0", "3 -1 0.25T", "3 -1 1/3", "1.71 0.29 0", "1.71 0.29 0.25T", "1.71 0.29 1/3",
                        "1.9 1e-1 0", "1.9 1e-1 0.25T", "1.9 1e-1 1/3", "1.99 0.01 0", "1.99 0.01 0.25T",
                        "1.99 0.01 1/3", "1.999 1e-3 0", "1.999 1e-3 0.25T", "1.999 1e-3 1/3"});
}

TEST_CASE("columns of a table are there where they were asked for", "[command][table]") {
    const auto header = [](const words& line) { return lines_of(output_of(words{"table"} + line)).front(); };
    const std::string rest =
        "time,theta,omega,period,tstar,radius,condition,digits,rigour,time_typed,energy_typed,gap_typed";
    CHECK(header({"pendulum", "--energies", "1", "--times", "0"}) == "energy,gap," + rest);
    CHECK(header({"pendulum", "--energies", "3", "--direction", "-", "--times", "0"}) ==
          "energy,gap,direction," + rest);
    CHECK(header({"pendulum", "--gaps", "0.5", "--theta0", "1", "--times", "0"}) ==
          "energy,gap,theta0," + rest + ",theta0_typed");
    CHECK(header({"pendulum", "--theta0", "60deg", "--omega0", "0", "--times", "0"}) ==
          "energy,gap,theta0,omega0," + rest + ",theta0_typed,omega0_typed");
    CHECK(header({"sn", "--u", "1", "--m1", "0.5"}) == "function,argument,m1,value,condition,digits,rigour");
}

TEST_CASE("from rest, theta is exactly 0 after a quarter of the period and the release angle after half of it",
          "[command][table]") {
    const auto rows = table_of(
        {"pendulum", "--theta0", "30deg,60deg,90deg,120deg,150deg", "--omega0", "0", "--times", "T/4,3T/4,T/2,T"});
    REQUIRE(rows.size() == 20);
    const precision_scope scope(100);
    for (std::size_t i = 0; i < rows.size(); i += 4) {
        const mpfr angle = pi<mpfr>() * static_cast<int>(i / 4 + 1) / 6;
        CHECK((rows[i].at("theta") == "0" && rows[i + 1].at("theta") == "0"));
        CHECK_THAT(rows[i + 2].at("theta"), right_to_the_last_digit_of(-angle));
        CHECK_THAT(rows[i + 3].at("theta"), right_to_the_last_digit_of(angle));
        CHECK((rows[i + 2].at("omega") == "0" && rows[i + 3].at("omega") == "0"));
    }
    // The period from 90 degrees is Gamma(1/4)^2/sqrt(pi), from 150 it is sqrt(3) times that from 30.
    using boost::multiprecision::tgamma;
    const mpfr root = tgamma(mpfr(mpfr(1) / 4));
    CHECK_THAT(rows[8].at("period"), right_to_the_last_digit_of(root * root / sqrt(pi<mpfr>())));
    const auto precise =
        table_of({"pendulum", "--theta0", "30deg,150deg", "--omega0", "0", "--times", "0", "--digits", "80"});
    CHECK_THAT(rows[16].at("period"), right_to_the_last_digit_of(sqrt(mpfr(3)) * number_of(precise[0].at("period"))));
}

TEST_CASE("tables of functions have the digits of mpmath", "[command][table]") {
    // mpmath, mp.dps = 120, m = 1 - mpf('1e-30'): sn = ellipfun('sn', u, m=m), am(1.5) = asin(sn(1.5)), ellipk(m),
    // ellipf(1.5, m).
    const auto jacobi = table_of({"am,sn,cn,dn", "--u", "1.5,40", "--m1", "1e-30"});
    REQUIRE(jacobi.size() == 8);
    CHECK_THAT(jacobi[0].at("value"),
               right_to_the_last_digit("1.13172834525050909374296939069601703268288911115997434443763"));
    CHECK_THAT(jacobi[1].at("value"),
               right_to_the_last_digit("0.905148253644866438242303696456654119301455983569368334445685"));
    CHECK_THAT(jacobi[6].at("value"),
               right_to_the_last_digit("-2.94146616461169149979968303674214728300497182284077959913104e-14"));
    CHECK_THAT(jacobi[7].at("value"),
               right_to_the_last_digit("2.94316550631380813539781473065420437116017569194193996522435e-14"));
    const auto complete = table_of({"K", "--m1", "1e-30,0"});
    CHECK_THAT(complete[0].at("value"),
               right_to_the_last_digit("35.9250707560305758791043360631905475178565302421218812327571"));
    CHECK((complete[0].at("argument").empty() && complete[1].at("value") == "inf"));
    CHECK_THAT(table_of({"F", "--phi", "1.5", "--m1", "1e-30"})[0].at("value"),
               right_to_the_last_digit("3.34067754279831100332081266898868657537007845874054920924997"));
}

TEST_CASE("condition numbers are those of the derivatives by mpmath", "[command][table]") {
    // mpmath, mp.dps = 60, with f_u = diff(lambda v: f(v, x), u) and so on: (|u f_u| + |x f_x|)/|f| for the functions,
    // divided by max(1, |theta|) for theta = 2 asin(k cd(t, k)). They are printed with three digits.
    const auto condition = [](const words& line) {
        const precision_scope scope(20);
        return number_of(table_of(line).front().at("condition")).convert_to<double>();
    };
    const auto three_digits = [](double value) { return Catch::WithinRel(value, 0.006); };
    CHECK_THAT(condition({"sn", "--u", "1.5", "--m", "0.5"}), three_digits(0.330436));
    CHECK_THAT(condition({"cn", "--u", "1.5", "--k", "0.8"}), three_digits(4.59248));
    CHECK_THAT(condition({"am", "--u", "1.5", "--m", "0.5"}), three_digits(0.969997));
    CHECK_THAT(condition({"F", "--phi", "1", "--m1", "0.1"}), three_digits(1.42599));
    CHECK_THAT(condition({"K", "--m1", "0.1"}), three_digits(0.182513));
    // K = ln(4/k') as m1 vanishes: m1 K'(m1) = -1/2.
    CHECK_THAT(condition({"K", "--m1", "1e-20"}), three_digits(0.0204816));
    CHECK_THAT(condition({"pendulum", "--gaps", "0.29", "--times", "1"}), three_digits(0.671919));
    CHECK_THAT(condition({"pendulum", "--energies", "1.71", "--times", "1"}), three_digits(2.04096));
    // So fast that it rotates uniformly: theta = pi + omega t and omega = sqrt(2E), with half of the condition of omega
    // from E.
    CHECK_THAT(condition({"pendulum", "--energies", "1e300", "--times", "1"}), three_digits(1.5));
    // The circle: |u cos u/sin u|, and a number that is 0 counts as exact.
    CHECK_THAT(condition({"sn", "--u", "0.5", "--m", "0"}), three_digits(0.5 / std::tan(0.5)));
    CHECK(table_of({"cn", "--u", "pi/2", "--m", "0"})[0].at("condition") == "inf");
    CHECK(table_of({"am", "--u", "0", "--m", "0.3"})[0].at("condition") == "0");
}

TEST_CASE("verify finds every row of a table right and prints the same condition", "[command][table]") {
    const temporary_folder folder;
    for (const words& grid :
         {words{"pendulum", "--gaps=0.5,1e-10,-1e-10,-2", "--times", "0.5,T/8,T/4,50"},
          words{"pendulum", "--theta0", "60deg,2.5", "--omega0=-0.3,0", "--times", "1,T/3,1e10", "--digits", "25"},
          words{"pendulum", "--energies", "3", "--theta0", "1,-1", "--direction", "-", "--times", "2"}}) {
        const std::string csv = output_of(words{"table"} + grid);
        std::ofstream(folder.path() / "table.csv") << csv;
        const finished_process done = run_libration({"verify", "table.csv"}, folder.path());
        INFO(command_line(grid) << "\n" << done.out << done.err);
        CHECK(done.exit_code == 0);
        // verify adds a column condition after the table's; by name the last one is found.
        const auto rows = csv_rows(csv);
        const auto judged = csv_rows(done.out);
        REQUIRE(rows.size() == judged.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            CHECK(rows[i].at("condition") == judged[i].at("condition"));
        }
    }
}

TEST_CASE("JSON holds the cells of the CSV as strings, absent ones as null", "[command][table]") {
    const words line = words{"table"} + near_the_top;
    const auto rows = csv_rows(output_of(line));
    const auto json = nlohmann::json::parse(output_of(line + words{"--format", "json"}));
    REQUIRE(json.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        REQUIRE(json[i].size() == rows[i].size());
        for (const auto& [name, text] : rows[i]) {
            INFO(name);
            CHECK(json[i].at(name) == (text.empty() ? nlohmann::json() : nlohmann::json(text)));
        }
    }
}

TEST_CASE("text for NumPy holds numbers only, times and angles among them", "[command][table]") {
    const words line = words{"table"} + near_the_top;
    const auto typed = csv_rows(output_of(line));
    const auto rows = numpy_rows(output_of(line + words{"--format", "numpy"}));
    REQUIRE(rows.size() == typed.size());
    const precision_scope scope(100);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const std::string name : {"theta", "omega", "period", "tstar", "radius", "condition"}) {
            CHECK(rows[i].at(name) == typed[i].at(name));
        }
        CHECK(number_of(rows[i].at("gap")) == number_of(typed[i].at("gap")));
    }
    // T/8 with ten digits more than the period has: to one unit of the period's last digit.
    const mpfr eighth = number_of(rows[1].at("period")) / 8;
    CHECK(abs(number_of(rows[1].at("time")) - eighth) < last_place(rows[1].at("period")));
    CHECK(significant_digits(rows[1].at("time")) == 60);
    const auto angles = numpy_rows(output_of(
        {"table", "pendulum", "--theta0", "60deg", "--omega0", "1/3", "--times", "1/3", "--format", "numpy"}));
    CHECK_THAT(angles[0].at("theta0"), right_to_the_last_digit_of(pi<mpfr>() / 3));
    CHECK_THAT(angles[0].at("omega0"), right_to_the_last_digit_of(mpfr(1) / 3));
    const auto wide = numpy_rows(
        output_of({"table", "sn,cn", "--u", "0.5,1", "--m1", "1e-30", "--format", "numpy", "--digits", "20"}));
    REQUIRE(wide.size() == 2);
    CHECK(wide[1].at("cn") == table_of({"cn", "--u", "1", "--m1", "1e-30", "--digits", "20"})[0].at("value"));
}

TEST_CASE("the C++ header and the .ipp compile without a warning and hold the digits of the CSV", "[command][table]") {
    const temporary_folder folder;
    const words line = words{"table"} + near_the_top + words{"--digits", "20"};
    for (const auto& [format, file] : {std::pair{"cpp", "values.hpp"}, std::pair{"ipp", "values.ipp"}}) {
        REQUIRE(
            run_libration(line + words{"--format", format, "--name", std::string("values_") + format, "--out", file},
                          folder.path())
                .exit_code == 0);
    }
    CHECK(folder.content() == words{"values.hpp", "values.ipp"});
    // The function that Boost.Math's table_type.hpp provides for a built-in type is defined in one line here.
    const std::string printed = compiled_and_run(folder.path(), R"(#include "values.hpp"
#include "values.hpp"
#include <array>
#include <boost/config.hpp>
#include <cstdio>
template <class T> struct table_type { using type = T; };
template <class T> void print_ipp() {
#include "values.ipp"
    for (const auto& row : values_ipp) std::printf("%.17Lg %.17Lg\n", row[1], row[3]);
}
int main() {
    static_assert(values_cpp.size() == 4);
    for (const values_cpp_row& row : values_cpp) std::printf("%s %s\n", row.gap, row.theta);
    print_ipp<long double>();
})");
    const auto rows = csv_rows(output_of(line));
    const auto lines = lines_of(printed);
    REQUIRE(lines.size() == 8);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const precision_scope scope(30);
        CHECK(lines[i].ends_with(" " + rows[i].at("theta")));
        CHECK(number_of(lines[i].substr(0, lines[i].find(' '))) == number_of(rows[i].at("gap")));
        const std::string binary = lines[4 + i].substr(lines[4 + i].find(' ') + 1);
        // 17 digits of a long double, which holds 19.
        CHECK(abs(number_of(binary) - number_of(rows[i].at("theta"))) <= last_place(binary));
    }
}

TEST_CASE("provenance stands in the comments of a table, or in a file beside it", "[command][table]") {
    const temporary_folder folder;
    const words line = words{"table"} + near_the_top + words{"--digits", "20"};
    const std::string said = "libration table pendulum --gaps 1e-3,-1e-30 --times 1,T/8 --digits 20 --format ";
    REQUIRE(run_libration(line + words{"--out", "a.csv", "--jobs", "1"}, folder.path()).exit_code == 0);
    CHECK(folder.content() == words{"a.csv", "a.provenance.json"});
    CHECK(text_of_file(folder.path() / "a.csv") == output_of(line + words{"--jobs", "2"}));
    const auto json = nlohmann::json::parse(text_of_file(folder.path() / "a.provenance.json"));
    CHECK(json.at("command") == said + "csv");
    CHECK(json.at("rigour") == "proved to one unit in the last place");
    CHECK(json.at("made with").contains("commit"));
    for (const std::string format : {"cpp", "ipp", "numpy"}) {
        const std::string text = output_of(line + words{"--format", format});
        INFO(text);
        for (const std::string& part : {said + format, std::string("proved to one unit"), std::string("commit "),
                                        std::string("MPFR "), std::string("heuristic")}) {
            CHECK(text.find(part) != std::string::npos);
        }
    }
}

TEST_CASE("infinite values are inf in a table, and no .ipp", "[command][table]") {
    const words critical{"pendulum", "--energies", "2", "--times", "1"};
    const table_row row = table_of(critical).front();
    CHECK((row.at("period") == "inf" && row.at("tstar") == "inf"));
    const precision_scope scope(100);
    CHECK_THAT(row.at("theta"), right_to_the_last_digit_of(atan(sinh(mpfr(1))) * 2));
    CHECK(output_of(words{"table"} + critical + words{"--format", "cpp"}).find("\"inf\"") != std::string::npos);
    CHECK(numpy_rows(output_of(words{"table"} + critical + words{"--format", "numpy"}))[0].at("period") == "inf");
    check_refused(critical + words{"--format", "ipp"}, "--format 'ipp' cannot hold the infinite period");
}

TEST_CASE("each row of a file of points is asked alone", "[command][table]") {
    const temporary_folder folder;
    const auto of_file = [&](const std::string& what, const std::string& csv, const words& more = {}) {
        std::ofstream(folder.path() / "p.csv", std::ios::binary) << csv;
        const auto done = run_libration(words{"table", what, "--points", "p.csv"} + more, folder.path());
        INFO(done.err);
        REQUIRE(done.exit_code == 0);
        return done.out;
    };
    const auto motions =
        csv_rows(of_file("pendulum", "t,energy,theta0,omega0\n1,,2.5,-0.3\n5,3,,\n7,3,,\nT/8,1.71,0.5,\n"));
    const std::vector<words> alone{{"--theta0", "2.5", "--omega0", "-0.3", "--times", "1"},
                                   {"--energies", "3", "--times", "5"},
                                   {"--energies", "3", "--times", "7"},
                                   {"--energies", "1.71", "--theta0", "0.5", "--times", "T/8"}};
    REQUIRE(motions.size() == 4);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const table_row single = table_of(words{"pendulum"} + alone[i]).at(0);
        for (const auto& [name, value] : single) {
            INFO(i << " " << name);
            CHECK(motions[i].at(name) == value);
        }
    }
    const auto functions = csv_rows(of_file("sn,cd", "u,m1\n0.7,0.7\n40,1e-30\n-1,3\n"));
    REQUIRE(functions.size() == 6);
    CHECK(functions[0] == table_of({"sn,cd", "--u", "0.7", "--m1", "0.7"}).at(0));
    CHECK(functions[3] == table_of({"sn,cd", "--u", "40", "--m1", "1e-30"}).at(1));
    CHECK(functions[4] == table_of({"sn", "--u=-1", "--m1", "3"}).at(0));
    const auto third = csv_rows(of_file("Pi", "phi,nu,k\n1,0.5,0.8\n2,-1,0.1\n", {"--columns", "nu=n"}));
    CHECK(third.at(1) == table_of({"Pi", "--phi", "2", "--n=-1", "--k", "0.1"}).at(0));
    const auto numbers = numpy_rows(of_file("K", "m\n0.3\n-3\n", {"--format", "numpy"}));
    CHECK_THAT(numbers.at(1).at("K"), right_to_the_last_digit("1.078257823749821617719337499400161014432"));
    CHECK(of_file("K", "m\n0.3\n", {"--format", "cpp"}).find("table K --points p.csv --digits 50") !=
          std::string::npos);
    // verify accepts it: every number is correct.
    std::ofstream(folder.path() / "t.txt") << of_file("am,dn", "u,m\n1,0.5\n2,-7\n", {"--format", "numpy"});
    CHECK(run_libration({"verify", "t.txt"}, folder.path()).exit_code == 0);
}

TEST_CASE("tables take complex arguments, typed and from a file", "[command][table]") {
    // mpmath, mp.dps = 45: ellipfun('sn', mpc('0.7', '1.2'), m=mpf(m)), 'dc'.
    const std::string sn_re = "1.28667283558101798180149601441822329971371";
    const std::string sn_im = "0.928044558960483512883160300913089008960405";
    const std::string dc_re = "0.616977230258932568230426348525898443775347";
    const std::string dc_im = "0.23578743461077345982139872203072922884816";
    const auto rows = table_of({"sn,dc", "--u", "0.7+1.2i,0.7", "--m", "0.3", "--digits", "36"});
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].at("argument") == "0.7+1.2i");
    CHECK_THAT(rows[0].at("value"), right_to_the_last_digit(sn_re));
    CHECK_THAT(rows[0].at("imaginary"), right_to_the_last_digit(sn_im));
    CHECK_THAT(rows[1].at("value"), right_to_the_last_digit(dc_re));
    CHECK_THAT(rows[1].at("imaginary"), right_to_the_last_digit(dc_im));
    CHECK((rows[2].at("argument") == "0.7" && rows[2].at("imaginary") == "0"));
    CHECK(table_of({"sn", "--u", "0.7", "--m", "0.3"}).at(0).count("imaginary") == 0);

    const temporary_folder folder;
    std::ofstream(folder.path() / "parts.csv") << "u_re,u_im,m\n0.7,1.2,0.3\n";
    std::ofstream(folder.path() / "text.csv") << "u,m\n0.7+1.2i,0.3\n";
    words line{"table", "sn,dc", "--points", "parts.csv", "--digits", "36", "--format", "numpy"};
    const auto parts = run_libration(line, folder.path());
    line[3] = "text.csv";
    const auto text = run_libration(line, folder.path());
    for (const auto& done : {parts, text}) {
        const auto row = numpy_rows(done.out).at(0);
        CHECK((row.at("u_re") == "0.7" && row.at("u_im") == "1.2" && row.at("m") == "0.3"));
        CHECK_THAT(row.at("sn_re"), right_to_the_last_digit(sn_re));
        CHECK_THAT(row.at("sn_im"), right_to_the_last_digit(sn_im));
        CHECK_THAT(row.at("dc_re"), right_to_the_last_digit(dc_re));
        CHECK_THAT(row.at("dc_im"), right_to_the_last_digit(dc_im));
        CHECK(row.count("condition_sn") == 1);
    }
    // verify finds the values of a table correct.
    std::string columns = parts.out.substr(parts.out.rfind("# u_re") + 2);
    std::replace(columns.begin(), columns.end(), ' ', ',');
    std::ofstream(folder.path() / "values.csv") << columns;
    CHECK(run_libration({"verify", "values.csv", "--columns", "condition_sn=-,condition_dc=-"}, folder.path())
              .exit_code == 0);
}

TEST_CASE("complex arguments of tables are refused where they are none", "[command][table][bad input]") {
    check_refused({"am,sn", "--u", "1+i", "--m", "0.3"}, "--u '1+i' is complex, which am does not take");
    check_refused({"K", "--u", "1+i", "--m", "0.3"}, "--u '1+i' has no meaning for K");
    check_refused({"sn", "--u", "1+xi", "--m", "0.3"}, "--u '1+xi'");
    check_refused({"sn", "--u", "1+30degi", "--m", "0.3"}, "--u '1+30degi'");
    const temporary_folder folder;
    const auto says = [&](const std::string& function, const std::string& csv, const std::string& mentioned) {
        std::ofstream(folder.path() / "p.csv") << csv;
        const auto done = run_libration({"table", function, "--points", "p.csv"}, folder.path());
        return done.exit_code == 2 && done.out.empty() && done.err.find(mentioned) != std::string::npos;
    };
    CHECK(says("sn", "u,m\n1+2x,0.5\n", "p.csv:2: u '1+2x' is not a number"));
    CHECK(says("sn", "u,m\n1+1/0i,0.5\n", "p.csv:2: u '1+1/0i' divides by zero"));
    CHECK(says("sn", "u_re,m\n1,0.5\n", "p.csv has 'u_re' alone of u_re and u_im"));
    CHECK(says("sn", "u,u_re,u_im,m\n1,1,1,0.5\n", "p.csv has both 'u' and 'u_re'"));
    CHECK(says("sn", "u_re,u_im,m\n1,,0.5\n", "p.csv:2: u_im is empty"));
    CHECK(says("am", "u,m\n1+i,0.5\n", "p.csv:2: u '1+i' is complex, which am does not take"));
    CHECK(says("sn,am", "u,m\n1+i,0.5\n", "p.csv:2: u '1+i' is complex, which am does not take"));
}

TEST_CASE("a file of points is refused with line and column", "[command][table][bad input]") {
    const auto refused = [](const words& line, const std::string& csv, const std::string& mentioned) {
        const temporary_folder folder;
        std::ofstream(folder.path() / "p.csv", std::ios::binary) << csv;
        INFO(csv);
        tests::check_refused(words{"table"} + line + words{"--points", "p.csv"}, {mentioned}, folder);
    };
    refused({"sn"}, "u,m\n1,0.5\nx,0.5\n", "p.csv:3: u 'x' is not a number");
    refused({"sn"}, "u,m\n30deg,0.5\n", "p.csv:2: u '30deg'");
    refused({"sn"}, "u\n1\n", "p.csv has no modulus");
    refused({"sn"}, "m\n1\n", "p.csv has no column 'u'");
    refused({"sn", "--m", "0.5"}, "u,m\n1,0.5\n", "--m '0.5' comes together with --points");
    refused({"sn", "--times", "1"}, "u,m\n1,0.5\n", "--times '1'");
    refused({"pendulum"}, "E,t\n-1,0\n", "p.csv:2: E '-1' is a negative energy");
    refused({"pendulum"}, "E\n1\n", "has no column 'time'");
    refused({"pendulum", "--gaps", "1"}, "E,t\n1,0\n", "--gaps '1' comes together with --points");
    refused({"pendulum", "--format", "numpy"}, "E,theta0,t\n1,1,0\n1,,0\n", "p.csv:3: theta0 is empty");
    check_refused({"pendulum", "--points", "none.csv"}, "--points 'none.csv'");
    check_refused({"sn", "--u", "1", "--m", "0.5", "--columns", "a=m"}, "--columns 'a=m'");
    check_refused({"pendulum", "--energies", "1", "--times", "1", "--n", "1"}, "--n '1'");
}

TEST_CASE("a C header and a Fortran module compile and hold every digit", "[command][table]") {
    const temporary_folder folder;
    const words what{"K", "--k", "0.5,1", "--digits", "150", "--name", "values", "--format"};
    const auto expected = table_of({"K", "--k", "0.5,1", "--digits", "150"});
    const auto run = [&](const std::string& compile) {
        const std::string line =
            "cd '" + folder.path().string() + "' && " + compile + " > log 2>&1 && ./main > printed";
        const int status = std::system(line.c_str());
        INFO(text_of_file(folder.path() / "log"));
        REQUIRE(status == 0);
        return lines_of(text_of_file(folder.path() / "printed"));
    };
    std::ofstream(folder.path() / "values.h") << output_of(words{"table"} + what + words{"c"});
    std::ofstream(folder.path() / "main.c") << "#include <stdio.h>\n#include \"values.h\"\nint main(void) {\n"
                                               "    for (int i = 0; i < values_rows; ++i) puts(values[i].K);\n"
                                               "    return 0;\n}\n";
    CHECK(run("cc -std=c99 -Wall -Wextra -Wpedantic -Werror main.c -o main") == words{expected[0].at("value"), "inf"});
    if (std::system("command -v gfortran > /dev/null 2>&1") != 0) {
        return;  // Fortran is not required by the program
    }
    std::ofstream(folder.path() / "values.f90") << output_of(words{"table"} + what + words{"fortran"});
    std::ofstream(folder.path() / "main.f90")
        << "program main\n    use values\n    implicit none\n    real(kind=16) :: x\n    read (K_value(1), *) x\n"
           "    if (abs(x - 1.68575035481259604287120365779907699_16) > 1e-32_16) stop 1\n"
           "    print '(A)', trim(K_value(1)), trim(K_value(2))\nend program\n";
    CHECK(run("gfortran -std=f2008 -Wall -Werror values.f90 main.f90 -o main") ==
          words{expected[0].at("value"), "inf"});
}

TEST_CASE("Julia and PARI read tables as they are", "[command][table]") {
    const words what{"K", "--m", "0.5,1", "--digits", "20", "--name", "values", "--format"};
    const auto code = [&](const std::string& format) {
        words kept;
        for (const std::string& line : lines_of(output_of(words{"table"} + what + words{format}))) {
            if (!line.starts_with('#') && !line.starts_with("\\\\")) {
                kept.push_back(line);
            }
        }
        return kept;
    };
    CHECK(code("julia") == words{"const values = (;", "    m = [", "        \"0.5\",", "        \"1\",", "    ],",
                                 "    K = [", "        \"1.8540746773013719184\",", "        \"inf\",", "    ],",
                                 "    condition_K = [", "        \"0.228\",", "        \"inf\",", "    ],", ")"});
    CHECK(code("pari") == words{"{values = [", "0.5, 1.8540746773013719184, 0.228;", "1.0, +oo, +oo", "];}"});
}

TEST_CASE("tables refuse what is no grid, no function and no name", "[command][table][bad input]") {
    const words motion{"pendulum", "--energies", "1", "--times", "1"};
    check_refused({"pendulum", "--times", "1"}, "--gaps");
    check_refused({"pendulum", "--energies", "1"}, "--times");
    check_refused({"pendulum", "--energies", "1,x", "--times", "1"}, "--energies '1,x'");
    check_refused({"pendulum", "--gaps", "3", "--times", "1"}, "--gaps '3'");
    check_refused({"pendulum", "--energies", "1,2", "--times", "T"}, "--times 'T'");
    check_refused({"pendulum", "--energies", "1", "--theta0", "100deg", "--times", "1"}, "--theta0 '100deg'");
    check_refused({"pendulum", "--theta0", "1", "--omega0", "pi", "--times", "1"}, "--omega0 'pi'");
    check_refused({"pendulum", "--omega0", "1", "--times", "1"}, "--omega0 '1'");
    check_refused(motion + words{"--omega0", "1"}, "--omega0 '1'");
    check_refused(motion + words{"--direction", "up"}, "--direction 'up'");
    check_refused(motion + words{"--length", "1"}, "--length '1'");
    check_refused(motion + words{"--u", "1"}, "--u '1'");
    check_refused(motion + words{"--digits", "0"}, "--digits '0'");
    check_refused(motion + words{"--format", "xml"}, "--format 'xml'");
    check_refused(motion + words{"--name", "a"}, "--name 'a'");
    for (const std::string name : {"", "1a", "a-b", "class", "_a", "a__b"}) {
        check_refused(motion + words{"--format", "cpp", "--name", name}, "--name '" + name + "'");
    }
    check_refused({"sm", "--u", "1", "--m", "0.5"}, "'sm'");
    check_refused({"sn,E", "--u", "1", "--m", "0.5"}, "'sn,E'");
    check_refused({"Pi", "--m", "0.5"}, "--n");
    check_refused({"K", "--m", "0.5,1.5"}, "'1.5' is above 1");
    check_refused({"sn,", "--u", "1", "--m", "0.5"}, "'sn,'");
    check_refused({"sn,K", "--u", "1", "--m", "0.5"}, "'sn,K'");
    check_refused({"sn", "--u", "1", "--m", "0.5", "--times", "1"}, "--times '1'");
    check_refused({"sn", "--u", "1", "--k", "0.5,-1.5"}, "--k '0.5,-1.5'");
    check_refused({"sn", "--u", "1", "--m", "pi"}, "--m 'pi'");
    check_refused({"sn", "--u", "1"}, "--m1");
}

TEST_CASE("the published reference values are computed again byte for byte", "[command][table][results]") {
    const std::filesystem::path folder = LIBRATION_SOURCE_DIR "/results/reference";
    for (const auto& each : nlohmann::json::parse(text_of_file(folder / "reference.json"))) {
        std::istringstream said(each.at("command").get<std::string>());
        words line;
        for (std::string word; said >> word;) {
            line.push_back(word);
        }
        REQUIRE(line.front() == "libration");
        line.erase(line.begin());
        CHECK(output_of(line) == text_of_file(folder / (each.at("name").get<std::string>() + ".csv")));
    }
}

}  // namespace command_table_test
