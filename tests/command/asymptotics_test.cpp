// `libration asymptotics`: its contract, closed forms, and errors.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/refusal.hpp"

namespace command_asymptotics_test {

using namespace libration;
using namespace libration::tests;

using line = std::vector<std::string>;

// (1 - 2t)^(-1/2): a_n = binomial(2n, n)/2^n, a_10 = 184756/1024, and a_n -> 2^n/sqrt(pi n).
TEST_CASE("the law of a branch point as rows", "[command][asymptotics]") {
    const line command{"asymptotics", "--problem", "y' = y^3; y(0) = 1", "--digits", "20"};
    const auto rows = rows_of(command);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].at("position_re") == "0.50000000000000000000");
    CHECK(rows[0].at("position_im") == "0");
    CHECK(rows[0].at("kind") == "branch point of 2 sheets");
    CHECK(rows[0].at("exponent") == "-1/2");
    CHECK(rows[0].at("coefficient_re") == "1.0000000000000000000");
    line with_orders = command;
    with_orders.insert(with_orders.end(), {"--order", "10,1000000"});
    const auto orders = rows_of(with_orders);
    REQUIRE(orders.size() == 2);
    CHECK(orders[0].at("value") == "180.42578125000000000");
    CHECK(orders[0].at("by") == "recurrence");
    CHECK(orders[1].at("by") == "law");
    // binomial(2000000, 1000000)/2^1000000 by mpmath.
    CHECK(orders[1].at("value") == "5.5858464166251061946e301026");
}

TEST_CASE("the text states the law, its error and what is proved", "[command][asymptotics]") {
    const std::string text =
        output_of({"asymptotics", "--problem", "y'' = 6*y^2; y(0) = 1; y'(0) = 2", "--digits", "10"});
    CHECK(text.find("t* - t0 = 1.000000000  pole of order 2, exponent -2, coefficient 1.000000000") !=
          std::string::npos);
    CHECK(text.find("for all n >= 0: a_n = ") != std::string::npos);
    CHECK(text.find("|E_n| <= ") != std::string::npos);
    CHECK(text.find("these are all singularities in |t - t0| <= ") != std::string::npos);
}

// Exponents of Legendre's equation: 0, 0 at +-1; a_n by the recurrence (n+2)(n+1) a_(n+2) = (n(n+1) - 4/9) a_n in mpmath.
TEST_CASE("the law of a linear equation with fixed singular points", "[command][asymptotics]") {
    const std::string problem = "(1-t^2)*y'' - 2*t*y' + 4/9*y = 0; y(0) = 1; y'(0) = 1/2";
    const auto rows = rows_of({"asymptotics", "--problem", problem, "--digits", "15"});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].at("position_re") == "1.00000000000000");
    CHECK(rows[0].at("kind") == "logarithm");
    CHECK(rows[0].at("exponent") == "0");
    const auto orders = rows_of({"asymptotics", "--problem", problem, "--digits", "25", "--order", "300,10000"});
    REQUIRE(orders.size() == 2);
    CHECK(orders[0].at("value") == "-0.001289395531107242501755677");
    CHECK(orders[0].at("by") == "law");
    CHECK(orders[1].at("value") == "-0.00003865403457741491728521281");
    const auto entire = rows_of({"asymptotics", "--problem", "y'' = -y; y(0) = 1; y'(0) = 0", "--within", "20"});
    REQUIRE(entire.size() == 1);
    CHECK(entire[0].at("kind") == "none");
}

TEST_CASE("bad input of asymptotics", "[command][asymptotics]") {
    const temporary_folder folder;
    const std::string problem = "y' = y^2; y(0) = 1";
    check_refused({"asymptotics"}, {"no problem"}, folder);
    check_refused({"asymptotics", "--problem", problem, "--show", "z"}, {"--show", "'z'"}, folder);
    check_refused({"asymptotics", "--problem", problem, "--order", "1e3x"}, {"--order", "1e3x"}, folder);
    check_refused({"asymptotics", "--problem", problem, "--within", "-1"}, {"--within", "-1"}, folder);
    check_refused({"asymptotics", "--problem", problem, "--terms", "500"}, {"--terms", "500"}, folder);
    check_refused({"asymptotics", "--problem", problem, "--digits", "0"}, {"--digits", "0"}, folder);
}

}  // namespace command_asymptotics_test
