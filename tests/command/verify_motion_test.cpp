// `libration verify`: the motion of a row, and its inputs, by closed forms and mpmath.
#include <catch2/catch.hpp>
#include <string>

#include "command/verified.hpp"

namespace command_verify_motion_test {

using namespace libration;
using namespace libration::tests;
using namespace libration::tests::verifying;

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

}  // namespace command_verify_motion_test
