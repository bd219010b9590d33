#include "libration/elliptic/jacobi.hpp"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <catch2/catch.hpp>

#include "elliptic/table_input.hpp"
#include "reference_table.hpp"

namespace elliptic_jacobi_test {

using namespace libration;
using namespace libration::elliptic;
using libration::tests::all_scalars;
using libration::tests::near;
using libration::tests::typed;

namespace {

const std::vector<std::string> moduli = {"1", "0.999999", "0.9", "0.5", "1e-3", "1e-20", "1e-100"};
const std::vector<std::string> arguments = {"0", "1e-8", "0.3", "-1.7", "2.5", "40", "1e3", "-1e6"};

template <class T>
modulus<T> at_complement(const std::string& text) {
    return modulus<T>::from_complement(typed<T>(text));
}

// am, sn, cn and dn of the table's row, for the argument and k' as held.
template <class T>
std::array<tests::expected_value, 4> known(const tests::table_row& row, const T& u, const T& complement) {
    const precision_scope scope(250);
    const auto all = [](const mpfr& v, const modulus<mpfr>& m) {
        const auto [sn, cn, dn] = jacobi(v, m);
        return std::array{amplitude(v, m), sn, cn, dn};
    };
    const auto held = all(narrow<mpfr>(widen(u)), modulus<mpfr>::from_complement(narrow<mpfr>(widen(complement))));
    const auto exact = all(typed<mpfr>(row.at("u")), at_complement<mpfr>(row.at("kc")));
    return {tests::moved(row.at("am"), held[0], exact[0]), tests::moved(row.at("sn"), held[1], exact[1]),
            tests::moved(row.at("cn"), held[2], exact[2]), tests::moved(row.at("dn"), held[3], exact[3])};
}

// The rounding of the argument, of its product with the mean, of tan and of half a dozen levels that still change t,
// half an epsilon each and at random, and of cn and sn made from t: sqrt(10)/2 + 2 < 4.
constexpr long few = 4;

// f(u, m) for all arguments and moduli above.
template <class T>
void for_all(const auto& f) {
    for (const auto& kc : moduli) {
        for (const auto& u : arguments) {
            INFO("u = " << u << ", k' = " << kc);
            f(typed<T>(u), at_complement<T>(kc));
        }
    }
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("sn, cn, dn and am are those of the table", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    using std::abs;
    const typename TestType::precision precision;
    for (const auto& row : tests::reference_table("jacobi.csv")) {
        INFO("u = " << row.at("u") << ", k' = " << row.at("kc"));
        const T u = typed<T>(row.at("u"));
        const auto m = at_complement<T>(row.at("kc"));
        const auto [sn, cn, dn] = jacobi(u, m);
        const auto [am_known, sn_known, cn_known, dn_known] = known(row, u, m.complement);
        CHECK_THAT(amplitude(u, m), near<T>(am_known, few));
        CHECK_THAT(sn, near<T>(sn_known, few));
        // u reduced by periods is rounded to T: |f'| times it is the scale of cn and dn, which fall like e^-u at k = 1.
        const T reduced = std::min(T(abs(u)), T(complete_integral(m) / 2));
        CHECK_THAT(cn, near<T>(cn_known, few, T(abs(cn) + reduced * abs(sn) * dn)));
        CHECK_THAT(dn, near<T>(dn_known, few, T(dn + reduced * m.k * m.k * abs(sn * cn))));
    }
}

TEMPLATE_LIST_TEST_CASE("the squares of sn, cn and dn sum to one", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for_all<T>([](const T& u, const modulus<T>& m) {
        const auto [sn, cn, dn] = jacobi(u, m);
        CHECK_THAT(T(sn * sn + cn * cn), near<T>(T(1), 2 * few));
        CHECK_THAT(T(dn * dn + m.k * m.k * sn * sn), near<T>(T(1), 2 * few));
        // dn^2 = cn^2 + k'^2 sn^2 keeps its digits where dn is small.
        CHECK_THAT(T(cn * cn + m.complement * m.complement * sn * sn), near<T>(T(dn * dn), 2 * few));
    });
}

TEMPLATE_LIST_TEST_CASE("sn and am are odd, cn and dn even", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for_all<T>([](const T& u, const modulus<T>& m) {
        const auto right = jacobi(u, m);
        const auto left = jacobi(T(-u), m);
        CHECK(left.sn == -right.sn);
        CHECK(left.cn == right.cn);
        CHECK(left.dn == right.dn);
        CHECK(amplitude(T(-u), m) == -amplitude(u, m));
    });
}

TEMPLATE_LIST_TEST_CASE("sine and cosine of the amplitude are sn and cn", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    using std::abs, std::cos, std::sin;
    const typename TestType::precision precision;
    // The sine of a large angle has the rounding of the angle.
    for_all<T>([](const T& u, const modulus<T>& m) {
        const T am = amplitude(u, m);
        const auto [sn, cn, dn] = jacobi(u, m);
        CHECK_THAT(T(sin(am)), near<T>(sn, few, T(1 + abs(am))));
        CHECK_THAT(T(cos(am)), near<T>(cn, few, T(1 + abs(am))));
    });
}

TEMPLATE_LIST_TEST_CASE("at k = 0 the functions are circular, at k = 1 nearly hyperbolic", "[elliptic][jacobi]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::abs, std::cos, std::cosh, std::sin, std::tanh;
    const typename TestType::precision precision;
    for (const auto* text : {"1e-8", "0.3", "-1.7", "2.5", "10"}) {
        INFO(text);
        const T u = typed<T>(text);
        const auto circular = jacobi(u, modulus<T>::from_modulus(T(0)));
        CHECK_THAT(circular.sn, near<T>(T(sin(u)), few));
        CHECK_THAT(circular.cn, near<T>(T(cos(u)), few, T(abs(cos(u)) + abs(u * sin(u)))));
        CHECK(circular.dn == 1);
        CHECK_THAT(amplitude(u, modulus<T>::from_modulus(T(0))), near<T>(u, few));
        // They differ from the hyperbolic ones by less than k'^2 cosh^2 u. The rounding of the
        // argument on its way counts u times in sech u.
        const auto hyperbolic = jacobi(u, at_complement<T>("1e-100"));
        const T sech = 1 / cosh(u);
        CHECK_THAT(hyperbolic.sn, near<T>(T(tanh(u)), few));
        CHECK_THAT(hyperbolic.cn, near<T>(sech, few, T(sech * (1 + abs(u)))));
        CHECK_THAT(hyperbolic.dn, near<T>(sech, few, T(sech * (1 + abs(u)))));
    }
}

TEMPLATE_LIST_TEST_CASE("a quarter period exchanges the functions", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto* text : {"0.9", "0.5", "0.1"}) {
        const auto m = at_complement<T>(text);
        const T quarter = complete_integral(m);
        const T u = T(1) / 4;
        const auto at = jacobi(u, m);
        const auto later = jacobi(T(u + quarter), m);
        // No slope is above 1: the error of the argument, on the scale of K, is all there is beside the functions' own.
        const T scale = quarter + 1;
        CHECK_THAT(later.sn, near<T>(T(at.cn / at.dn), few, scale));
        CHECK_THAT(later.cn, near<T>(T(-m.complement * at.sn / at.dn), few, scale));
        CHECK_THAT(later.dn, near<T>(T(m.complement / at.dn), few, scale));
        CHECK_THAT(amplitude(T(u + quarter * 2), m), near<T>(T(amplitude(u, m) + pi<T>()), few, T(scale * 2)));
        // [DLMF 22.5.2]: sn(K/2) = 1/sqrt(1+k'), dn(K/2) = sqrt k'; squares have twice the error.
        const auto half = jacobi(T(quarter / 2), m);
        CHECK_THAT(T(half.sn * half.sn * (1 + m.complement)), near<T>(T(1), 2 * few));
        CHECK_THAT(T(half.dn * half.dn), near<T>(m.complement, 2 * few));
    }
}

TEMPLATE_LIST_TEST_CASE("the addition theorem holds", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto* text : {"0.9", "0.5", "0.1", "1e-3", "1e-20"}) {
        const auto m = at_complement<T>(text);
        const T u = T(5) / 4;
        const T v = T(-3) / 8;
        const auto a = jacobi(u, m);
        const auto b = jacobi(v, m);
        const auto sum = jacobi(T(u + v), m);
        // [DLMF 22.8.1 - 22.8.3]: products of two functions.
        const T divisor = 1 - m.k * m.k * a.sn * a.sn * b.sn * b.sn;
        CHECK_THAT(sum.sn, near<T>(T((a.sn * b.cn * b.dn + b.sn * a.cn * a.dn) / divisor), 2 * few));
        CHECK_THAT(sum.cn, near<T>(T((a.cn * b.cn - a.sn * b.sn * a.dn * b.dn) / divisor), 2 * few));
        CHECK_THAT(sum.dn, near<T>(T((a.dn * b.dn - m.k * m.k * a.sn * b.sn * a.cn * b.cn) / divisor), 2 * few));
    }
}

TEMPLATE_LIST_TEST_CASE("a huge argument keeps its digits", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    using std::ldexp;
    const typename TestType::precision precision;
    for (const auto* text : {"0.9", "0.5"}) {
        const auto m = at_complement<T>(text);
        for (const int exponent : {20, 60, 200}) {
            INFO("u = 2^" << exponent << ", k' = " << text);
            // sn 2u = 2 sn cn dn / (1 - k^2 sn^4) [DLMF 22.6.5]: different quarter periods, and 2u is exact. The error
            // of the three functions counts over the divisor, at least k'^2.
            const auto [sn, cn, dn] = jacobi(ldexp(T(1), exponent), m);
            const T expected = sn * cn * dn * 2 / (1 - m.k * m.k * sn * sn * sn * sn);
            const T scale = 1 / (m.complement * m.complement);
            CHECK_THAT(jacobi(ldexp(T(1), exponent + 1), m).sn, near<T>(expected, 2 * few, scale));
        }
    }
}

TEST_CASE("sn' = cn dn, cn' = -sn dn, dn' = -k^2 sn cn, am' = dn", "[elliptic][jacobi]") {
    const precision_scope scope(100);
    const auto m = at_complement<mpfr>("0.3");
    // A central difference over h leaves h^2/6 times a third derivative below 8: h = 1e-20 leaves 2e-40.
    const auto h = typed<mpfr>("1e-20");
    const tests::expected_value left_out{mpfr(0), typed<mpfr>("2e-40")};
    for (const auto* text : {"0.2", "1.1", "-2.7", "100"}) {
        INFO(text);
        const auto u = typed<mpfr>(text);
        const auto before = jacobi(mpfr(u - h), m);
        const auto at = jacobi(u, m);
        const auto after = jacobi(mpfr(u + h), m);
        const auto slope_differs = [&](const mpfr& f, const mpfr& g, const mpfr& slope) {
            CHECK_THAT(mpfr((g - f) / (h * 2) - slope), near<mpfr>(left_out, 1));
        };
        slope_differs(before.sn, after.sn, at.cn * at.dn);
        slope_differs(before.cn, after.cn, -at.sn * at.dn);
        slope_differs(before.dn, after.dn, -m.k * m.k * at.sn * at.cn);
        slope_differs(amplitude(mpfr(u - h), m), amplitude(mpfr(u + h), m), at.dn);
    }
}

// Their error and ours.
TEST_CASE("Boost.Math agrees at benign moduli and arguments", "[elliptic][jacobi]") {
    for (const long double k : {0.1L, 0.5L, 0.8L, 0.95L}) {
        for (const long double u : {0.1L, 1.0L, -2.5L, 7.0L}) {
            INFO("u = " << u << ", k = " << k);
            long double cn = 0;
            long double dn = 0;
            const long double sn = boost::math::jacobi_elliptic(k, u, &cn, &dn);
            const auto ours = jacobi(u, modulus<long double>::from_modulus(k));
            CHECK_THAT(ours.sn, near<long double>(sn, 2 * few, 1.0L));
            CHECK_THAT(ours.cn, near<long double>(cn, 2 * few, 1.0L));
            CHECK_THAT(ours.dn, near<long double>(dn, 2 * few, 1.0L));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("there is no reduction by an infinite period", "[elliptic][jacobi]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(jacobi(T(1), modulus<T>::from_complement(T(0))), libration::error);
    CHECK_THROWS_AS(amplitude(T(1), modulus<T>::from_modulus(T(1))), libration::error);
}

}  // namespace elliptic_jacobi_test
