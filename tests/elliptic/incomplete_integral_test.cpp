#include "libration/elliptic/incomplete_integral.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <catch2/catch.hpp>
#include <utility>

#include "elliptic/table_input.hpp"
#include "libration/elliptic/jacobi.hpp"
#include "reference_table.hpp"

namespace elliptic_incomplete_integral_test {

using namespace libration;
using namespace libration::elliptic;
using libration::tests::all_scalars;
using libration::tests::near;
using libration::tests::typed;

namespace {

template <class T>
modulus<T> at_complement(const std::string& text) {
    return modulus<T>::from_complement(typed<T>(text));
}

// F of the table's row, for the angle and k' as held.
template <class T>
tests::expected_value known(const tests::table_row& row, const T& phi, const T& complement) {
    const precision_scope scope(250);
    const auto m_held = modulus<mpfr>::from_complement(narrow<mpfr>(widen(complement)));
    const mpfr held = incomplete_integral(narrow<mpfr>(widen(phi)), m_held);
    const mpfr exact = incomplete_integral(typed<mpfr>(row.at("phi")), at_complement<mpfr>(row.at("kc")));
    return tests::moved(row.at("F"), held, exact);
}

// The mean's error and K's, 3; and the angle doubles at each level with roundings of half an epsilon that halve in
// weight from level to level, adding up to those of two in either of its two terms.
constexpr long few = 5;

}  // namespace

TEMPLATE_LIST_TEST_CASE("F is that of the table", "[elliptic][incomplete_integral]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& row : tests::reference_table("incomplete.csv")) {
        INFO("phi = " << row.at("phi") << ", k' = " << row.at("kc"));
        const T phi = typed<T>(row.at("phi"));
        const auto m = at_complement<T>(row.at("kc"));
        CHECK_THAT(incomplete_integral(phi, m), near<T>(known(row, phi, m.complement), few));
    }
}

TEMPLATE_LIST_TEST_CASE("F and the amplitude are inverse", "[elliptic][incomplete_integral]", all_scalars) {
    using T = typename TestType::type;
    using std::abs;
    const typename TestType::precision precision;
    for (const auto* kc : {"1", "0.999999", "0.5", "1e-3", "1e-20"}) {
        const auto m = at_complement<T>(kc);
        for (const auto* text : {"1e-8", "0.5", "1.57", "3", "-2", "100"}) {
            INFO("phi = " << text << ", k' = " << kc);
            const T phi = typed<T>(text);
            const T F = incomplete_integral(phi, m);
            // An error of F is dn times it in am.
            CHECK_THAT(amplitude(F, m), near<T>(phi, 2 * few, T(abs(phi) + abs(F) * jacobi(F, m).dn)));
        }
        for (const auto* text : {"1e-8", "0.3", "2.5", "-40", "1e6"}) {
            INFO("u = " << text << ", k' = " << kc);
            const T u = typed<T>(text);
            const T am = amplitude(u, m);
            // An error of am is 1/dn times it in F.
            CHECK_THAT(incomplete_integral(am, m), near<T>(u, 2 * few, T(abs(u) + abs(am) / jacobi(u, m).dn)));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("next to an odd multiple of pi/2 the integral keeps its digits",
                        "[elliptic][incomplete_integral]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto* kc : {"1e-3", "1e-20", "1e-100"}) {
        const auto m = at_complement<T>(kc);
        for (const int odd : {1, 3, -5, 999}) {
            INFO("phi = " << odd << " pi/2 as held, k' = " << kc);
            const T phi = pi<T>() * odd / 2;
            // What the rounding of phi leaves to the quarter period is a cosine, taken with many digits here, and
            // F(phi) = odd K - (F of the angle with this cosine next to pi/2, taken from K) [DLMF 19.2.10].
            const auto left_over = [&] {
                const precision_scope scope(250);
                const mpfr difference = pi<mpfr>() * odd / 2 - narrow<mpfr>(widen(phi));
                return std::pair{narrow<T>(mpfr(sin(difference))), narrow<T>(mpfr(cos(difference)))};
            }();
            const landen_chain<T> chain(m);
            // F(pi/2) - F(pi/2 - d) = F(psi), tan psi = tan d / k' [DLMF 19.11.7].
            const T part = incomplete_integral(left_over.first, T(m.complement * left_over.second), chain);
            CHECK_THAT(incomplete_integral(phi, m), near<T>(T(complete_integral(m) * odd - part), 2 * few));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("F is odd, the angle at k = 0, and gains 2K with pi", "[elliptic][incomplete_integral]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto* text : {"1e-8", "0.5", "1.57", "3", "100"}) {
        INFO(text);
        const T phi = typed<T>(text);
        CHECK_THAT(incomplete_integral(phi, modulus<T>::from_modulus(T(0))), near<T>(phi, few));
        for (const auto* kc : {"0.9", "0.1", "1e-3"}) {
            const auto m = at_complement<T>(kc);
            CHECK(incomplete_integral(T(-phi), m) == -incomplete_integral(phi, m));
        }
    }
    for (const auto* kc : {"0.9", "0.1", "1e-3"}) {
        const auto m = at_complement<T>(kc);
        const T K = complete_integral(m);
        CHECK(incomplete_integral(T(0), m) == 0);
        CHECK_THAT(incomplete_integral(T(T(1) / 4 + pi<T>()), m),
                   near<T>(T(incomplete_integral(T(T(1) / 4), m) + K * 2), few));
    }
}

TEMPLATE_LIST_TEST_CASE("F from a sine and a cosine does not ask for their length", "[elliptic][incomplete_integral]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto* kc : {"0.9", "0.1", "1e-20"}) {
        const auto m = at_complement<T>(kc);
        const landen_chain<T> chain(m);
        const T F = incomplete_integral(T(3), T(4), chain);
        CHECK(incomplete_integral(T(12), T(16), chain) == F);
        CHECK(incomplete_integral(T(-3), T(4), chain) == -F);
        // cos = 0 is the whole quarter period.
        CHECK_THAT(incomplete_integral(T(1), T(0), chain), near<T>(complete_integral(m), few));
        // F(phi) + F(psi) = K where tan phi tan psi = 1/k' [DLMF 19.11.7].
        CHECK_THAT(T(F + incomplete_integral(T(4), T(m.complement * 3), chain)), near<T>(complete_integral(m), few));
    }
}

// Their error and ours.
TEST_CASE("Boost.Math agrees at benign moduli and angles", "[elliptic][incomplete_integral]") {
    for (const long double k : {0.1L, 0.5L, 0.8L, 0.95L}) {
        for (const long double phi : {0.1L, 1.0L, -1.5L, 7.0L}) {
            INFO("phi = " << phi << ", k = " << k);
            CHECK_THAT(incomplete_integral(phi, modulus<long double>::from_modulus(k)),
                       near<long double>(boost::math::ellint_1(k, phi), 2 * few));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("F has no value at k = 1", "[elliptic][incomplete_integral]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(incomplete_integral(T(1), modulus<T>::from_complement(T(0))), libration::error);
}

}  // namespace elliptic_incomplete_integral_test
