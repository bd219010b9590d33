// The numbers of `libration coefficients` compared with the reference table and with the sum over all singularities.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "command/printed.hpp"
#include "command/reference_motion.hpp"

namespace command_coefficients_test {

using namespace libration;
using namespace libration::tests;

namespace {

using words = std::vector<std::string>;

std::vector<table_row> coefficients_of(words options) {
    options.insert(options.begin(), "coefficients");
    return rows_of(options);
}

// 1/z^n by repeated division: re and im.
struct complex_number {
    mpfr re;
    mpfr im;
};
complex_number inverse_power(const complex_number& z, int n) {
    const mpfr square = z.re * z.re + z.im * z.im;
    complex_number power{mpfr(1), mpfr(0)};
    for (int i = 0; i < n; ++i) {
        power = {(power.re * z.re + power.im * z.im) / square, (power.im * z.re - power.re * z.im) / square};
    }
    return power;
}

// a_n = +-(8/n) sum (-1)^(p+q) Im z^-n below E = 2, -(8/n) sum (-1)^q Im z^-n above, over p, q >= 0, with
// z = x_p + i (2q+1) K~', x_p = (2p+1) T* from the top and 2p T* from the bottom (there p = 0 counts half). T* and
// R^2 = T*^2 + K~'^2 are those of the reference table.
mpfr sum_over_singularities(const std::string& energy, bool from_top, int n) {
    const table_row row = reference_motion_of(energy).rows.front();
    const mpfr quarter = number_of(row.at("tstar"));
    const mpfr radius = number_of(row.at("radius"));
    const mpfr height = sqrt(radius * radius - quarter * quarter);
    const bool rotates = read_exact(energy).coefficient > 2;
    mpfr sum(0);
    for (int p = 0; p < 20; ++p) {
        for (int q = 0; q < 20; ++q) {
            const complex_number z{quarter * (from_top ? 2 * p + 1 : 2 * p), height * (2 * q + 1)};
            const int sign = (rotates ? q + 1 : p + q) % 2 == 0 ? 1 : -1;
            const mpfr term = inverse_power(z, n).im * sign;
            sum += !from_top && p == 0 ? mpfr(term / 2) : term;
        }
    }
    return sum * 8 / n;
}

}  // namespace

TEST_CASE("every expansion of the reference table is printed to 50 right digits", "[command][coefficients]") {
    std::vector<table_row> printed;
    std::string shown;
    std::size_t expansions = 0;
    for (const table_row& expected : reference_table("coefficients.csv")) {
        const words motion{"--energy", expected.at("energy"), "--at", expected.at("at"), "--order", "40"};
        if (command_line(motion) != shown) {
            shown = command_line(motion);
            printed = coefficients_of(motion);
            REQUIRE(printed.size() == 41);
            ++expansions;
        }
        INFO(shown << ", n = " << expected.at("n"));
        const table_row& row = printed[std::stoul(expected.at("n"))];
        CHECK(row.at("n") == expected.at("n"));
        CHECK_THAT(row.at("coefficient"), right_to_the_last_digit(expected.at("coefficient")));
    }
    CHECK(expansions == 17);
}

TEST_CASE("order 60 of E = 1.71 and 2.02 is the sum over the singularities", "[command][coefficients]") {
    struct place {
        std::string energy;
        std::string at;
        int first;  // the first power above 40 that parity permits
    };
    // From n = 41 on, terms with |z| > 40 R or more are omitted: (1/40)^41 = 1e-65 relative to the first term.
    for (const place& shown : {place{"1.71", "top", 42}, place{"1.71", "bottom", 41}, place{"2.02", "top", 41},
                               place{"2.02", "bottom", 41}}) {
        const auto rows =
            coefficients_of({"--energy", shown.energy, "--at", shown.at, "--order", "60", "--digits", "50"});
        REQUIRE(rows.size() == 61);
        const precision_scope scope(90);
        for (int n = shown.first; n <= 60; n += 2) {
            INFO("E = " << shown.energy << " at " << shown.at << ", n = " << n);
            CHECK_THAT(rows[static_cast<std::size_t>(n)].at("coefficient"),
                       right_to_the_last_digit_of(sum_over_singularities(shown.energy, shown.at == "top", n)));
            if (n < 60) {
                CHECK(rows[static_cast<std::size_t>(n) + 1].at("coefficient") == "0");
            }
        }
    }
}

TEST_CASE("the default point is the top for an energy, the bottom at E = 2 and the start for a state",
          "[command][coefficients]") {
    const words order{"--order", "6", "--format", "csv"};
    const auto csv = [&](words options) {
        options.insert(options.begin(), "coefficients");
        options.insert(options.end(), order.begin(), order.end());
        return output_of(options);
    };
    CHECK(csv({"--energy", "1.71"}) == csv({"--energy", "1.71", "--at", "top"}));
    CHECK(csv({"--energy", "1.71"}) == csv({"--energy", "1.71", "--at", "start"}));
    CHECK(csv({"--energy", "1.71"}) != csv({"--energy", "1.71", "--at", "bottom"}));
    CHECK(csv({"--energy", "1.71", "--at", "bottom"}) == csv({"--energy", "1.71", "--at", "T/4"}));
    CHECK(csv({"--energy", "2.02", "--at", "bottom"}) == csv({"--energy", "2.02", "--at", "T/2"}));
    CHECK(csv({"--energy", "2"}) == csv({"--energy", "2", "--at", "bottom"}));
    CHECK(csv({"--theta0", "1", "--omega0", "0.5"}) == csv({"--theta0", "1", "--omega0", "0.5", "--at", "start"}));
    CHECK(csv({"--theta0", "1", "--omega0", "0.5"}) == csv({"--theta0", "1", "--omega0", "0.5", "--at", "0"}));
    CHECK(csv({"--theta0", "1", "--omega0", "0.5"}) != csv({"--theta0", "1", "--omega0", "0.5", "--at", "top"}));
}

TEST_CASE("the bottom has theta = 0 and the falling speed, the start has the state as given",
          "[command][coefficients]") {
    const precision_scope scope(80);
    const auto falling = coefficients_of({"--energy", "1.71", "--at", "bottom", "--order", "1"});
    CHECK(falling[0].at("coefficient") == "0");
    CHECK_THAT(falling[1].at("coefficient"), right_to_the_last_digit_of(-sqrt(mpfr("3.42"))));
    const auto turning = coefficients_of({"--energy", "2.02", "--at", "bottom", "--order", "1"});
    CHECK_THAT(turning[0].at("coefficient"), right_to_the_last_digit_of(pi<mpfr>() * 2));
    CHECK_THAT(turning[1].at("coefficient"), right_to_the_last_digit_of(sqrt(mpfr("4.04"))));
    const auto clockwise = coefficients_of({"--energy", "2.02", "--direction", "-", "--at", "bottom", "--order", "1"});
    CHECK(clockwise[0].at("coefficient") == "0");
    CHECK_THAT(clockwise[1].at("coefficient"), right_to_the_last_digit_of(-sqrt(mpfr("4.04"))));
    const auto start = coefficients_of({"--theta0", "5pi/2", "--omega0", "-0.3", "--order", "3", "--digits", "30"});
    CHECK_THAT(start[0].at("coefficient"), right_to_the_last_digit_of(pi<mpfr>() * 5 / 2));
    CHECK(start[1].at("coefficient") == "-0.300000000000000000000000000000");
    CHECK(start[2].at("coefficient") == "-0.500000000000000000000000000000");  // -sin(theta0)/2
    CHECK(start[3].at("coefficient") == "0");                                  // -cos(theta0) omega0/6
}

TEST_CASE("in double the coefficients are right to a few units, far below the range of double too",
          "[command][coefficients]") {
    const auto rounded = coefficients_of({"--energy", "1.71", "--order", "3000", "--scalar", "double"});
    const auto exact = coefficients_of({"--energy", "1.71", "--order", "3000", "--digits", "20"});
    REQUIRE(rounded.size() == 3001);
    const precision_scope scope(50);
    CHECK(number_of(exact[3000].at("coefficient")) < mpfr("1e-1000"));
    const mpfr radius = number_of(reference_motion_of("1.71").rows.front().at("radius"));
    mpfr worst(0);
    for (int n = 4; n <= 3000; ++n) {
        const auto i = static_cast<std::size_t>(n);
        const mpfr difference = abs(number_of(rounded[i].at("coefficient")) - number_of(exact[i].at("coefficient")));
        const mpfr relative = difference * pow(radius, n) * n / 8;
        worst = relative > worst ? relative : worst;
    }
    // DESIGN section 3: below 2e-13 of 8/(n R^n) for n <= 1000; it grows about as n, which makes 6e-13 here. The scale
    // R is rounded too, and enters n times.
    INFO(to_decimal(worst, 5));
    CHECK(worst < mpfr("1e-12"));
    CHECK(worst > mpfr("1e-17"));
}

TEST_CASE("coefficients far out are printed alone, with every digit proved", "[command][coefficients]") {
    const words far{"--energy", "1.71", "--from", "1000000000", "--order", "1000000000"};
    // mpmath, 120 digits: n = 10**9; z = mpc(ellipk(0.855), ellipk(0.145)); 8/mpf(n)*(z**(-n)).imag, E as mpf('1.71')
    const std::string expected = "-4.1637925217557802189057862200785693154428747639467e-463400164";
    for (const std::string scalar : {"ball:50", "mpfr:50"}) {
        const auto rows = coefficients_of(far + words{"--scalar", scalar});
        REQUIRE(rows.size() == 1);
        CHECK(rows[0].at("n") == "1000000000");
        CHECK(rows[0].at("coefficient") == expected);
    }
    for (const std::string scalar : {"double", "quad"}) {
        const std::string found = coefficients_of(far + words{"--scalar", scalar})[0].at("coefficient");
        CHECK(found.substr(0, 16) == expected.substr(0, 16));  // 14 digits and the exponent
        CHECK(found.substr(found.find('e')) == "e-463400164");
    }
    // The same with z = mpc(ellipk(0.855)/2, ellipk(0.145)), 4 instead of 8.
    const auto between = coefficients_of({"--energy", "1.71", "--at", "T/8", "--from", "999999999999999", "--order",
                                          "1000000000000000", "--scalar", "ball:30"});
    REQUIRE(between.size() == 2);
    CHECK(between[0].at("coefficient") == "-3.62991248206952102719105275848e-307027518777264");
    CHECK(between[1].at("coefficient") == "-8.04664953032064888332422031160e-307027518777264");
}

TEST_CASE("the rows from --from on are those of the whole list", "[command][coefficients]") {
    for (const std::string energy : {"1", "1.71", "2", "4"}) {
        for (const std::string scalar : {"mpfr:30", "ball:30"}) {
            INFO("E = " << energy << ", " << scalar);
            const words asked{"--energy", energy, "--order", "190", "--scalar", scalar};
            const auto whole = coefficients_of(asked);
            const auto part = coefficients_of(asked + words{"--from", "60"});
            REQUIRE(whole.size() == 191);
            REQUIRE(part.size() == 131);
            for (std::size_t i = 0; i < part.size(); ++i) {
                CHECK(part[i].at("n") == whole[i + 60].at("n"));
                CHECK_THAT(part[i].at("coefficient"), right_to_the_last_digit(whole[i + 60].at("coefficient")));
                const auto n = static_cast<int>(i) + 60;
                const bool zero = energy == "1" ? n % 4 != 2 : energy == "1.71" ? n % 2 != 0 : n % 2 == 0;
                CHECK((part[i].at("coefficient") == "0") == zero);
            }
        }
    }
}

}  // namespace command_coefficients_test
