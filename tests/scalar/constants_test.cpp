#include "libration/scalar/constants.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace scalar_constants_test {

using namespace libration;
using libration::tests::all_scalars;

namespace {

// OEIS A000796.
const tests::expected_value known_pi = tests::decimal(
    "3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798214808651");

}  // namespace

TEMPLATE_LIST_TEST_CASE("pi is correctly rounded", "[scalar][constants]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // In [2, 4) the unit in the last place is 2 epsilon: half a unit is 1 epsilon.
    CHECK_THAT(pi<T>(), tests::near<T>(known_pi, 1, T(1)));
}

TEMPLATE_LIST_TEST_CASE("pi satisfies Machin's formula", "[scalar][constants]", all_scalars) {
    using T = typename TestType::type;
    using std::atan;
    const typename TestType::precision precision;
    // pi/4 = 4 atan(1/5) - atan(1/239). Four roundings (quotient, atan of either term) below 1 contribute at most
    // epsilon each; the sum 4 atan(1/5) = 0.79 has half of that and so has the difference.
    const T machin = atan(T(1) / 5) * 4 - atan(T(1) / 239);
    CHECK_THAT(T(pi<T>() / 4), tests::near<T>(machin, 2));
}

TEST_CASE("pi is made anew at every precision", "[scalar][constants]") {
    const precision_scope coarse(40);
    const mpfr short_pi = pi<mpfr>();
    const precision_scope fine(100);
    CHECK_THAT(pi<mpfr>(), tests::near<mpfr>(known_pi, 1));
    CHECK_THAT(short_pi, !tests::near<mpfr>(known_pi, 1));
}

}  // namespace scalar_constants_test
