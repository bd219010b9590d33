// `libration verify`: verdicts compared with mpmath and closed forms, accepted input, and errors.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_verify_test {

using namespace libration;
using namespace libration::tests;

namespace {

struct verified {
    finished_process done;
    std::vector<table_row> rows;
};

finished_process verify(const std::string& csv, const words& options = {}) {
    const temporary_folder folder;
    std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
    return run_libration(words{"verify", "f.csv"} + options, folder.path());
}

// The compared rows of a file without quotes.
verified verify_rows(const std::string& csv, const words& options = {}) {
    const auto done = verify(csv, options);
    INFO(done.err);
    return {done, csv_rows(done.out)};
}

std::string verdict_of(const std::string& csv, const words& options = {}) {
    return verify_rows(csv, options).rows.at(0).at("verdict");
}

bool says(const finished_process& done, const std::string& what) {
    INFO(done.err);
    return done.err.find(what) != std::string::npos;
}

// The file is rejected as a whole.
void refuses(const std::string& csv, const words& options, const std::string& reason) {
    const temporary_folder folder;
    std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
    INFO(csv);
    check_refused(words{"verify", "f.csv"} + options, {reason}, folder);
}

// mpmath, mp.dps = 40: 2*asin(sqrt(m)*ellipfun('cd', mpf('0.7'), m=m)), m = mpf('1.71')/2
const std::string theta_at_seven_tenths = "2.182887871517687737950367677330840756";

}  // namespace

TEST_CASE("verify finds the two wrong rows of 150", "[command][verify]") {
    std::string csv = "note,theta,energy,time\n";
    for (int i = 0; i < 150; ++i) {
        std::string theta = theta_at_seven_tenths.substr(0, 31);
        if (i == 40 || i == 110) {
            theta[12] = theta[12] == '9' ? '0' : static_cast<char>(theta[12] + 1);
        }
        csv += "n" + std::to_string(i) + "," + theta + ",1.71,0.7\n";
    }
    const auto [done, rows] = verify_rows(csv, {"--tolerance", "1e-25"});
    CHECK(done.exit_code == 1);
    REQUIRE(rows.size() == 150);
    for (int i = 0; i < 150; ++i) {
        const table_row& row = rows[static_cast<std::size_t>(i)];
        CHECK(row.at("note") == "n" + std::to_string(i));
        CHECK(row.at("verdict") == (i == 40 || i == 110 ? "miss" : "ok"));
        CHECK_THAT(row.at("reference"), right_to_the_last_digit(theta_at_seven_tenths));
    }
    CHECK(rows[40].at("error") == "1.00e-11");
    CHECK(rows[40].at("correct_digits") == "11.3");
    CHECK(says(done, "f.csv: 150 rows, 148 ok, 2 miss, 0 malformed"));
    CHECK(says(done, "f.csv:42: theta misses by 1.00e-11"));
    CHECK(says(done, "f.csv:112: theta misses by"));
}

TEST_CASE("verify takes one unit of the last digit as written", "[command][verify]") {
    CHECK(verdict_of("time,theta,energy\n0.7,2.18,1.71\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0.7,2.19,1.71\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0.7,2.20,1.71\n") == "miss");
    CHECK(verdict_of("time,theta,energy\n0.7,2.190,1.71\n") == "miss");
    CHECK(verdict_of("time,theta,energy\n0.7,218e-2,1.71\n") == "ok");
}

TEST_CASE("verify reads the motion by state, else gap, else energy", "[command][verify]") {
    // The gap 2 - 1.71; the state at rest at the right angle and the energy 1; both columns in one file.
    CHECK(verdict_of("time,theta,gap\n0.7," + theta_at_seven_tenths + ",0.29\n") == "ok");
    const std::string head = "energy,gap,theta0,omega0,time,theta\n";
    const auto by_gap = verify_rows(head + "1.71,0.29,,,0.7," + theta_at_seven_tenths + "\n");
    CHECK(by_gap.rows.at(0).at("verdict") == "ok");
    const auto state = verify_rows(head + "1,1,90deg,0,0.7,1.33\n").rows.at(0);
    const auto energy = verify_rows("time,theta,energy\n0.7,1.33,1\n").rows.at(0);
    CHECK(state.at("reference") == energy.at("reference"));
    CHECK(state.at("verdict") == energy.at("verdict"));
}

TEST_CASE("verify serves files without a motion by options", "[command][verify]") {
    const std::string csv = "time,theta\n0.7," + theta_at_seven_tenths + "\n";
    CHECK(verdict_of(csv, {"--energy", "1.71"}) == "ok");
    CHECK(verdict_of(csv, {"--gap", "0.29"}) == "ok");
    CHECK(verdict_of(csv, {"--energy", "1.7"}) == "miss");
    // Seconds: gravity/length = 4 makes 0.7 of 0.35 s.
    CHECK(verdict_of("time,theta\n0.35," + theta_at_seven_tenths + "\n",
                     {"--gap", "0.29", "--length", "0.25", "--gravity", "1"}) == "ok");
}

