// Decimals of doubles: recognised by their digits, and compared within half a unit in the last place.
#include "libration/verification/double_decimals.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "libration/number/written_number.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/verification/compare_rules.hpp"
#include "libration/verification/mistake_hint.hpp"

namespace verification_double_decimals_test {

using namespace libration;

namespace {

bool recognised(const std::vector<std::string>& column) {
    double_decimals decimals;
    for (const std::string& each : column) {
        decimals.add(each);
    }
    return decimals.recognised();
}

}  // namespace

// Python: '%.18e' % math.tan(0.5), '%.18e' % 1e300, repr(math.pi), and so on.
TEST_CASE("columns of doubles are recognised, and others are not", "[verify]") {
    CHECK(recognised({"5.463024898437904842e-01"}));
    CHECK(recognised({"0.000000000000000000e+00", "-5.463024898437904842e-01", "nan", "1.000000000000000053e+300"}));
    CHECK_FALSE(recognised({"5.463024898437904842e-01", "5.463024898437904843e-01"}));
    CHECK_FALSE(recognised({"5.463024898437905133e-01"}));
    CHECK_FALSE(recognised({"3.141592653589793", "0.5", "1e-3"}));
    CHECK_FALSE(recognised({"0x1.921fb54442d18p+1"}));
    CHECK_FALSE(recognised({"1e400"}));
    CHECK_FALSE(recognised({"nan"}));
}

TEST_CASE("numbers that are doubles", "[verify]") {
    const auto exact = [](const std::vector<std::string>& column) {
        double_decimals decimals;
        for (const std::string& each : column) {
            decimals.add(each);
        }
        return decimals.exact();
    };
    CHECK(exact({"0.5", "-3", "1e22", "0x1.8p+1"}));
    CHECK_FALSE(exact({"0.5", "0.1", "0.25"}));
    CHECK_FALSE(exact({"1.000000000000000056e-01"}));
    CHECK_FALSE(exact({"1e23"}));
    CHECK_FALSE(exact({"1e400", "1"}));
}

TEST_CASE("a unit in the last place is that of the double", "[verify]") {
    for (const double x : {1.0, 1.9999, 2.0, -3.7, 1e-300, 0x1p-1074, 1e300}) {
        const double up = std::nextafter(std::abs(x), HUGE_VAL);
        CHECK(unit_in_last_place(rational(x)) == rational(up) - rational(std::abs(x)));
    }
    CHECK(unit_in_last_place(0) == power_of(2, -1074));
}

// e = 2.718281828459045235..., whose double, 2.718281828459045091, is 0.33 units in the last place away.
TEST_CASE("doubles are judged by half a unit in their last place, printed tables by half a digit", "[verify]") {
    const precision_scope scope(40);
    const true_value e{exp(ball(1))};
    const auto within = [&](const char* text, bool of_double, bool rounded = false) {
        return compare_value({text, "e", of_double}, e, {.rounded = rounded}, false)->within;
    };
    CHECK(within("2.718281828459045091e+00", true));
    CHECK_FALSE(within("2.718281828459045535e+00", true));
    CHECK_FALSE(within("2.718281828459045091e+00", false));
    CHECK(within("2.71829", false));
    CHECK_FALSE(within("2.71829", false, true));
    CHECK(within("2.71828", false, true));
}

TEST_CASE("a mistake is recognised in three rows, of which nine of ten miss", "[verify]") {
    const precision_scope scope(digits_of_row_numbers);
    const auto row = [](long v, long y, long slope) {
        return row_numbers{{mpfr(v)}, {mpfr(y)}, {mpfr(v - y)}, {mpfr(slope)}};
    };
    mistake_hint of({"y"});
    of.add(row(1100, 1000, 1000), false);
    of.add(row(2200, 2000, 2000), false);
    CHECK(of.found().empty());
    of.add(row(4400, 4000, 4000), false);
    CHECK_THAT(of.found(), Catch::StartsWith("the times are off by a constant: the values are those of times 0.100 "
                                             "later, with"));
    of.add(row(8000, 8000, 8000), true);
    CHECK(of.found().empty());
}

}  // namespace verification_double_decimals_test
