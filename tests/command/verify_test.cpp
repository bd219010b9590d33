// `libration verify`: verdicts against mpmath and closed forms, what it reads, and what it refuses.
#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "command/printed.hpp"

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

// The judged rows of a file without quotes.
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
    const auto by_gap = verify_rows(head + "1,0.29,,,0.7," + theta_at_seven_tenths + "\n");
    CHECK(by_gap.rows.at(0).at("verdict") == "ok");
    const auto state = verify_rows(head + "1.71,0.29,90deg,0,0.7,1.33\n").rows.at(0);
    const auto energy = verify_rows("time,theta,energy\n0.7,1.33,1\n").rows.at(0);
    CHECK(state.at("reference") == energy.at("reference"));
    CHECK(state.at("verdict") == energy.at("verdict"));
}

TEST_CASE("verify serves files without a motion by options", "[command][verify]") {
    const std::string csv = "time,theta\n0.7," + theta_at_seven_tenths + "\n";
    CHECK(verdict_of(csv, {"--energy", "1.71"}) == "ok");
    CHECK(verdict_of(csv, {"--gap", "0.29"}) == "ok");
    CHECK(verdict_of(csv, {"--energy", "1.7"}) == "miss");
    // Seconds: gravity/length = 4 makes 0.35 s of 0.7.
    CHECK(verdict_of("time,theta\n0.35," + theta_at_seven_tenths + "\n",
                     {"--gap", "0.29", "--length", "0.25", "--gravity", "1"}) == "ok");
}

TEST_CASE("verify knows the direction of a rotation and judges omega", "[command][verify]") {
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
    CHECK(says(done, "f.csv:8: has no motion"));
    CHECK(says(done, "f.csv:9: a quote is not closed"));
    CHECK(says(done, "f.csv:10: theta misses by 0.997"));
    CHECK(says(done, "f.csv:11: has no theta"));
    CHECK(says(done, "f.csv:12: theta '1/2' is not a number"));
    CHECK(says(done, "11 rows, 2 ok, 1 miss, 8 malformed"));
    const auto lines = lines_of(done.out);
    REQUIRE(lines.size() == 12);
    CHECK(lines[2] == "0.7,two,1.71,,,,malformed,");
    CHECK(lines[3] == "0.7,2.18,,,,,malformed,");
    CHECK(lines[7] == "\"0.7,\"\"2.18,1.71\",,,,,,malformed,");
    CHECK(lines[11].starts_with("0.7,2.18,1.71,2.18288787151768773795,"));
}

TEST_CASE("verify says which columns are missing", "[command][verify]") {
    const auto done = verify("t,angle\n1,2\n", {"--energy", "1"});
    CHECK(done.exit_code == 2);
    CHECK(done.out.empty());
    CHECK(says(done, "f.csv has no column 'time', 'theta': its columns are 't', 'angle'"));
    CHECK(says(verify("time,theta\n1,2\n"), "f.csv has no motion: its columns are 'time', 'theta'"));
    CHECK(says(verify("time,theta,theta\n1,2,2\n"), "f.csv has two columns 'theta'"));
    CHECK(verify("").exit_code == 2);
    CHECK(says(verify(""), "f.csv has no header"));
    CHECK(says(verify("time,theta,energy\n"), "f.csv has no row to judge"));
    CHECK(run_libration({"verify", "none.csv"}).exit_code == 2);
    CHECK(verify("time,theta,energy\n0,1,1\n", {"--ulp", "1", "--tolerance", "1"}).exit_code == 2);
    CHECK(verify("time,theta,energy\n0,1,1\n", {"--inputs", "float"}).exit_code == 2);
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
    // A gap is a small number that a double holds to its own digits.
    const std::string by_gap = "time,theta,gap\n9.75,0.1,1e-8\n";
    CHECK(number_of(verify_rows(by_gap).rows.at(0).at("condition")) < 30);
}

TEST_CASE("verify judges in units in the last place of doubles", "[command][verify]") {
    // The double of theta: 2.1828878715176877; one unit is 2^-51 = 4.4e-16 from 2 on.
    const std::string head = "time,theta,energy\n0.7,";
    CHECK(verdict_of(head + "2.1828878715176877,1.71\n", {"--ulp", "0.5"}) == "ok");
    CHECK(verdict_of(head + "2.1828878715176882,1.71\n", {"--ulp", "1"}) == "miss");
    CHECK(verdict_of(head + "2.1828878715176882,1.71\n", {"--ulp", "2"}) == "ok");
    // Our own double code, given the gap.
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
    // Independent of ours: `libration trajectory` by mpfr and its own clock.
    for (const words& motion : {words{"--energy", "1.71"}, words{"--theta0", "2.5", "--omega0", "-0.3"},
                                words{"--energy", "3", "--direction", "-"}, words{"--theta0", "pi", "--omega0", "0"},
                                words{"--theta0", "120deg", "--omega0", "1"}, words{"--energy", "0"}}) {
        INFO(command_line(motion));
        const auto theirs =
            output_of(words{"trajectory", "--times", "0,0.7,40,1e20", "--digits", "40", "--format", "csv"} + motion);
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
    CHECK(says(done, "worst row: line 2, error inf"));
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

}  // namespace command_verify_test