TEST_CASE("verify knows the direction of a rotation and compares omega", "[command][verify]") {
    // theta(t) + theta'(t) clockwise from (pi, -sqrt 2) at E = 3, t = 0.7, by mpmath (mp.dps = 40):
    // k = sqrt(mpf(2)/3); u = mpf('0.7')*sqrt(mpf(3)/2); K = ellipk(k**2)
    // 2*pi - 2*(asin(ellipfun('sn', K - u, k=k))) ... theta = 2*asin(sn(K - u)), omega = -2*sqrt(3/2)*dn(K - u)
    const std::string theta = "2.073165419982046882946237671700";
    const std::string omega = "-1.7426971818901658803";
    const std::string head = "theta,omega,time,energy,direction\n";
    const auto good = verify_rows(head + theta + "," + omega + ",0.7,3,-\n");
    CHECK(good.done.exit_code == 0);
    CHECK(good.rows.at(0).at("verdict") == "ok");
    CHECK(good.rows.at(0).at("omega_reference").starts_with("-1.742697181890165880"));
    CHECK(verify_rows(head + theta + "," + omega + ",0.7,3,+\n").rows.at(0).at("verdict") == "miss");
    const auto bad = verify_rows(head + theta + ",-1.7427,0.7,3,-1\n");
    CHECK(bad.rows.at(0).at("verdict") == "ok");
    const auto worse = verify_rows(head + theta + ",-1.7428,0.7,3,-1\n");
    CHECK(worse.rows.at(0).at("verdict") == "miss");
    CHECK(says(worse.done, "omega misses by 0.000103"));
    CHECK(says(verify(head + theta + "," + omega + ",0.7,3,up\n"), "direction 'up' is neither + nor -"));
}

TEST_CASE("verify keeps quoted cells and reads CRLF and a byte-order mark", "[command][verify]") {
    const std::string csv = "\xEF\xBB\xBF\"time\",theta , energy,note\r\n0.7,\"2.18\", 1.71 ,\"a, \"\"b\"\"\nc\"\r\n";
    const auto done = verify(csv);
    CHECK(done.exit_code == 0);
    const auto lines = lines_of(done.out);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "time,theta,energy,note,reference,error,correct_digits,verdict,condition");
    CHECK(lines[1] == "0.7,\"2.18\", 1.71 ,\"a, \"\"b\"\"");
    CHECK(lines[2].starts_with("c\",2.18288787151768773795,0.00289,"));
}

TEST_CASE("verify names malformed rows, marks them and goes on", "[command][verify]") {
    const std::string csv =
        "time,theta,energy\n0.7,2.18,1.71\n0.7,two,1.71\n0.7,2.18\n\nT/0,2.18,1.71\n0.7,2.18,-1\n0.7,2.18,\n"
        "0.7,\"2.18,1.71\n0.7,3.18,1.71\n0.7,,1.71\n0.7,1/2,1.71\n0.7,2.18,1.71\n";
    const auto done = verify(csv);
    CHECK(done.exit_code == 2);
    CHECK(says(done, "f.csv:3: theta 'two' is not a number"));
    CHECK(says(done, "f.csv:4: has 2 cells, the header has 3"));
    CHECK(says(done, "f.csv:6: time 'T/0' divides by zero"));
    CHECK(says(done, "f.csv:7: energy '-1' is a negative energy"));
    CHECK(says(done, "f.csv:8: the row has no motion"));
    CHECK(says(done, "f.csv:9: 'theta': a quote is not closed"));
    CHECK(says(done, "f.csv:10: theta misses by 0.997"));
    CHECK(says(done, "f.csv:11: theta is empty"));
    CHECK(says(done, "f.csv:12: theta '1/2' is not a number"));
    CHECK(says(done, "11 rows, 2 ok, 1 miss, 8 malformed"));
    const auto lines = lines_of(done.out);
    REQUIRE(lines.size() == 12);
    CHECK(lines[2] == "0.7,two,1.71,,,,malformed,");
    CHECK(lines[3] == "0.7,2.18,,,,,malformed,");
    CHECK(lines[7] == "\"0.7,\"\"2.18,1.71\",,,,,,malformed,");
    CHECK(lines[11].starts_with("0.7,2.18,1.71,2.18288787151768773795,"));
}

TEST_CASE("verify says which columns are missing", "[command][verify][bad input]") {
    refuses("when,where\n1,2\n", {"--energy", "1"},
            "f.csv has no column 'time', 'theta': its columns are 'when', 'where'");
    refuses("time,theta\n1,2\n", {}, "f.csv has no motion: its columns are 'time', 'theta'");
    refuses("time,theta,theta\n1,2,2\n", {}, "f.csv has two columns 'theta'");
    refuses("m,sn\n0,0\n", {}, "f.csv has no column 'u', the argument of sn: its columns are 'm', 'sn'");
    refuses("u,q,sn\n0,0.1,0\n", {}, "f.csv has no modulus: its columns are 'u', 'q', 'sn'");
    refuses("u,sn\n0,0\n", {}, "f.csv has no modulus: its columns are 'u', 'sn'");
    refuses("u,m,value\n0,0,0\n", {}, "f.csv has no column of an elliptic function: its columns are 'u', 'm', 'value'");
    refuses("when,x\n0,0\n", {"--problem", "dx/ds = 1; x(0) = 0"}, "f.csv has no column 's' or 'time'");
    refuses("", {}, "f.csv has no header");
    refuses("time,theta,energy\n", {}, "f.csv has no row to compare");
    refuses("time,theta,energy\n", {"--format", "json"}, "f.csv has no row to compare");
    check_refused({"verify", "none.csv"}, {"FILE 'none.csv'"});
}

