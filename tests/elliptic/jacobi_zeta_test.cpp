#include "libration/elliptic/jacobi_zeta.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "scalars.hpp"

using namespace libration;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("the zeta function agrees with mpmath", "[elliptic][jacobi_zeta]", all_scalars) {
    using T = TestType;
    if constexpr (rounding_scalar<T>) {
        const precision_scope scope(40);
        struct row {
            const char* parameter;
            const char* complement;
            const char* angle;
            const char* zeta;
            const char* mean;
        };
        // mpmath, mp.dps = 50: for m, phi: ellipe(phi,m) - ellipf(phi,m)*ellipe(m)/ellipk(m), ellipe(m)/ellipk(m)
        const std::vector<row> rows{{"0.855", "0.145", "0.4", "0.1969492642906751723544721655019225081331",
                                     "0.4739558296323447130785728926041822962453"},
                                    {"0.855", "0.145", "1.5", "0.06059953048852384251738180475793604150513",
                                     "0.4739558296323447130785728926041822962453"},
                                    {"0.855", "0.145", "-2.2", "0.3171959458333379141306338629031199969521",
                                     "0.4739558296323447130785728926041822962453"},
                                    {"0.855", "0.145", "7.5", "0.250197685750198734456520825191102445634",
                                     "0.4739558296323447130785728926041822962453"},
                                    {"0.3", "0.7", "0.4", "0.05688067927775070965080094778600151533929",
                                     "0.8433233928527498449020129456257482479051"},
                                    {"0.3", "0.7", "1.5", "0.01208103448947510285769819496727682066944",
                                     "0.8433233928527498449020129456257482479051"},
                                    {"0.3", "0.7", "-2.2", "0.07880641414714449956016554711750355882796",
                                     "0.8433233928527498449020129456257482479051"},
                                    {"0.3", "0.7", "7.5", "0.05502939965599254113019843738920449940041",
                                     "0.8433233928527498449020129456257482479051"},
                                    {"0.0001", "0.9999", "0.4", "0.00001793419445009422086290126294529928925519",
                                     "0.9999499993749687479979028209372168751878"},
                                    {"0.0001", "0.9999", "1.5", "0.000003528132068938935631462290795016952170285",
                                     "0.9999499993749687479979028209372168751878"},
                                    {"0.0001", "0.9999", "-2.2", "0.000023790738029142182477605546047967003744",
                                     "0.9999499993749687479979028209372168751878"},
                                    {"0.0001", "0.9999", "7.5", "0.00001625775684860382794308190296195542618677",
                                     "0.9999499993749687479979028209372168751878"},
                                    {"0.9999", "0.0001", "0.4", "0.3207855666889751571887660312116987180602",
                                     "0.1669464520320449255991460723609721253742"},
                                    {"0.9999", "0.0001", "1.5", "0.4407097467027036301816610754338562991542",
                                     "0.1669464520320449255991460723609721253742"},
                                    {"0.9999", "0.0001", "-2.2", "0.6210910224847216522224744959395532662495",
                                     "0.1669464520320449255991460723609721253742"},
                                    {"0.9999", "0.0001", "7.5", "0.6507265538949495297740320948919818776233",
                                     "0.1669464520320449255991460723609721253742"}};
        for (const row& at : rows) {
            INFO("k^2 = " << at.parameter << ", phi = " << at.angle);
            const mpfr k = sqrt(mpfr(at.parameter));
            const mpfr complement = sqrt(mpfr(at.complement));
            const jacobi_zeta<T> zeta(landen_chain<T>(modulus<T>::from_both(narrow<T>(k), narrow<T>(complement))));
            const mpfr phi(at.angle);
            const T value = zeta(narrow<T>(mpfr(sin(phi))), narrow<T>(mpfr(cos(phi))));
            // At most 8 levels double the angle and its error, from an epsilon, and c_n shrinks faster than that; 32 more for
            // the operations and the roundings of k, k' and phi, whose derivatives are below 4.
            CHECK(abs(T(value - narrow<T>(mpfr(at.zeta)))) <= 64 * epsilon<T>());
            CHECK(abs(T(zeta.mean_of_dn_squared() - narrow<T>(mpfr(at.mean)))) <= 64 * epsilon<T>());
            const mpfr of_cn = mpfr(at.mean) - mpfr(at.complement);
            CHECK(abs(T(zeta.mean_of_cn_squared() - narrow<T>(of_cn))) <= 64 * epsilon<T>());
        }
    }
}
