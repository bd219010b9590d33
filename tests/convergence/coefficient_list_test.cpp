#include "libration/convergence/coefficient_list.hpp"

#include <catch2/catch.hpp>

#include "libration/convergence/coefficient_noise.hpp"
#include "scalars.hpp"

namespace convergence_coefficient_list_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

std::vector<rational> values_in(const std::string& text) {
    std::vector<rational> values;
    for (const exact& number : read_coefficients(text)) {
        values.push_back(number.coefficient);
    }
    return values;
}

const std::vector<rational> one_third_fifteenth{1, rational(1, 3), rational(2, 15)};

}  // namespace

TEST_CASE("a list of coefficients is read from one number a line", "[convergence][coefficient_list]") {
    CHECK(values_in("1\n1/3\n2/15\n") == one_third_fifteenth);
    CHECK(values_in("1\n1/3\n2/15") == one_third_fifteenth);
    CHECK(values_in("\xEF\xBB\xBF# a comment\r\n\r\n 1 \r\n\t1/3 # another\r\n2/15\r\n") == one_third_fifteenth);
    CHECK(values_in("coefficient\n1\n1/3\n2/15\n") == one_third_fifteenth);
    CHECK(values_in("-1.5e2\n+.25\n1E-3\n") == std::vector<rational>{-150, rational(1, 4), rational(1, 1000)});
    CHECK(values_in("").empty());
    CHECK(values_in("# nothing\n\n  \n").empty());
    // 1e-5000 as typed.
    const auto tiny = values_in("1e-5000\n");
    CHECK(tiny.at(0) * rational(boost::multiprecision::pow(integer(10), 5000)) == 1);
}

TEST_CASE("a list of coefficients is read from n and a number, missing n being 0", "[convergence][coefficient_list]") {
    CHECK(values_in("n,coefficient\n0,1\n1,1/3\n2,2/15\n") == one_third_fifteenth);
    CHECK(values_in("0,1\n1,1/3\n2,2/15\n") == one_third_fifteenth);
    CHECK(values_in("0 1\n1\t1/3\n2   2/15\n") == one_third_fifteenth);
    CHECK(values_in("0;1\n1; 1/3\n2 ;2/15\n") == one_third_fifteenth);
    CHECK(values_in("\"n\",\"coefficient\"\n\"0\",\"1\"\n\"1\",\"1/3\"\n\"2\",\"2/15\"\n") == one_third_fifteenth);
    CHECK(values_in("n,coefficient,uncertainty\n0,1,0\n1,1/3,0\n2,2/15,0\n") == one_third_fifteenth);
    CHECK(values_in("coefficient,n\n1,0\n1/3,1\n2/15,2\n") == one_third_fifteenth);
    CHECK(values_in("1,5\n4,7\n") == std::vector<rational>{0, 5, 0, 0, 7});
}

TEST_CASE("a line that is no coefficient is named with its number and its text", "[convergence][coefficient_list]") {
    struct bad {
        std::string text;
        std::size_t number;
        std::string line;
    };
    const std::vector<bad> all{{"1\n2\nabc\n", 3, "abc"},
                               {"abc\n1\n", 1, "abc"},
                               {"# c\n\n1.2.3\n", 3, "1.2.3"},
                               {"0,1\n1,x\r\n", 2, "1,x"},
                               {"0,1\n0,2\n", 2, "0,2"},
                               {"1,1\n0,2\n", 2, "0,2"},
                               {"0,1\n2\n", 2, "2"},
                               {"1\n2,3\n", 2, "2,3"},
                               {"1.5,1\n", 1, "1.5,1"},
                               {"-1,1\n", 1, "-1,1"},
                               {"1,\n", 1, "1,"},
                               {"1,2,3\n", 1, "1,2,3"},
                               {"1/0\n", 1, "1/0"},
                               {"nan\n", 1, "nan"},
                               {"1\ninf\n", 2, "inf"},
                               {"pi\n", 1, "pi"},
                               {"n,a,b\n0,1,2\n", 1, "n,a,b"},
                               {"999999999999999999999999,1\n", 1, "999999999999999999999999,1"}};
    for (const bad& each : all) {
        INFO(each.text);
        try {
            read_coefficients(each.text);
            FAIL("is read");
        } catch (const malformed_line& problem) {
            CHECK(problem.number() == each.number);
            CHECK(problem.text() == each.line);
            CHECK(std::string(problem.what()).size() > 5);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("the noise of a list is a unit of its decimals, or a rounding",
                        "[convergence][coefficient_list]", all_scalars) {
    using T = typename TestType::type;
    [[maybe_unused]] const typename TestType::precision precision;
    const auto noise_in = [](const std::string& text) { return noise_of<T>(read_coefficients(text)); };
    CHECK(noise_in("1\n1/3\n2/15\n17\n") == epsilon<T>());
    // One rounding of 10^-9 to T.
    CHECK_THAT(noise_in("1\n2\n0.333333333\n1.234567890e-7\n"),
               near<T>(decimal("1.00000000000000000000000000000e-9"), 1));
    CHECK(noise_in("0.1\n0.01\n0.001\n") == T(1) / 4096);
    CHECK(noise_in("0.5\n1." + std::string(200, '3') + "\n") == epsilon<T>());
}

}  // namespace convergence_coefficient_list_test
