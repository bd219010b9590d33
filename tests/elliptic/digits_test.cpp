// Elliptic functions to any number of digits, as a C++ user asks for them.
#include "libration/elliptic/digits.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "libration/elliptic/digits_enclosure.hpp"
#include "libration/scalar/error.hpp"

namespace elliptic_digits_test {

using namespace libration;

namespace {

template <class Rounded, class Proved>
void check_both(const std::string& expected, const Rounded& by_rounding, const Proved& by_proof) {
    CHECK(by_rounding.text == expected);
    CHECK(by_proof.text == expected);
}

}  // namespace

TEST_CASE("K of the lemniscate and next to 1", "[elliptic][digits]") {
    // Gamma(1/4)^2/(4 sqrt(pi)) [DLMF 23.5.9], and log(4/k') for k' = 1e-15 up to 1e-29.
    check_both("1.8540746773013719184338503471952600462", rounded::K({.m = "1/2"}, 38), proved::K({.m = "1/2"}, 38));
    check_both("inf", rounded::K({.m1 = "0"}, 38), proved::K({.k = "1"}, 38));
    CHECK(rounded::K({.m1 = "1e-30"}, 25).text == proved::K({.m1 = "1e-30"}, 25).text);
}

TEST_CASE("the limits m = 0 and m = 1 are elementary", "[elliptic][digits]") {
    check_both("0.50000000000000000000", rounded::sn("pi/6", {.m = "0"}, 20), proved::sn("pi/6", {.m = "0"}, 20));
    check_both("0", rounded::cn("pi/2", {.m = "0"}, 20), proved::cn("pi/2", {.m = "0"}, 20));
    // tanh 1
    check_both("0.76159415595576488812", rounded::sn("1", {.m = "1"}, 20), proved::sn("1", {.m = "1"}, 20));
    check_both("inf", rounded::F("pi/2", {.m = "1"}, 20), proved::F("90deg", {.m = "1"}, 20));
}

TEST_CASE("rounded and proved digits are the same ones", "[elliptic][digits]") {
    for (const std::string u : {"1.5", "-22/7", "1e6"}) {
        for (const std::string m1 : {"1e-30", "1/3"}) {
            INFO(u << ' ' << m1);
            CHECK(rounded::am(u, {.m1 = m1}, 40).text == proved::am(u, {.m1 = m1}, 40).text);
            CHECK(rounded::sn(u, {.m1 = m1}, 40).text == proved::sn(u, {.m1 = m1}, 40).text);
            CHECK(rounded::cn(u, {.m1 = m1}, 40).text == proved::cn(u, {.m1 = m1}, 40).text);
            CHECK(rounded::dn(u, {.m1 = m1}, 40).text == proved::dn(u, {.m1 = m1}, 40).text);
            CHECK(rounded::F(u, {.m1 = m1}, 40).text == proved::F(u, {.m1 = m1}, 40).text);
        }
    }
}

TEST_CASE("a bad modulus is refused by name", "[elliptic][digits]") {
    CHECK_THROWS_WITH(rounded::K({.k = "1.5"}, 10), "modulus k '1.5' is outside [0, 1]");
    CHECK_THROWS_AS(proved::K({}, 10), error);
    CHECK_THROWS_AS(proved::K({.k = "0", .m = "0"}, 10), error);
    CHECK_THROWS_AS(rounded::sn("1deg", {.k = "0"}, 10), error);
}

}  // namespace elliptic_digits_test