TEST_CASE("verify refuses tolerances, inputs and formats that are none", "[command][verify][bad input]") {
    const std::string csv = "time,theta,energy\n0,1,1\n";
    refuses(csv, {"--ulp", "1", "--tolerance", "1"}, "--ulp '1' comes together with --tolerance '1'");
    refuses(csv, {"--relative", "1e-9", "--ulp", "1"}, "--ulp '1' comes together with --relative '1e-9'");
    refuses(csv, {"--rounding", "--ulp", "1"}, "--ulp '1' comes together with --rounding");
    refuses(csv, {"--tolerance", "x"}, "--tolerance 'x'");
    refuses(csv, {"--inputs", "float"}, "--inputs 'float'");
    refuses(csv, {"--format", "xml"}, "--format 'xml' is not a format");
    refuses("u,m,sn\n0,0,0\n", {"--modulo-2pi"}, "--modulo-2pi has no meaning");
}

TEST_CASE("verify reads hexadecimal floats as numbers and inputs", "[command][verify]") {
    // 0x1.8p+1 = 3; float.hex(2.1828878715176877) = 0x1.1768dea89e8e9p+1, its last digit worth 2^-51.
    CHECK(verdict_of("time,theta,energy\n0x1.8p+1,-1.57,0x1p0\n", {"--tolerance", "10"}) == "ok");
    const std::string by_hex = verify_rows("time,theta,energy\n0x1.8p+1,-1.57,0x1p0\n").rows.at(0).at("reference");
    CHECK(by_hex == verify_rows("time,theta,energy\n3,-1.57,1\n").rows.at(0).at("reference"));
    CHECK(verdict_of("time,theta,energy\n0,0x1.921fb54442d18p+0,1\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0,0x1.921fb54442d19p+0,1\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0,0x1.921fb54442d1ap+0,1\n") == "miss");
}

TEST_CASE("verify tells inputs as typed from the doubles that a library received", "[command][verify]") {
    // E = 1.99999999 at t = 9.9: mpmath gives both references,
    // E = mpf('1.99999999') or mpf(1.99999999), mp.dps = 40: 2*asin(sqrt(E/2)*ellipfun('cd', mpf(t), m=E/2))
    const std::string csv = "time,theta,energy\n9.75,0.1,1.99999999\n";
    const auto typed = verify_rows(csv).rows.at(0);
    const auto received = verify_rows(csv, {"--inputs", "double"}).rows.at(0);
    const precision_scope scope(60);
    const mpfr apart = abs(number_of(typed.at("reference")) - number_of(received.at("reference")));
    // 1.99999999 is within 2^-53 of its double, and dtheta/dE is about |omega| dT*/dE = 2/(2 gap) = 10^8.
    CHECK(apart < ldexp(mpfr(1), -53) * 100'000'000);
    CHECK(apart > ldexp(mpfr(1), -52) * 10);
    CHECK(number_of(typed.at("condition")) > 10'000'000);
    // A gap is a small number, which a double represents to full relative accuracy.
    const std::string by_gap = "time,theta,gap\n9.75,0.1,1e-8\n";
    CHECK(number_of(verify_rows(by_gap).rows.at(0).at("condition")) < 30);
}

TEST_CASE("verify compares in units in the last place of doubles", "[command][verify]") {
    // The double of theta: 2.1828878715176877; one unit is 2^-51 = 4.4e-16 from 2 on.
    const std::string head = "time,theta,energy\n0.7,";
    CHECK(verdict_of(head + "2.1828878715176877,1.71\n", {"--ulp", "0.5"}) == "ok");
    CHECK(verdict_of(head + "2.1828878715176882,1.71\n", {"--ulp", "1"}) == "miss");
    CHECK(verdict_of(head + "2.1828878715176882,1.71\n", {"--ulp", "2"}) == "ok");
    // Libration's values in double, given the gap.
    const auto own = output_of({"trajectory", "--gap", "1e-10", "--method", "exact", "--scalar", "double", "--times",
                                "0:20:21", "--format", "csv"});
    const auto [done, rows] = verify_rows(own, {"--gap", "1e-10", "--ulp", "4"});
    CHECK(done.exit_code == 0);
    CHECK(rows.size() == 21);
    CHECK(rows.at(3).contains("verify_error"));
}

TEST_CASE("verify decides at huge times, at exact zeros, on the separatrix and at rest", "[command][verify]") {
    CHECK(verdict_of("time,theta,energy\nT/4,0,1.71\n") == "ok");
    const auto zero = verify_rows("time,theta,energy\nT/4,0.0,1.71\n").rows.at(0);
    CHECK(zero.at("error") == "0");
    CHECK(zero.at("correct_digits") == "inf");
    // Independent of verify: `libration trajectory` by mpfr and its phase map.
    for (const words& motion : {words{"--energy", "1.71"}, words{"--theta0", "2.5", "--omega0", "-0.3"},
                                words{"--energy", "3", "--direction", "-"}, words{"--theta0", "pi", "--omega0", "0"},
                                words{"--theta0", "120deg", "--omega0", "1"}, words{"--energy", "0"}}) {
        INFO(command_line(motion));
        // On the separatrix omega falls like exp(-t), until its exponent is out of range.
        const std::string times = motion.back() == "1" ? "0,0.7,40,1e5" : "0,0.7,40,1e20";
        const auto theirs =
            output_of(words{"trajectory", "--times", times, "--digits", "40", "--format", "csv"} + motion);
        const auto [done, rows] = verify_rows(theirs, motion);
        INFO(done.err);
        CHECK(done.exit_code == 0);
    }
}

