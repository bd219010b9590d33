// The contract of the output (DESIGN section 4): columns, formats, texts repeated as typed, signs, units and files.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "libration/scalar/ball/product_self_test.hpp"

namespace command_output_test {

using namespace libration;
using namespace libration::tests;

namespace {

struct contract {
    words command;
    std::string columns;  // later ones may be appended
    std::size_t rows;
};

// Every table that a command prints, with the columns of DESIGN section 4.
const std::vector<contract>& contracts() {
    static const std::vector<contract> all{
        {{"period", "--energy", "1.71"}, "energy,gap,method,order,period,tstar,error", 1},
        {{"period", "--energy", "1.71", "--method", "series", "--order", "10"},
         "energy,gap,method,order,period,tstar,error",
         1},
        {{"period", "--theta0", "1", "--omega0", "2.5"}, "energy,gap,method,order,period,tstar,error", 1},
        {{"period", "--energy", "2"}, "energy,gap,method,order,period,tstar,error", 1},
        {{"coefficients", "--energy", "2.02", "--order", "7"}, "n,coefficient", 8},
        {{"coefficients", "--energy", "2", "--order", "0"}, "n,coefficient", 1},
        {{"trajectory", "--energy", "1.71", "--times", "0:3:4,T"}, "time,theta,omega,error", 5},
        {{"trajectory", "--energy", "2.02", "--times", "1", "--method", "resummed", "--order", "5"},
         "time,theta,omega,error",
         1},
        {{"trajectory", "--energy", "2.02", "--times", "0,1", "--method", "rk4", "--step", "0.1"},
         "time,theta,omega,error",
         2},
        {{"study", "error_norm", "--energies", "1.71", "--orders", "5,10", "--scalar", "double"},
         "energy,order,method,norm,time_of_maximum,scalar,rigour",
         4},
    };
    return all;
}

words in_format(const contract& c, const std::string& format) {
    return c.command.front() == "study" ? c.command : c.command + words{"--format", format};
}

table_row only_row(const words& command) {
    const auto rows = rows_of(command);
    REQUIRE(rows.size() == 1);
    return rows.front();
}

std::vector<std::string> column_of(const words& command, const std::string& name) {
    std::vector<std::string> cells;
    for (const table_row& row : rows_of(command)) {
        cells.push_back(row.at(name));
    }
    return cells;
}

const words fall{"trajectory", "--energy", "1.71"};
const words turn{"trajectory", "--energy", "2.02"};

}  // namespace

TEST_CASE("CSV has the columns of the contract first, one header line, one row an observation, no comments",
          "[command][output]") {
    for (const contract& c : contracts()) {
        INFO(command_line(c.command));
        const std::string csv = output_of(in_format(c, "csv"));
        const auto lines = lines_of(csv);
        REQUIRE_FALSE(lines.empty());
        CHECK(lines.front().starts_with(c.columns));
        CHECK((lines.front().size() == c.columns.size() || lines.front()[c.columns.size()] == ','));
        CHECK(lines.size() == c.rows + 1);
        CHECK(csv_rows(csv).size() == c.rows);  // throws if a row has other columns than the header
        CHECK(csv.ends_with("\n"));
        CHECK(csv.find_first_of("#\r\" ") == std::string::npos);
    }
}

TEST_CASE("JSON is an array of objects with the keys and the cells of the CSV, in its order, null for empty ones",
          "[command][output]") {
    for (const contract& c : contracts()) {
        if (c.command.front() == "study") {
            continue;  // studies write CSV
        }
        INFO(command_line(c.command));
        const auto lines = lines_of(output_of(in_format(c, "csv")));
        const auto names = split_cells(lines.front());
        const auto json = nlohmann::ordered_json::parse(output_of(in_format(c, "json")));
        REQUIRE(json.is_array());
        REQUIRE(json.size() == c.rows);
        for (std::size_t i = 0; i < c.rows; ++i) {
            REQUIRE(json[i].is_object());
            words keys;
            words cells;
            for (const auto& [key, value] : json[i].items()) {
                REQUIRE((value.is_string() || value.is_null()));
                CHECK(value != "");
                keys.push_back(key);
                cells.push_back(value.is_null() ? "" : value.get<std::string>());
            }
            CHECK(keys == names);
            CHECK(cells == split_cells(lines[i + 1]));
        }
    }
}

TEST_CASE("text is the default and holds every cell of the CSV", "[command][output]") {
    for (const contract& c : contracts()) {
        if (c.command.front() == "study") {
            continue;
        }
        INFO(command_line(c.command));
        const std::string text = output_of(c.command);
        CHECK(text == output_of(in_format(c, "text")));
        for (const table_row& row : csv_rows(output_of(in_format(c, "csv")))) {
            for (const auto& [name, cell] : row) {
                CHECK((cell.empty() || text.find(name) != std::string::npos));
                CHECK(text.find(cell) != std::string::npos);
            }
        }
    }
}

TEST_CASE("energies, gaps and times are decimals, and stand as typed behind", "[command][output]") {
    for (const std::string energy : {"1.71", "1.7100", "171/100", "1e-30", "+3", "2.000", "0", ".5", "17E-1"}) {
        const table_row row = only_row({"period", "--energy", energy});
        CHECK(row.at("energy_typed") == energy);
        CHECK(row.at("gap_typed").empty());
        CHECK(read_exact(row.at("energy")).coefficient == read_exact(energy).coefficient);
        CHECK(row.at("energy").find('/') == std::string::npos);
    }
    for (const std::string gap : {"0.29", "29/100", "1e-30", "-1e-12", "0.0"}) {
        const table_row row = only_row({"period", "--gap=" + gap});
        CHECK(row.at("gap_typed") == gap);
        CHECK(read_exact(row.at("gap")).coefficient == read_exact(gap).coefficient);
    }
    CHECK(only_row({"period", "--energy", "171/100"}).at("energy") == "1.71");
    CHECK(only_row({"period", "--theta0", "60deg", "--omega0", "1/2"}).at("theta0_typed") == "60deg");
    const words times{"-3T/4", "-1e6", "0", "+0.5", "1/3", "2.50", "pi", "T/4", "1e12"};
    const words line = fall + words{"--times=-3T/4,-1e6,0,+0.5,1/3,2.50,pi,T/4,1e12", "--digits", "20"};
    CHECK(column_of(line, "time_typed") == times);
    const words decimals = column_of(line, "time");
    const mpfr period = number_of(only_row({"period", "--energy", "1.71", "--digits", "30"}).at("period"));
    CHECK_THAT(decimals[0], right_to_the_last_digit_of(mpfr(period * -3 / 4)));
    CHECK(decimals[3] == "0.5");
    CHECK(decimals[4] == "0.33333333333333333333");
    CHECK(decimals[5] == "2.50");
    CHECK(decimals[6] == "3.1415926535897932385");
    CHECK(column_of(fall + words{"--times", "0:20:5"}, "time") == words{"0", "5", "10", "15", "20"});
    CHECK(column_of(fall + words{"--times", "0:1:4"}, "time_typed") == words{"0", "1/3", "2/3", "1"});
}

TEST_CASE("the energy that was not typed is exact where it can be", "[command][output]") {
    CHECK(only_row({"period", "--gap", "1e-30"}).at("energy") == "1.999999999999999999999999999999");
    CHECK(only_row({"period", "--gap", "-1e-30"}).at("energy") == "2.000000000000000000000000000001");
    CHECK(only_row({"period", "--energy", "1.71"}).at("gap") == "0.29");
    CHECK(only_row({"period", "--energy", "1/3", "--digits", "5"}).at("gap") == "1.6667");
    const table_row state = only_row({"period", "--theta0", "60deg", "--omega0", "1/2"});
    CHECK(state.at("energy") == "0.625");  // 1/2 + 1/8
    CHECK(state.at("gap") == "1.375");
    // 1 - cos 1, irrational, by its alternating series of 1/(2k)!.
    const table_row radian = only_row({"period", "--theta0", "1", "--omega0", "0", "--digits", "20"});
    CHECK_THAT(radian.at("energy"), right_to_the_last_digit("0.45969769413186028259906339255702339626769"));
    CHECK_THAT(radian.at("gap"), right_to_the_last_digit("1.54030230586813971740093660744297660373231"));
}

TEST_CASE("negative lists go with an equals sign or without, and --time is --times", "[command][output]") {
    const std::string expected = output_of(fall + words{"--times=-1e6,0"});
    CHECK(lines_of(expected).size() == 3);
    CHECK(output_of(fall + words{"--time=-1e6,0"}) == expected);
    CHECK(output_of(fall + words{"--times", "-1e6,0"}) == expected);
    CHECK(output_of(fall + words{"--time", "-1e6,0"}) == expected);
}

TEST_CASE("option --direction mirrors a rotation and does nothing to a pendulum at rest", "[command][output]") {
    const words times{"--times", "0,1,T/3", "--digits", "30"};
    CHECK(output_of(turn + times + words{"--direction", "+"}) == output_of(turn + times));
    CHECK(output_of(fall + times + words{"--direction", "-"}) == output_of(fall + times));
    const auto up = rows_of(turn + times);
    const auto down = rows_of(turn + times + words{"--direction", "-"});
    REQUIRE(down.size() == 3);
    const precision_scope scope(60);
    for (std::size_t i = 0; i < 3; ++i) {
        // The mirror image about the top, theta -> 2 pi - theta. Three roundings of numbers below 10 to 30 digits.
        const mpfr sum = number_of(up[i].at("theta")) + number_of(down[i].at("theta"));
        CHECK(abs(sum - 2 * pi<mpfr>()) <= mpfr("3e-29"));
        CHECK("-" + up[i].at("omega") == down[i].at("omega"));
    }
    const words at_two{"trajectory", "--energy", "2", "--times", "1"};
    CHECK("-" + only_row(at_two).at("theta") == only_row(at_two + words{"--direction", "-"}).at("theta"));
}

TEST_CASE("with a length and a gravity times are seconds and speeds radians per second", "[command][output]") {
    // g/l = 4: a second is two units of time.
    const words clock{"--length", "2", "--gravity", "8"};
    const table_row plain = only_row(fall + words{"--times", "0.7"});
    const table_row seconds = only_row(fall + clock + words{"--times", "0.35"});
    CHECK(seconds.at("theta") == plain.at("theta"));
    const precision_scope scope(60);
    CHECK_THAT(seconds.at("omega"),
               right_to_the_last_digit_of(
                   number_of(only_row(fall + words{"--times", "0.7", "--digits", "60"}).at("omega")) * 2));
    // omega0 = -0.6 rad/s is -0.3.
    CHECK(only_row({"trajectory", "--theta0", "2.5", "--omega0", "-0.6", "--length", "2", "--gravity", "8", "--times",
                    "3.65"})
              .at("theta") ==
          only_row({"trajectory", "--theta0", "2.5", "--omega0", "-0.3", "--times", "7.3"}).at("theta"));
    // The separatrix of g/l = 4 through the bottom has omega0 = 4.
    CHECK(only_row(words{"period", "--theta0", "0", "--omega0", "4"} + clock).at("regime") == "separatrix");
    // a_n is in units of time^-n: a_2 of g/l = 4 is four times as large.
    const words second{"coefficients", "--energy", "1", "--order", "2"};
    CHECK(rows_of(second).at(2).at("coefficient") == "-0.50000000000000000000000000000000000000000000000000");
    CHECK(rows_of(second + clock).at(2).at("coefficient") == "-2.0000000000000000000000000000000000000000000000000");
}

TEST_CASE("the period of a real pendulum is in seconds", "[command][output]") {
    // Two metres at 9.81 m/s^2 from 90 degrees: Gamma(1/4)^2/sqrt(pi) sqrt(2/9.81).
    const precision_scope scope(80);
    const mpfr quarter("0.25");
    const mpfr gamma = tgamma(quarter);
    const mpfr expected = gamma * gamma / sqrt(pi<mpfr>()) * sqrt(mpfr(200) / 981);
    const table_row row =
        only_row({"period", "--theta0", "90deg", "--omega0", "0", "--length", "2", "--gravity", "9.81"});
    CHECK_THAT(row.at("period"), right_to_the_last_digit_of(expected));
    CHECK_THAT(row.at("tstar"), right_to_the_last_digit_of(expected / 4));
}

TEST_CASE("every regime has its name", "[command][output]") {
    const auto regime = [](const words& motion) { return only_row(words{"period"} + motion).at("regime"); };
    CHECK(regime({"--energy", "1.71"}) == "libration");
    CHECK(regime({"--gap", "1e-300"}) == "libration");
    CHECK(regime({"--gap", "-1e-300"}) == "rotation");
    CHECK(regime({"--theta0", "120deg", "--omega0", "1"}) == "separatrix");
    CHECK(regime({"--theta0", "120deg", "--omega0", "0.99999999999999999999999999999999"}) == "libration");
    CHECK(regime({"--theta0", "120deg", "--omega0", "1.00000000000000000000000000000001"}) == "rotation");
    CHECK(regime({"--energy", "2"}) == "separatrix");
    CHECK(regime({"--energy", "0"}) == "stable-equilibrium");
    CHECK(regime({"--theta0", "2pi", "--omega0", "0"}) == "stable-equilibrium");
    CHECK(regime({"--theta0", "180deg", "--omega0", "0"}) == "unstable-equilibrium");
}

TEST_CASE("infinite periods print inf, and E = 0 has the limits", "[command][output]") {
    for (const words& motion : {words{"--energy", "2"}, words{"--theta0", "120deg", "--omega0", "1"},
                                words{"--theta0", "180deg", "--omega0", "0"}}) {
        const table_row row = only_row(words{"period"} + motion);
        CHECK(row.at("period") == "inf");
        CHECK(row.at("tstar") == "inf");
        CHECK(row.at("energy") == "2");
        CHECK(row.at("gap") == "0");
    }
    const precision_scope scope(80);
    const table_row row = only_row({"period", "--energy", "0"});
    CHECK_THAT(row.at("period"), right_to_the_last_digit_of(pi<mpfr>() * 2));
    CHECK_THAT(row.at("tstar"), right_to_the_last_digit_of(pi<mpfr>() / 2));
}

TEST_CASE("the equilibria stay where they are", "[command][output]") {
    for (const table_row& row : rows_of({"trajectory", "--energy", "0", "--times", "0,1e6,T/4"})) {
        CHECK(row.at("theta") == "0");
        CHECK(row.at("omega") == "0");
        CHECK(row.at("error") == "0");
    }
    const precision_scope scope(80);
    for (const table_row& row : rows_of({"trajectory", "--theta0", "180deg", "--omega0", "0", "--times", "0,1e6"})) {
        CHECK_THAT(row.at("theta"), right_to_the_last_digit_of(pi<mpfr>()));
        CHECK(row.at("omega") == "0");
    }
}

TEST_CASE("as many significant digits are printed as were asked for", "[command][output]") {
    for (const long digits : {1L, 2L, 17L, 50L, 333L, 2000L}) {
        INFO(digits);
        const words asked{"--digits", std::to_string(digits)};
        CHECK(significant_digits(only_row(words{"period", "--energy", "1.71"} + asked).at("period")) == digits);
        const table_row state = only_row(words{"trajectory", "--energy", "3", "--times", "1e3"} + asked);
        CHECK(significant_digits(state.at("theta")) == digits);
        CHECK(significant_digits(state.at("omega")) == digits);
        CHECK(significant_digits(
                  only_row(words{"coefficients", "--energy", "3", "--order", "0"} + asked).at("coefficient")) ==
              digits);
    }
    CHECK(significant_digits(only_row({"period", "--energy", "3"}).at("period")) == 50);
    CHECK(significant_digits(only_row({"period", "--energy", "3", "--scalar", "mpfr:33"}).at("period")) == 33);
    CHECK(significant_digits(only_row({"period", "--energy", "3", "--scalar", "double"}).at("period")) == 17);
    CHECK(significant_digits(only_row({"period", "--energy", "3", "--scalar", "quad", "--digits", "8"}).at("period")) ==
          8);
}

TEST_CASE("option --out writes the whole file, over an old one too, and nothing to stdout", "[command][output]") {
    const temporary_folder folder;
    std::ofstream(folder.path() / "table.csv") << std::string(100'000, 'x');
    for (const contract& c : contracts()) {
        if (c.command.front() == "study") {
            continue;
        }
        INFO(command_line(c.command));
        const words csv = in_format(c, "csv");
        const finished_process done = run_libration(csv + words{"--out", "table.csv"}, folder.path());
        CHECK(done.exit_code == 0);
        CHECK(done.out.empty());
        CHECK(done.err.empty());
        CHECK(text_of_file(folder.path() / "table.csv") == output_of(csv));
        CHECK(folder.content() == words{"table.csv"});
    }
}

TEST_CASE("option --version names the libraries and whether MPFR is thread-safe", "[command][output]") {
    const std::string text = output_of({"--version"});
    const auto lines = lines_of(text);
    const auto has = [&](const std::string& start, const std::string& rest) {
        return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
            return line.starts_with(start) && line.find(rest, start.size()) != std::string::npos;
        });
    };
    CHECK(has("libration ", "."));
    CHECK(has("Boost ", std::to_string(BOOST_VERSION / 100000) + "." + std::to_string(BOOST_VERSION / 100 % 1000)));
    CHECK(has("MPFR ", mpfr_get_version()));
    CHECK(has("GMP ", gmp_version));
    CHECK(has("MPFR thread-safe ", mpfr_buildopt_tls_p() != 0 ? "yes" : "no"));
    CHECK(has("ball arithmetic ", flint_version));
    CHECK(has("long products ", flint_products().transform_is_right ? "passed" : "_fmpz_poly_mullow_SS failed"));
}

