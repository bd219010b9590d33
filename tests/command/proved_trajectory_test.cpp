// libration trajectory with proved arithmetic: the values of mpfr, the zeros of symmetry, and its error column.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"

namespace command_proved_trajectory_test {

using namespace libration;
using namespace libration::tests;

namespace {

words trajectory(const words& motion, const words& method, const std::string& times, const std::string& scalar) {
    words line{"trajectory"};
    line.insert(line.end(), motion.begin(), motion.end());
    line.insert(line.end(), method.begin(), method.end());
    line.insert(line.end(), {"--times", times, "--scalar", scalar});
    return line;
}

rational value_of(const std::string& text) { return read_exact(text).coefficient; }

rational power_of_ten(long n) { return {integer(boost::multiprecision::pow(integer(10), static_cast<unsigned>(n)))}; }

}  // namespace

TEST_CASE("proved trajectories are those of mpfr, by every method", "[command][ball]") {
    for (const words& motion : {words{"--energy", "1.71"}, words{"--gap", "-1e-9"}, words{"--energy", "4"},
                                words{"--theta0", "2.5", "--omega0", "-0.3", "--length", "0.7", "--gravity", "9.81"}}) {
        for (const words& method :
             {words{}, words{"--method", "series", "--order", "12"}, words{"--method", "resummed", "--order", "12"},
              words{"--method", "uniform", "--order", "12"}}) {
            INFO(motion[1] << " " << (method.empty() ? "exact" : method[1]));
            const auto proved = rows_of(trajectory(motion, method, "0.7,T/8,-3e5", "ball:25"));
            const auto rounded = rows_of(trajectory(motion, method, "0.7,T/8,-3e5", "mpfr:35"));
            REQUIRE(proved.size() == 3);
            for (std::size_t i = 0; i < proved.size(); ++i) {
                for (const char* column : {"theta", "omega"}) {
                    // One unit of the 25th digit and the rounding of the 35th.
                    const rational truth = value_of(rounded[i].at(column));
                    const rational difference = abs(rational(value_of(proved[i].at(column)) - truth));
                    CHECK(significant_digits(proved[i].at(column)) == 25);
                    CHECK(rational(difference * power_of_ten(24)) <= abs(truth));
                }
                // Where the method has an error, both agree on it to six digits.
                if (!method.empty() && value_of(proved[i].at("error")) > rational(1) / power_of_ten(15)) {
                    const rational error = value_of(rounded[i].at("error"));
                    const rational miss = abs(rational(value_of(proved[i].at("error")) - error));
                    CHECK(rational(miss * power_of_ten(5)) <= error);
                }
            }
        }
    }
}

TEST_CASE("what symmetry makes 0 is printed as 0, and what it makes a fraction has the error 0", "[command][ball]") {
    const auto rest = rows_of(trajectory({"--theta0", "90deg", "--omega0", "0"}, {}, "0,T/4,T/2", "ball:20"));
    CHECK(rest[0].at("omega") == "0");
    CHECK(rest[1].at("theta") == "0");
    CHECK(rest[1].at("error") == "0");
    CHECK(rest[2].at("omega") == "0");
    // The uniform resummation is nonzero at the bottom, but its slope vanishes at the top.
    const auto uniform =
        rows_of(trajectory({"--energy", "1"}, {"--method", "uniform", "--order", "12"}, "0,T/4,T/2", "ball:20"));
    CHECK(uniform[0].at("omega") == "0");
    CHECK(uniform[1].at("theta") != "0");
    CHECK(significant_digits(uniform[1].at("theta")) == 20);
    CHECK(uniform[2].at("omega") == "0");
    const auto start = rows_of(trajectory({"--theta0", "0.1", "--omega0", "0.2"}, {}, "0,T/2,-T,1", "ball:20"));
    CHECK(start[0].at("error") == "0");
    CHECK(value_of(start[1].at("theta")) == rational(-1, 10));
    CHECK(start[1].at("error") == "0");
    CHECK(start[2].at("error") == "0");
    CHECK(start[3].at("error") != "0");
}

TEST_CASE("whole periods of a start turned by whole turns are decided by symmetry", "[command][ball]") {
    for (const std::string scalar : {"ball:30", "mpfr:30"}) {
        const auto rows = rows_of(trajectory({"--theta0", "7", "--omega0", "-0.15"}, {}, "T,1,-3T,T/2", scalar));
        REQUIRE(rows.size() == 4);
        for (const std::size_t whole : {0U, 2U}) {
            CHECK(value_of(rows[whole].at("theta")) == 7);
            CHECK(rows[whole].at("error") == "0");
            CHECK(value_of(rows[whole].at("omega")) == rational(-15, 100));
        }
        // Half a period later it is at the same distance on the other side of 2 pi.
        CHECK(rows[3].at("theta").starts_with("5.56637061435917295385"));
        CHECK(rows[3].at("error") != "0");
    }
}

TEST_CASE("on the separatrix and at rest trajectories are proved too", "[command][ball]") {
    const auto critical = rows_of(trajectory({"--energy", "2"}, {}, "0,3", "ball:20"));
    CHECK(critical[0].at("theta") == "0");
    CHECK(critical[1].at("theta") == rows_of(trajectory({"--energy", "2"}, {}, "3", "mpfr:20"))[0].at("theta"));
    const auto top = rows_of(trajectory({"--theta0", "pi", "--omega0", "0"}, {}, "5", "ball:20"));
    CHECK(top[0].at("theta") == "3.1415926535897932385");
    CHECK(top[0].at("omega") == "0");
}

}  // namespace command_proved_trajectory_test