TEST_CASE("verify takes nan for a miss and counts it as the worst", "[command][verify]") {
    const auto [done, rows] = verify_rows("time,theta,energy\n0.7,-nan,1.71\n0.7,2.18,1.71\n");
    CHECK(done.exit_code == 1);
    CHECK(rows.at(0).at("verdict") == "miss");
    CHECK(rows.at(0).at("error") == "inf");
    CHECK(says(done, "worst row: line 2, theta: error inf"));
    CHECK(says(done, "0.0 correct digits"));
}

TEST_CASE("verify refuses motions that contradict each other", "[command][verify]") {
    const auto refused = [](const std::string& csv, const words& options, const std::string& reason) {
        const auto done = verify(csv, options);
        INFO(csv);
        CHECK(done.exit_code == 2);
        CHECK(says(done, "f.csv:2: " + reason));
        CHECK(says(done, "1 rows, 0 ok, 0 miss, 1 malformed"));
    };
    refused("time,theta,gap,energy\n0.7,2.18,0.3,1.71\n", {}, "gap '0.3' contradicts energy '1.71'");
    refused("time,theta,theta0,omega0\n0.7,2.18,1,0\n", {"--gap", "0.5"}, "--gap '0.5' contradicts omega0 '0'");
    refused("time,theta,theta0,omega0,energy\n0.7,2.18,90deg,0,1.01\n", {}, "energy '1.01' contradicts omega0 '0'");
    refused("time,theta,energy\n0.7,2.18,1\n", {"--energy", "1.1"}, "energy '1' contradicts --energy '1.1'");
    refused("time,theta,energy\n0.7,2.18,1\n", {"--gap", "1.1"}, "--gap '1.1' contradicts energy '1'");
    refused("time,theta,theta0,omega0,direction\n0.7,2.18,1,-2,+\n", {}, "direction '+' contradicts omega0 '-2'");
    refused("time,theta,energy,length,gravity\n0.7,2.18,1,2,1\n", {"--length", "1", "--gravity", "1"},
            "length '2' contradicts --length '1'");
    // Consistent values are accepted: exactly, or as represented by doubles. In double, a gap of 1e-30 gives the energy
    // 2.
    CHECK(verdict_of("time,theta,theta0,omega0,energy\n0,1.5707963267948966,90deg,0,1\n", {"--gap", "1.0"}) == "ok");
    CHECK(verdict_of("time,theta,theta0,omega0,energy,gap\n0,2.5,2.5,-0.3,1.8461436155469336,0.1538563844530664\n") ==
          "ok");
    const auto next_to_2 = verify_rows("time,theta,energy,gap\n10,0,2.0,1e-30\n").rows.at(0);
    CHECK(next_to_2.at("reference") == verify_rows("time,theta,gap\n10,0,1e-30\n").rows.at(0).at("reference"));
}

TEST_CASE("verify takes the nearest double of 0 for 0", "[command][verify]") {
    CHECK(verdict_of("time,theta,theta0,omega0\n0,2.5,2.5,0\n", {"--inputs", "double"}) == "ok");
    CHECK(verdict_of("time,theta,energy\n0,0,0.0\n", {"--inputs", "double"}) == "ok");
    CHECK(verdict_of("time,theta,energy\n-0e5,1.0,0x0p0\n", {"--inputs", "double"}) == "miss");
    const auto [done, rows] = verify_rows("time,theta,gap\n0,3.14,1e400\n", {"--inputs", "double"});
    CHECK(says(done, "f.csv:2: gap '1e400' is beyond the largest double"));
}

TEST_CASE("verify uses columns of length and gravity", "[command][verify]") {
    // Gravity/length = 4 halves times, another row of the same file doubles them.
    const std::string head = "time,theta,energy,length,gravity\n";
    const std::string theta = theta_at_seven_tenths;
    const auto [done, rows] =
        verify_rows(head + "0.35," + theta + ",1.71,0.25,1\n1.4," + theta + ",1.71,4,1\n0.7," + theta + ",1.71,,\n");
    REQUIRE(rows.size() == 3);
    for (const table_row& row : rows) {
        CHECK(row.at("verdict") == "ok");
    }
    CHECK(says(verify(head + "0.35,1,1.71,0.25,\n"), "f.csv:2: length '0.25' comes without gravity"));
    CHECK(says(verify(head + "0.35,1,1.71,0,1\n"), "f.csv:2: length '0' is not positive"));
}

TEST_CASE("verify knows columns by common spellings and by --columns", "[command][verify]") {
    const std::string row = "0.7," + theta_at_seven_tenths + ",1.71\n";
    for (const std::string header : {"t,Theta,E", "Time [s],theta (rad),ENERGY", " T , \xCE\xB8 , energy"}) {
        INFO(header);
        CHECK(verdict_of(header + "\n" + row) == "ok");
    }
    CHECK(verdict_of("when,where,what\n" + row, {"--columns", "when=time,where=theta,what=energy"}) == "ok");
    // A redundant column: the energy is wrong, the gap is right.
    const std::string both = "time,theta,energy,gap\n0.7," + theta_at_seven_tenths + ",1,0.29\n";
    CHECK(verify(both).exit_code == 2);
    CHECK(verdict_of(both, {"--columns", "energy=-"}) == "ok");
    const auto refused = [&](const std::string& header, const std::string& mapping, const std::string& reason) {
        refuses(header + "\n" + row, {"--columns", mapping}, reason);
    };
    refused("a,b,c", "x=time",
            "--columns 'x=time' has 'x', which is not a column of 'f.csv': choose among 'a', 'b', 'c'");
    refused("a,b,c", "a=tme", "has 'tme', which is not a quantity: write time, ");
    refused("a,b,c", "a", "has 'a', which is not THEIRS=OURS");
    refused("t,T,theta", "theta=theta", "f.csv has two columns 'time': 't' and 'T'");
    // A message uses the column's name in the file.
    CHECK(says(verify("t,phi,E\n0.7,x,1.71\n", {"--columns", "phi=theta"}), "f.csv:2: phi 'x' is not a number"));
    CHECK(says(verify("t (s),theta,E\n1..0,1,1.71\n"), "f.csv:2: t (s) '1..0'"));
    CHECK(says(verify("t,theta,E\n1,2,-3\n"), "f.csv:2: E '-3' is a negative energy"));
    CHECK(says(verify("t,theta,E,th0\n1,2,1,3\n", {"--columns", "th0=theta0"}), "f.csv:2: th0 '3' is not reached"));
}

