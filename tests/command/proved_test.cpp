// Proved output: the output of `--scalar ball:DIGITS` contains the true value, and agrees with that of other
// arithmetics.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/reference_motion.hpp"

namespace command_proved_test {

using namespace libration;
using namespace libration::tests;

namespace {

using words = std::vector<std::string>;

rational value_of(const std::string& text) { return read_exact(text).coefficient; }

}  // namespace

TEST_CASE("proved coefficients contain the table within their uncertainty", "[command][ball]") {
    for (const std::string energy : {"0.5", "1", "1.71", "1.9998", "2.02", "10"}) {
        for (const std::string at : {"top", "bottom"}) {
            const auto printed =
                rows_of({"coefficients", "--energy", energy, "--order", "40", "--at", at, "--scalar", "ball:45"});
            REQUIRE(printed.size() == 41);
            for (const table_row& row : reference_table("coefficients.csv")) {
                if (row.at("energy") != energy || row.at("at") != at) {
                    continue;
                }
                INFO("E = " << energy << " from the " << at << ", n = " << row.at("n"));
                const table_row& own = printed.at(static_cast<std::size_t>(std::stoi(row.at("n"))));
                CHECK(own.at("n") == row.at("n"));
                const rational truth = value_of(row.at("coefficient"));
                const rational of_table = abs(truth) / rational(boost::multiprecision::pow(integer(10), 59));
                CHECK(abs(rational(value_of(own.at("coefficient")) - truth)) <=
                      value_of(own.at("uncertainty")) + of_table);
                // Below one unit of the 45th digit; exactly 0 if the coefficient is.
                CHECK(value_of(own.at("uncertainty")) * boost::multiprecision::pow(integer(10), 44) <= abs(truth));
            }
        }
    }
}

TEST_CASE("proved periods are those of mpfr, in every regime", "[command][ball]") {
    for (const words& motion :
         {words{"--energy", "1.71"}, words{"--gap", "1e-100"}, words{"--gap", "-1e-20"}, words{"--energy", "0"},
          words{"--theta0", "2.5", "--omega0", "-0.3"}, words{"--energy", "2"},
          words{"--theta0", "90deg", "--omega0", "0", "--length", "0.7", "--gravity", "9.81"}}) {
        for (const words& method : {words{}, words{"--method", "resummed", "--order", "5"}}) {
            if (motion[1] == "2" && !method.empty()) {
                continue;
            }
            words proved{"period"};
            proved.insert(proved.end(), motion.begin(), motion.end());
            proved.insert(proved.end(), method.begin(), method.end());
            proved.insert(proved.end(), {"--scalar"});
            words rounded = proved;
            proved.emplace_back("ball:40");
            rounded.emplace_back("mpfr:45");
            const table_row own = rows_of(proved).front();
            const table_row other = rows_of(rounded).front();
            for (const std::string column : {"period", "tstar"}) {
                INFO(motion[0] << " " << motion[1] << ", " << column);
                if (other.at(column) == "inf") {
                    CHECK(own.at(column) == "inf");
                    continue;
                }
                const rational digits = boost::multiprecision::pow(integer(10), 39);
                CHECK(abs(rational(value_of(own.at(column)) - value_of(other.at(column)))) * digits <=
                      value_of(other.at(column)));
            }
        }
    }
}

TEST_CASE("coefficients that vanish are printed as 0, and only they", "[command][ball]") {
    // a_3 = -cos(theta0) omega0/6 at an initial point without symmetry.
    const auto level =
        rows_of({"coefficients", "--theta0", "90deg", "--omega0", "0.5", "--order", "6", "--scalar", "ball:20"});
    for (std::size_t n = 1; n < level.size(); ++n) {
        CHECK((level[n].at("coefficient") == "0") == (n == 3));
    }
    const auto top = rows_of({"coefficients", "--energy", "2.5", "--order", "9", "--scalar", "ball:20"});
    for (std::size_t n = 1; n < top.size(); ++n) {
        CHECK((top[n].at("coefficient") == "0") == (n % 2 == 0 || n == 5));
    }
}

}  // namespace command_proved_test
