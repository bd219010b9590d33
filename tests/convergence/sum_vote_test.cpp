// The vote of approximations of a number: a sharp minority outvotes a blunt majority, and a lone outlier does not count.
#include "libration/convergence/sum_vote.hpp"

#include <catch2/catch.hpp>

#include "libration/scalar/precision_scope.hpp"

namespace convergence_sum_vote_test {

using namespace libration;
using namespace libration::convergence;

TEST_CASE("the value is where most approximations agree within their steps", "[convergence][sum vote]") {
    const precision_scope scope(40);
    const std::vector<stepped_value> values{{mpfr("1.00001"), mpfr("1e-5")},
                                            {mpfr("0.99999"), mpfr("1e-5")},
                                            {mpfr("1.0000001"), mpfr("1e-7")},
                                            {mpfr("1.2"), mpfr("1e-8")},  // wrong, however sharp
                                            {mpfr("1.1"), mpfr("0.05")}};
    const auto found = vote_on(values, mpfr(1));
    REQUIRE(found);
    CHECK(found->value == mpfr("1.0000001"));
    CHECK(found->members == std::vector<std::size_t>{0, 1, 2, 4});
    CHECK(found->step == mpfr("1e-5"));
    CHECK(found->spread <= mpfr("1.1e-5"));
    CHECK(!vote_on({}, mpfr(1)));
    const auto alone = vote_on(std::vector<stepped_value>{{mpfr(2), mpfr(1)}}, mpfr(2));
    CHECK(alone->value == 2);
    CHECK(alone->spread == 0);
}

}  // namespace convergence_sum_vote_test