TEST_CASE("verify reads what radius reads, and what numpy.savetxt writes", "[command][verify]") {
    const std::string t = "7.000000000000000000e-01";
    const std::string theta = "2.182887871517687738e+00";
    for (const std::string csv :
         {"time;theta;energy\n0.7;2.18;1.71\n", "time\ttheta\tenergy\n0.7\t2.18\t1.71\n",
          "\xEF\xBB\xBF"
          "time theta  energy\r\n  0.7   2.18 \t 1.71\r\n",
          "# time theta energy\n0.7 2.18 1.71\n", "# made by us\n# time, theta, energy\n0.7 2.18 1.71\n# the end\n"}) {
        INFO(csv);
        const auto [done, rows] = verify_rows(csv);
        REQUIRE(rows.size() == 1);
        CHECK(rows[0].at("verdict") == "ok");
        CHECK(rows[0].at("theta") == "2.18");
    }
    const words named{"--columns", "time,theta", "--energy", "1.71"};
    CHECK(verdict_of(t + " " + theta + "\n", named) == "ok");
    CHECK(verdict_of(t + ";" + theta + "\n", named) == "ok");
    CHECK(says(verify(t + " " + theta + "\n", {"--energy", "1.71"}), "f.csv has no header: name its 2 columns"));
    CHECK(says(verify(t + " " + theta + "\n", {"--columns", "time"}), "has 1 names, and f.csv has 2 columns"));
}

TEST_CASE("verify takes theta modulo 2 pi where that is asked for", "[command][verify]") {
    // A rotation at E = 3 after a turn and a bit; the same less 2 pi, and more by 4 pi.
    const std::string head = "time,theta,energy\n";
    const precision_scope scope(60);
    const auto unwrapped = verify_rows(head + "5,0,3\n").rows.at(0).at("reference");
    for (const int turns : {-1, 0, 2}) {
        const std::string value = to_decimal(mpfr(number_of(unwrapped) + pi<mpfr>() * 2 * turns), 18);
        INFO(value);
        const auto row = verify_rows(head + "5," + value + ",3\n", {"--modulo-2pi"}).rows.at(0);
        CHECK(row.at("verdict") == "ok");
        CHECK_THAT(row.at("reference"), right_to_the_last_digit(value));
        CHECK(verdict_of(head + "5," + value + ",3\n") == (turns == 0 ? "ok" : "miss"));
    }
}

TEST_CASE("an exact value has all digits", "[command][verify]") {
    const auto [done, rows] = verify_rows(
        "time,theta,omega,theta0,omega0\n0,0.3,-0.7,0.3,-0.7\nT,0.3,-0.7,0.3,-0.7\n3T/2,-0.3,0.7,0.3,-0.7\n"
        "0,0.2,-0.7,0.3,-0.7\n0,0.30001,-0.7,0.3,-0.7\n");
    REQUIRE(rows.size() == 5);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK((rows[i].at("error") == "0" && rows[i].at("omega_error") == "0"));
        CHECK((rows[i].at("correct_digits") == "inf" && rows[i].at("omega_correct_digits") == "inf"));
    }
    CHECK(rows[3].at("verdict") == "ok");  // one unit of its last digit, no less
    CHECK((rows[4].at("error") == "0.0000100" && rows[4].at("correct_digits") == "4.4"));
    CHECK(says(done, "all correct digits:         3"));
    // E = 2 starts at the bottom with omega 2; 3 with sqrt 2.
    const auto at_start = verify_rows("time,theta,omega,energy\n0,0,2.0,2\n0,3.14,1.5,3.125\n").rows;
    CHECK((at_start.at(0).at("omega_correct_digits") == "inf" && at_start.at(1).at("omega_correct_digits") == "inf"));
}

TEST_CASE("where 0 is exact a scale takes the place of the value", "[command][verify]") {
    // A quarter period after rest; 3.3e-3 is an ordinary miss.
    const std::string csv =
        "time,theta,omega,energy\nT/4,6.123233995736766e-17,-1.849324200890693,1.71\n"
        "T/2,-2.3602945,-1.2246467991473532e-16,1.71\n0.7,2.1795,-0.61876,1.71\n";
    const auto [done, rows] = verify_rows(csv);
    REQUIRE(rows.size() == 3);
    // 6.1e-17 of 2.36 and 1.2e-16 of sqrt(2 * 1.71): -log10 is 16.58 and 16.17.
    CHECK((rows[0].at("verdict") == "ok" && rows[0].at("reference") == "0" && rows[0].at("correct_digits") == "16.5"));
    CHECK((rows[1].at("verdict") == "ok" && rows[1].at("omega_correct_digits") == "16.1"));
    CHECK(rows[2].at("verdict") == "miss");
    CHECK(says(done, "worst row: line 4, "));
    CHECK(verdict_of("time,theta,energy\nT/4,1e-3,1.71\n", {"--relative", "1e-3"}) == "ok");
    CHECK(verdict_of("time,theta,energy\nT/4,1e-2,1.71\n", {"--relative", "1e-3"}) == "miss");
    CHECK(verdict_of("time,theta,energy\nT/4,0.061232,1.71\n") == "miss");
}

