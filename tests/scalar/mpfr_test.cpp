#include "libration/scalar/mpfr.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace scalar_mpfr_test {

using namespace libration;

namespace {

long bits_of(const mpfr& x) { return static_cast<long>(mpfr_get_prec(handle(x))); }

mpfr a_third_to(long digits) {
    const precision_scope scope(digits);
    return mpfr(1) / 3;
}

}  // namespace

// The common cause of wrong digits with a run-time precision: more digits in force do not make a value more accurate.
TEST_CASE("a value keeps the precision it was born with", "[scalar][mpfr]") {
    const mpfr born = a_third_to(40);
    const precision_scope scope(100);
    const mpfr copy = born;  // NOLINT(performance-unnecessary-copy-initialization): the copy is what is tested
    mpfr assigned(0);
    assigned = born;
    CHECK(bits_of(copy) == bits_of(born));
    CHECK(bits_of(assigned) == bits_of(born));
    CHECK(bits_of(mpfr(0)) > bits_of(born));
    // An operation uses the precision in force; digits that were never computed do not appear.
    const mpfr sum = born + 0;
    CHECK(bits_of(sum) == bits_of(mpfr(0)));
    CHECK(sum == born);
    CHECK(abs(sum - mpfr(1) / 3) > epsilon<mpfr>());
    CHECK_THAT(sum, !tests::near<mpfr>(tests::exactly(a_third_to(100)), 1));
}

TEST_CASE("an operation does not cut operands of more digits than are in force", "[scalar][mpfr]") {
    const mpfr fine = a_third_to(100);
    const precision_scope scope(40);
    CHECK(bits_of(fine * 3) == bits_of(fine));
    CHECK(bits_of(narrow<mpfr>(fine)) == bits_of(mpfr(0)));
}

// Boost computes into a temporary operand to save an allocation, and keeps the precision with which it was created.
TEST_CASE("an operation on a temporary of few digits has few digits", "[scalar][mpfr]") {
    const mpfr born = a_third_to(40);
    const precision_scope scope(100);
    const mpfr one(1);
    CHECK(bits_of(born + one) == bits_of(one));
    CHECK(bits_of(a_third_to(40) + one) == bits_of(born));
    CHECK(bits_of(narrow<mpfr>(a_third_to(40)) + one) == bits_of(one));
}

TEST_CASE("integers and fractions are exact", "[scalar][mpfr]") {
    CHECK(rational(2) / 4 == rational(1) / 2);
    CHECK(boost::multiprecision::denominator(rational(rational(6) / 4)) == 2);
    CHECK((integer(1) << 200) - 1 ==
          integer(std::string("1606938044258990275541962092341162602522202993782792835301375")));
}

}  // namespace scalar_mpfr_test
