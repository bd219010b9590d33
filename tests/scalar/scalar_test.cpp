#include "libration/scalar/scalar.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace scalar_concept_test {

using namespace libration;

TEST_CASE("the four scalars are scalars, and what only looks like one is not", "[scalar][concept]") {
    STATIC_REQUIRE(scalar<double>);
    STATIC_REQUIRE(scalar<long double>);
    STATIC_REQUIRE(scalar<quad>);
    STATIC_REQUIRE(scalar<mpfr>);
    STATIC_REQUIRE_FALSE(scalar<int>);
    STATIC_REQUIRE_FALSE(scalar<float>);  // not in the list: it would need its own conversions
    STATIC_REQUIRE_FALSE(scalar<rational>);
    STATIC_REQUIRE_FALSE(scalar<std::string>);
    STATIC_REQUIRE_FALSE(scalar<void>);
}

}  // namespace scalar_concept_test
