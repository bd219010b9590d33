// Elliptic functions at exact arguments in balls: identities, Landen's transformation, exact values and limits.
#include "libration/elliptic/proved_functions.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "proved.hpp"

namespace elliptic_proved_functions_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::tests;

namespace {

exact_parameter parameter(const std::string& m) { return exact_parameter::from_parameter(read_exact(m).coefficient); }

}  // namespace

TEST_CASE("sn, cn, dn and am in balls satisfy their identities", "[elliptic][proved]") {
    const precision_scope scope(50);
    for (const std::string m : {"0", "1e-40", "0.3", "0.99999999", "1"}) {
        const exact_parameter p = parameter(m);
        for (const std::string u : {"0", "1e-30", "0.7", "-3", "pi", "1e6"}) {
            INFO("m = " << m << ", u = " << u);
            const exact at = read_exact(u);
            const ball sn = jacobi_value(jacobi_function::sn, at, p);
            const ball cn = jacobi_value(jacobi_function::cn, at, p);
            const ball dn = jacobi_value(jacobi_function::dn, at, p);
            const ball am = jacobi_value(jacobi_function::am, at, p);
            CHECK(overlaps(sn * sn + cn * cn, ball(1)));
            CHECK(overlaps(dn * dn + from_exact<ball>(p.m()) * sn * sn, ball(1)));
            CHECK(overlaps(sin(am), sn));
            CHECK(overlaps(cos(am), cn));
        }
    }
}

TEST_CASE("F undoes the amplitude and counts quarters", "[elliptic][proved]") {
    const precision_scope scope(50);
    const exact_parameter p = parameter("0.3");
    const ball k = complete_integral(p.shape<ball>());
    CHECK(overlaps(incomplete_value(read_exact("90deg"), p), k));
    CHECK(overlaps(incomplete_value(read_exact("-5pi/2"), p), -k * 5));
    const ball f = incomplete_value(read_exact("2.5"), p);
    CHECK(overlaps(amplitude(f, p.shape<ball>()), from_exact<ball>(read_exact("2.5"))));
}

TEST_CASE("infinities and the ends of the parameter are decided exactly", "[elliptic][proved]") {
    // pi/2 rounded down and up in its 60th digit.
    const std::string below = "1.57079632679489661923132169163975144209858469968755291048747";
    const std::string above = "1.57079632679489661923132169163975144209858469968755291048748";
    CHECK(infinite_sign(read_exact(below), parameter("1")) == 0);
    CHECK(infinite_sign(read_exact(above), parameter("1")) == 1);
    CHECK(infinite_sign(read_exact("-90deg"), parameter("1")) == -1);
    CHECK(infinite_sign(read_exact("-90deg"), parameter("0.9999999999")) == 0);
    CHECK_THROWS_AS(incomplete_value(read_exact("2"), parameter("1")), libration::error);
    CHECK_THROWS_AS(parameter("1.0000000000000000000000001"), libration::error);
    CHECK_THROWS_AS(exact_parameter::from_modulus(rational(-1, 10)), libration::error);
    CHECK(exact_parameter::from_modulus(rational(3, 5)).complement().coefficient == rational(16, 25));
    CHECK(exact_parameter::from_complement(rational(1, 3)).m().coefficient == rational(2, 3));
}

}  // namespace elliptic_proved_functions_test
