#include "libration/elliptic/jacobi_zeta.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "scalars.hpp"

namespace elliptic_jacobi_zeta_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::tests;

namespace {

struct zeta_row {
    const char* parameter;
    const char* complement;
    const char* angle;
    const char* zeta;
    const char* mean;
};

// /usr/bin/python3, mpmath, mp.dps = 130, m and phi as mpf of the text, nstr(..., 105):
//   ellipe(phi, m) - ellipf(phi, m)*ellipe(m)/ellipk(m) and ellipe(m)/ellipk(m)
const std::vector<zeta_row>& rows() {
    static const std::vector<zeta_row> all{
        {"0.855", "0.145", "0.4",
         "0.196949264290675172354472165501922508133059699819173840047825202677753854721798066870871725936625324284469",
         "0.473955829632344713078572892604182296245299086652960280190973774703434889560789313424426830214761747901988"},
        {"0.3", "0.7", "-2.2",
         "0.0788064141471444995601655471175035588279558971767043511791627984874426028423704720382379017707301531766801",
         "0.843323392852749844902012945625748247905149862455187434717536095349076548434542107638319038619896479659396"},
        {"0.0001", "0.9999", "7.5",
         "0."
         "000016257756848603827943081902961955426186770879770413191911846226838398605313361887661720351225815888107374"
         "5",
         "0.999949999374968747997902820937216875187839921100234863500447710949028059736913565654318194156428913144611"},
        {"0.9999", "0.0001", "1.5",
         "0.440709746702703630181661075433856299154155047080433834989064305693498983255792719711364315753805191486237",
         "0."
         "166946452032044925599146072360972125374235046532332489921120037246527756346291554186545803325550512710691"}};
    return all;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the zeta function agrees with mpmath", "[elliptic][jacobi_zeta]", all_scalars) {
    using T = typename TestType::type;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const typename TestType::precision precision;
    for (const zeta_row& at : rows()) {
        INFO("k^2 = " << at.parameter << ", phi = " << at.angle);
        const auto number = [](const char* text) { return from_exact<T>(read_exact(text)); };
        const T k = sqrt(number(at.parameter));
        const T complement = sqrt(number(at.complement));
        const jacobi_zeta<T> zeta(landen_chain<T>(modulus<T>::from_both(k, complement)));
        const T phi = number(at.angle);
        // Z and the means are below 1. c_n falls faster than the doublings raise the error of the angle; 16 for the
        // operations of some 8 levels, and the derivatives by phi, k and k' are below 4 each.
        CHECK_THAT(zeta(sin(phi), cos(phi)), near<T>(decimal(at.zeta), 32, T(1)));
        CHECK_THAT(zeta.mean_of_dn_squared(), near<T>(decimal(at.mean), 16, T(1)));
        CHECK_THAT(T(zeta.mean_of_cn_squared() + number(at.complement)), near<T>(decimal(at.mean), 16, T(1)));
    }
}

}  // namespace elliptic_jacobi_zeta_test