TEST_CASE("verify has a relative tolerance, alone and beside an absolute one", "[command][verify]") {
    const std::string head = "time,theta,energy\n0.7,";
    // 2.18 is 0.00289 away, 1.32e-3 of the value.
    CHECK(verdict_of(head + "2.1800,1.71\n", {"--relative", "1.33e-3"}) == "ok");
    CHECK(verdict_of(head + "2.1800,1.71\n", {"--relative", "1.32e-3"}) == "miss");
    CHECK(verdict_of(head + "2.1800,1.71\n", {"--relative", "1e-9", "--tolerance", "0.003"}) == "ok");
    CHECK(verdict_of(head + "2.1800,1.71\n", {"--relative", "1e-2", "--tolerance", "1e-9"}) == "ok");
    CHECK(verdict_of(head + "2.1800,1.71\n", {"--relative", "1e-9", "--tolerance", "1e-9"}) == "miss");
}

TEST_CASE("verify writes JSON", "[command][verify]") {
    const auto done =
        verify("time,theta,energy,note\n0.7,2.18,1.71,\"a \"\"b\"\"\"\n0.7,two,1.71,\n", {"--format", "json"});
    CHECK(done.exit_code == 2);
    const auto rows = nlohmann::json::parse(done.out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("note") == "a \"b\"");
    CHECK((rows[0].at("verdict") == "ok" && rows[0].at("error") == "0.00289"));
    CHECK((rows[1].at("verdict") == "malformed" && rows[1].at("error").is_null()));
}

TEST_CASE("verify compares elliptic functions", "[command][verify]") {
    // mpmath, mp.dps = 40: ellipfun('sn', 0.7, m=0.3), 'cd'; ellipk(0.3), ellipe(-3), ellippi(0.25, 0.3),
    // ellipe(2, 0.3), asin(ellipfun('sn', ...)).
    const auto jacobi =
        verify_rows("u,m,sn,cd,am\n0.7,0.3,0.63230477631086454908,0.825827174402893594,0.6845246\n").rows;
    CHECK(jacobi.at(0).at("verdict") == "ok");
    CHECK_THAT(jacobi.at(0).at("reference"), right_to_the_last_digit("0.6845245936612939594588310516786254909193"));
    CHECK_THAT(jacobi.at(0).at("cd_reference"), right_to_the_last_digit("0.8258271744028935938916755988440416300621"));
    CHECK(verdict_of("k,K\n0.54772255750516611346,1.71388944817879\n") == "ok");
    CHECK(verdict_of("m1,E\n4,2.422112055136919050\n") == "ok");
    CHECK(verdict_of("m,n,Pi\n0.3,0.25,1.99173885354569\n") == "ok");
    CHECK(verdict_of("m,phi,E\n0.3,2,1.808964725363331\n") == "ok");
    CHECK(verdict_of("m,phi,E\n0.3,2,1.808964725363332\n", {"--relative", "1e-16"}) == "miss");
    CHECK(verdict_of("m,K\n1,inf\n") == "ok");
    CHECK(verdict_of("m,K\n1,1e300\n") == "miss");
    CHECK(verdict_of("parameter,K\n0.3,1.71388944817879\n", {"--columns", "parameter=m"}) == "ok");
    CHECK(verdict_of("u,m,sn\n0,0.3,1e-17\n", {"--relative", "1e-15"}) == "ok");
    CHECK(verify_rows("u,m,am\n0.7,0,0.7\n").rows.at(0).at("correct_digits") == "inf");
    CHECK(says(verify("m,sn\n0.3,0.6\n"), "f.csv has no column 'u', the argument of sn"));
    CHECK(says(verify("m,Pi\n0.3,0.6\n"), "f.csv has no column 'n'"));
    CHECK(says(verify("m,k,K\n0.3,0.6,1\n"), "f.csv has both 'k' and 'm'"));
    CHECK(says(verify("m,K\n2,1\n"), "f.csv:2: m '2' is above 1, where K is not real"));
    CHECK(says(verify("m,K\n0.3,1\n", {"--energy", "1"}), "--energy '1' has no meaning for elliptic functions"));
    CHECK(says(verify("u,m,sn\nx,0.3,1\n"), "f.csv:2: u 'x' is not a number"));
    CHECK(says(verify("u,m,sn\n1,0.3,?\n"), "f.csv:2: sn '?' is not a number"));
}

