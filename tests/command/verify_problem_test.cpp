// `libration verify`: unknowns of equations with closed forms.
#include <catch2/catch.hpp>
#include <string>

#include "command/verified.hpp"

namespace command_verify_problem_test {

using namespace libration;
using namespace libration::tests;
using namespace libration::tests::verifying;

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

// n = exp(-t), in the column n_ of tables.
TEST_CASE("tables and --columns accept the name of an unknown in another column", "[command][verify]") {
    const std::string decay = "n' = -n; n(0) = 1";
    const auto rows = csv_rows(verify("time,n\n1,0.36787944117\n2,0.12\n", {"--problem", decay}).out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("verdict") == "ok");
    CHECK(rows[1].at("verdict") == "miss");
    const auto printed = run_libration(
        {"reference", "--problem", decay, "--time", "1", "--columns", "n", "--format", "csv", "--digits", "20"});
    CHECK(printed.out == "n_\n0.36787944117144232160\n");
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

// exp(1) and exp(-1), the second to fewer digits.
TEST_CASE("verify counts the digits of the value with the fewest", "[command][verify]") {
    const auto done = verify("time,x,y\n1,2.71828182845904523536,0.36787944118\n",
                             {"--problem", "x' = x; y' = -y; x(0) = 1; y(0) = 1"});
    CHECK(says(done, "    10 correct digits:         1"));
    CHECK_FALSE(says(done, "    20 correct digits:"));
}

// A column that is not compared is named, so that nobody takes it for one that is.
TEST_CASE("verify refuses a column that it cannot compare", "[command][verify]") {
    const std::string oscillator = "x'' = -x; x(0) = 1; x'(0) = 0";
    const std::string rows = "t,x,v\n1,0.54030230586813971740,-0.5\n";
    const auto refused = verify(rows, {"--problem", oscillator});
    CHECK(refused.exit_code == 2);
    CHECK(says(refused, "has the column 'v', which is none of 'x', 'x'': write --rename v=- to leave it out, or v=x'"));
    CHECK(verify(rows, {"--problem", oscillator, "--columns", "v=-"}).exit_code == 0);
    const auto compared = verify(rows, {"--problem", oscillator, "--columns", "v=x'"});
    CHECK(compared.exit_code == 1);
    CHECK(says(compared, "v misses"));
}

// A dose of 2 at time 1 of what decays as e^-t, and a rate that changes at 1: by hand.
TEST_CASE("verify compares solutions with events and piecewise right-hand sides", "[command][verify][hybrid]") {
    const auto doses = verify("time,x\n0,1\n0.5,0.60653065971263342360\n2,0.87109416557949733509\n3,0.3200\n",
                              {"--problem", "x' = -x; x(0) = 1; when t = 1: x = x + 2"});
    const auto rows = csv_rows(doses.out);
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].at("verdict") == "ok");
    CHECK(rows[1].at("verdict") == "ok");
    CHECK(rows[2].at("verdict") == "ok");
    CHECK(rows[3].at("verdict") == "miss");
    CHECK(rows[3].at("reference").starts_with("0.3204576"));
    CHECK(doses.exit_code == 1);
    CHECK(verify("time,y\n3,5\n0.5,0.5\n", {"--problem", "y' = if(t < 1 or t > 2, 1, 3); y(0) = 0"}).exit_code == 0);
    const auto before = verify("time,y\n-1,5\n", {"--problem", "y' = abs(t); y(0) = 0"});
    CHECK(says(before, "is before the initial point"));
}

}  // namespace command_verify_problem_test