TEST_CASE("help goes to stdout and succeeds", "[command][output]") {
    CHECK(output_of({"--help"}).find("trajectory") != std::string::npos);
    for (const std::string command :
         {"period", "coefficients", "trajectory", "table", "study", "figure", "reproduce"}) {
        CHECK(output_of({command, "--help"}).find("Usage: libration " + command) != std::string::npos);
    }
    CHECK(output_of({"trajectory", "--help"}).find("--omega0") != std::string::npos);
}

TEST_CASE("a full disk behind stdout is noticed", "[command][output]") {
    // The shell is used only for the redirection.
    const std::string line = std::string("'") + LIBRATION_COMMAND + "' period --energy 1 > /dev/full 2> /dev/null";
    const int status = std::system(line.c_str());
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 1);
}

TEST_CASE("option --out writes through a link and into a device", "[command][output]") {
    const temporary_folder folder;
    const auto target = folder.path() / "target.txt";
    const auto link = folder.path() / "link.txt";
    std::ofstream(target) << "old";
    std::filesystem::create_symlink(target, link);
    CHECK(run_libration({"period", "--energy", "1", "--out", link.string()}, folder.path()).exit_code == 0);
    CHECK(std::filesystem::is_symlink(link));
    CHECK(text_of_file(target).starts_with("energy  1"));
    CHECK(run_libration({"period", "--energy", "1", "--out", "/dev/null"}, folder.path()).exit_code == 0);
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace command_output_test