TEST_CASE("verify compares elliptic functions of complex arguments", "[command][verify]") {
    // mpmath, mp.dps = 45: ellipfun('sn', mpc('0.7', '1.2'), m=mpf('0.3')), 'dc'; at m = 2, K(2) is complex, and
    // sn(1.2i|0.3) = i sc(1.2|0.7).
    const std::string head = "u_re,u_im,m,sn_re,sn_im,dc_im\n";
    const auto row =
        verify_rows(head + "0.7,1.2,0.3,1.28667283558101798,0.928044558960483513,0.235787434610773460\n").rows.at(0);
    CHECK(row.at("verdict") == "ok");
    CHECK_THAT(row.at("reference"), right_to_the_last_digit("1.28667283558101798180149601441822329971371"));
    CHECK_THAT(row.at("sn_im_reference"), right_to_the_last_digit("0.928044558960483512883160300913089008960405"));
    CHECK_THAT(row.at("dc_im_reference"), right_to_the_last_digit("0.23578743461077345982139872203072922884816"));
    CHECK(verdict_of(head + "0.7,1.2,0.3,1.28667283558101798,0.928044558960483513,0.235787434610773462\n") == "miss");
    CHECK(verdict_of("u,m,sn_re\n0.7+1.2i,0.3,1.286672835581018\n") == "ok");
    CHECK(verdict_of("u,m,sn_re\n0.7-1.2i,0.3,1.286672835581018\n") == "ok");
    CHECK(verdict_of("u,m,sn_im\n0.7-1.2i,0.3,0.928044558960484\n") == "miss");
    // Exact zeros, measured by the size of the value; poles; a real argument.
    CHECK(verify_rows("u,m,sn_re,sn_im\ni,0.5,0,1.34737147138541895\n").rows.at(0).at("correct_digits") == "inf");
    CHECK(verdict_of("u,m,sn_re\ni,0.5,1e-17\n", {"--relative", "1e-15"}) == "ok");
    CHECK(verdict_of("u,m,sn_re\npi/2*i,1,inf\n") == "ok");
    CHECK(verdict_of("u,m,sn_re\npi/2*i,1,1e300\n") == "miss");
    CHECK(verdict_of("u,m,sn_re,sn_im\n0.7,0.3,0.63230477631086454908,0\n") == "ok");
    // The doubles next to the arguments.
    CHECK(verdict_of("u_re,u_im,m,sn_re\n0.7,1.2,0.3,1.28667283558101798180\n", {"--inputs", "double"}) == "miss");
    CHECK(says(verify("u,m,sn\n1+2i,0.5,1\n"), "f.csv:2: u '1+2i' is complex: give the columns sn_re and sn_im"));
    CHECK(says(verify("u,m,am\n1+2i,0.5,1\n"), "f.csv:2: u '1+2i' is complex, which am does not take"));
    CHECK(says(verify("u,m,sn_re\n1+2x,0.5,1\n"), "f.csv:2: u '1+2x' is not a number"));
    CHECK(says(verify("u_im,m,sn_re\n1,0.5,1\n"), "f.csv has 'u_im' alone of u_re and u_im"));
    CHECK(says(verify("u,m,sn,sn_im\n1,0.5,1,1\n"), "f.csv has both 'sn' and 'sn_im'"));
    CHECK(says(verify("u,m,am_re\n1,0.5,1\n"), "f.csv has no column"));
}

TEST_CASE("verify shows what it quotes short and without control characters", "[command][verify]") {
    const std::string head = "time,theta,energy\n";
    CHECK(says(verify(head + "0.7,\x1b[2J" + std::string(1, '\0') + "x,1.71\n"),
               "f.csv:2: theta '\\x1b[2J\\0x' is not a number"));
    const auto done = verify(head + "0.7,2.18," + std::string(100'000, '9') + "x\n");
    CHECK(says(done, "f.csv:2: energy '" + std::string(60, '9') + "...' "));
    CHECK(done.err.size() < 1000);
    CHECK(verify(std::string(1'000'000, 'a') + "\n1\n").err.size() < 1000);
}

// z = sin t is 0 at pi, which cannot be decided at any precision.
TEST_CASE("verify names the value that is not decided", "[command][verify]") {
    const auto done = verify("time,w,z\npi,1,0\n",
                             {"--problem", "w' = 0; z'' = -z; w(0) = 1; z(0) = 0; z'(0) = 1", "--relative", "1e-10"});
    CHECK(done.exit_code == 1);
    CHECK(says(done, "z is not decided by"));
}

// z = tan t, and the unknowns of the equations are in a different order than in the file.
TEST_CASE("verify compares unknowns beyond the end of others that they do not depend on", "[command][verify]") {
    const auto rows = csv_rows(verify("time,z,w\n1.2,2.572151622126319,-1.2\n1.5,14.10141994717172,-1.25\n",
                                      {"--problem", "y' = y^2; w' = -1; z' = 1 + z^2; y(0)=1; z(0)=0; w(0)=0"})
                                   .out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("verdict") == "ok");
    CHECK(rows[1].at("verdict") == "miss");
    CHECK(rows[1].at("z_reference").starts_with("14.10141994717171938"));
    CHECK(rows[1].at("reference").starts_with("-1.5"));
}

// sin^2 t + cos^2 t - 1 = 0, which cannot be proved at any precision.
TEST_CASE("verify accepts a value within its tolerance of a truth that is not told from 0", "[command][verify]") {
    const auto rows = csv_rows(verify("time,y\n1,0\n2,1e-30\n3,1e-10\n",
                                      {"--problem", "y' = 2*sin(t)*cos(t) - sin(2*t); y(0)=0", "--tolerance", "1e-20"})
                                   .out);
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].at("verdict") == "ok");
    CHECK(rows[0].at("reference").empty());
    CHECK(rows[1].at("verdict") == "ok");
    CHECK(rows[2].at("verdict") == "miss");
}

