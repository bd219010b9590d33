// `libration verify`: verdicts by tolerances, units and digits.
#include <catch2/catch.hpp>
#include <string>

#include "command/verified.hpp"

namespace command_verify_tolerance_test {

using namespace libration;
using namespace libration::tests;
using namespace libration::tests::verifying;

TEST_CASE("verify takes one unit of the last digit as written", "[command][verify]") {
    CHECK(verdict_of("time,theta,energy\n0.7,2.18,1.71\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0.7,2.19,1.71\n") == "ok");
    CHECK(verdict_of("time,theta,energy\n0.7,2.20,1.71\n") == "miss");
    CHECK(verdict_of("time,theta,energy\n0.7,2.190,1.71\n") == "miss");
    CHECK(verdict_of("time,theta,energy\n0.7,218e-2,1.71\n") == "ok");
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

TEST_CASE("verify takes nan for a miss and counts it as the worst", "[command][verify]") {
    const auto [done, rows] = verify_rows("time,theta,energy\n0.7,-nan,1.71\n0.7,2.18,1.71\n");
    CHECK(done.exit_code == 1);
    CHECK(rows.at(0).at("verdict") == "miss");
    CHECK(rows.at(0).at("error") == "inf");
    CHECK(says(done, "worst row: line 2, theta: error inf"));
    CHECK(says(done, "0.0 correct digits"));
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

// cos of the doubles of pi/2 and 3 pi/2 (Python: "%.18e" % math.cos(math.pi/2)), which those of the decimals miss by one
// part in 10^5.
TEST_CASE("verify takes times for doubles that were printed so", "[command][verify]") {
    const words cosine{"--problem", "x'' = -x; x(0) = 1; x'(0) = 0"};
    const std::string rows =
        "t,x\n1.570796326794896558e+00,6.123233995736766036e-17\n4.712388980384689674e+00,-1.836970198721029688e-16\n";
    const auto done = verify(rows, cosine);
    CHECK(done.exit_code == 0);
    CHECK(says(done, "doubles in decimal: 't': the values are compared at these doubles"));
    CHECK(verify(rows, cosine + words{"--inputs", "double"}).exit_code == 0);
    const auto as_typed = verify(rows, cosine + words{"--inputs", "decimal"});
    CHECK(as_typed.exit_code == 1);
    CHECK_FALSE(says(as_typed, "at these doubles"));
    // Short decimals are as typed, but not beside others that have all digits of a double.
    CHECK_FALSE(says(verify("t,x\n0.1,0.995\n", cosine), "at these doubles"));
    CHECK(says(verify(rows + "0.1,0.995\n", cosine), "at these doubles"));
    CHECK_FALSE(says(verify(rows + "0.1000000000000000001,0.995\n", cosine), "at these doubles"));
    // A motion in other columns is a double only where it is exactly one.
    const auto of_motion = [&](const std::string& angle) {
        return says(verify("time,theta,theta0,omega0\n1.570796326794896558e+00,0.5," + angle + ",0\n"),
                    "at these doubles");
    };
    CHECK(of_motion("0.5"));
    CHECK(of_motion("1.000000000000000056e-01"));
    CHECK_FALSE(of_motion("0.1"));
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

}  // namespace command_verify_tolerance_test
