// Distances that are typed as a - b and as b - a are one unknown of the polynomial form.
#include "libration/equation/signed_form.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "libration/equation/polynomial_form.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/number/exact.hpp"

namespace equation_signed_form_test {

using namespace libration;
using namespace libration::ode;

TEST_CASE("a distance is the same from both of its ends") {
    const auto added = [](const std::string& text) { return lifted(explicit_system(parse(text))).added.size(); };
    const std::string starts = "; x(0) = 1; y(0) = 3; u(0) = 0; v(0) = 2";
    const std::string apart = "((y-x)^2 + (v-u)^2)^(3/2); ";
    const std::string others = "u' = 0; v' = 0";
    CHECK(added("x' = (y-x)/" + apart + "y' = (x-y)/((x-y)^2 + (u-v)^2)^(3/2); " + others + starts) ==
          added("x' = (y-x)/" + apart + "y' = (x-y)/" + apart + others + starts));
}

// x - y = -2, with the signs of the differences: in odd powers, products and quotients.
TEST_CASE("signs that are taken out of differences are those of the values") {
    const explicit_system typed(
        parse("x' = (y-x)^3 + 5*(x-y); y' = (x-y)*(y-x)^2; z' = (y-x)/(x-y)^3*(x-y); x(0) = 1; y(0) = 3; z(0) = 0"));
    const auto form = lifted(typed);
    const std::vector<rational> values =
        lifted_values<rational>(form, rational(0), {rational(1), rational(3), rational(0)});
    expression_values<rational> at(form.leaves, rational(0));
    for (const rational& each : values) {
        at.push_back(each);
    }
    CHECK(at.of(form.system.right()[0]) == rational(-2));
    CHECK(at.of(form.system.right()[1]) == rational(-8));
    CHECK(at.of(form.system.right()[2]) == rational(1, 2));
}

}  // namespace equation_signed_form_test