TEST_CASE("verify writes the same bytes with any number of threads", "[command][verify]") {
    std::string csv = "time,theta,energy\n";
    for (int i = 0; i < 1000; ++i) {
        csv += std::to_string(i) + "e-2,0.5,1." + std::to_string(i / 3) + "\n";
    }
    CHECK(verify(csv, {"--jobs", "1"}).out == verify(csv, {"--jobs", "3"}).out);
    const temporary_folder folder;
    std::ofstream(folder.path() / "f.csv", std::ios::binary) << csv;
    const auto piped = run_libration({"verify", "-", "--out", "o.csv"}, folder.path(), folder.path() / "f.csv");
    CHECK(piped.out.empty());
    CHECK(text_of_file(folder.path() / "o.csv") == verify(csv).out);
}

// The doubles of tan 1/2 and tan 1, and one that is a unit away, as "%.18e" prints them (Python).
TEST_CASE("verify takes decimals of doubles for these", "[command][verify]") {
    const words tangent{"--problem", "x' = 1 + x^2; x(0) = 0"};
    const std::string exactly_rounded = "t,x\n0.5,5.463024898437904842e-01\n1,1.557407724654902292e+00\n";
    const auto done = verify(exactly_rounded, tangent);
    CHECK(done.exit_code == 0);
    CHECK(says(done, "doubles in decimal: 'x': without another tolerance, within half a unit in the last place"));
    const auto [missed, rows] = verify_rows("t,x\n0.5,5.463024898437904842e-01\n1,1.557407724654902070e+00\n", tangent);
    CHECK(missed.exit_code == 1);
    CHECK(rows.at(0).at("verdict") == "ok");
    CHECK(rows.at(1).at("verdict") == "miss");
    CHECK_FALSE(says(verify(exactly_rounded, tangent + words{"--ulp", "1"}), "doubles in decimal"));
    // 19 correct digits are not those of a double.
    const auto right = verify("t,x\n0.5,5.463024898437905133e-01\n1,1.557407724654902231e+00\n", tangent);
    CHECK(right.exit_code == 0);
    CHECK_FALSE(says(right, "doubles in decimal"));
}

// tan 1 = 1.5574077...
TEST_CASE("verify judges printed tables by half a unit", "[command][verify]") {
    const words tangent{"--problem", "x' = 1 + x^2; x(0) = 0"};
    const std::string table = "t,x\n1,1.557407\n";
    CHECK(verdict_of(table, tangent) == "ok");
    CHECK(verdict_of(table, tangent + words{"--rounding"}) == "miss");
    CHECK(verdict_of("t,x\n1,1.557408\n", tangent + words{"--rounding"}) == "ok");
}

TEST_CASE("verify names the row with the fewest correct digits as the worst", "[command][verify]") {
    // 2e-6 of 1e-3 leaves 2.69 digits; 5e-5 of 1000, five times its tolerance, 7.30.
    const auto done = verify("t,x\n0.001,0.001002\n1000,1000.00005\n", {"--problem", "x' = 1; x(0) = 0"});
    CHECK(says(done, "worst row: line 2, x: error 2.00e-6, 2.00 times the tolerance, 2.6 correct digits"));
}

TEST_CASE("verify recognises one mistake in all rows", "[command][verify]") {
    const words circle{"--problem", "x' = -y; y' = x; x(0) = 1; y(0) = 0", "--tolerance", "1e-6"};
    const auto mistake = [&](const std::string& rows) { return verify("t,x,y\n" + rows, circle); };
    CHECK(says(mistake("1,0.84147098,0.54030231\n2,0.90929743,-0.41614684\n3,0.14112001,-0.98999250\n"),
               "probable mistake: 'x' and 'y' are exchanged: in the other order with errors "));
    // cos and sin at 1.01, 2.01, 3.01.
    CHECK(says(mistake("1,0.53186072,0.84683184\n2,-0.42521885,0.90509056\n3,-0.99135417,0.13121319\n"),
               "probable mistake: the times are off by a constant: the values are those of times 0.0100 later, "));
    const std::string swing = "time,theta,energy\n0.7,125.0702622,1.71\n0,135.2349,1.71\nT,135.2349,1.71\n";
    CHECK(says(verify(swing), "probable mistake: 'theta' in degrees instead of radians: in radians with errors "));
    // Two rows are not enough, and one error is not in all rows.
    CHECK_FALSE(says(mistake("1,0.84147098,0.54030231\n2,0.90929743,-0.41614684\n"), "mistake"));
    CHECK_FALSE(says(mistake("1,0.54030231,0.84147098\n2,-0.41614684,0.90929743\n3,-0.99,0.1\n"), "mistake"));
}

// K(sin 30deg) is that of m = 1/4 [Abramowitz, table 17.2].
TEST_CASE("verify reads the modular angle of Abramowitz and Stegun", "[command][verify]") {
    for (const char* const file : {"alpha,K\n30deg,1.68575035481260\n", "alpha (deg),K\n30,1.68575035481260\n",
                                   "Alpha,K\npi/6,1.68575035481260\n", "m,K\n1/4,1.68575035481260\n"}) {
        CAPTURE(file);
        CHECK(verdict_of(file) == "ok");
    }
    CHECK(verdict_of("alpha,K\n30,1.68575035481260\n") == "miss");
    CHECK(output_of({"elliptic", "K", "--alpha", "30deg"}).find("1.6857503548125960") != std::string::npos);
}

}  // namespace command_verify_test
