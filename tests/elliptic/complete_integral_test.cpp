#include "libration/elliptic/complete_integral.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <catch2/catch.hpp>

#include "elliptic/table_input.hpp"
#include "reference_table.hpp"

namespace elliptic_complete_integral_test {

using namespace libration;
using namespace libration::elliptic;
using libration::tests::all_scalars;

namespace {

template <class T>
T complete_at(const T& complement) {
    return complete_integral(modulus<T>::from_complement(complement));
}

// int_0^{pi/2} dphi / sqrt(cos^2 phi + k'^2 sin^2 phi), k' in eighths, by the trapezoidal rule, which converges
// geometrically over a period: the nearest singularity of the integrand, pi/2 + i artanh k', is 0.549 away at k' = 1/2
// and leaves e^(-4 n 0.549) for n intervals, 1e-143 for 150.
tests::expected_value integral_at(int eighths) {
    const precision_scope scope(120);
    const mpfr complement = mpfr(eighths) / 8;
    constexpr int intervals = 150;
    mpfr sum = (1 + 1 / complement) / 2;
    for (int i = 1; i < intervals; ++i) {
        const mpfr phi = pi<mpfr>() * i / (2 * intervals);
        const mpfr shrunk = complement * sin(phi);
        sum += 1 / sqrt(cos(phi) * cos(phi) + shrunk * shrunk);
    }
    return tests::exactly(mpfr(sum * pi<mpfr>() / (2 * intervals)));
}

// K' of the table, for the k that belongs to the k' held: next to k' = 1 that is quite another one than typed.
template <class T>
tests::expected_value complementary_at(const tests::table_row& row) {
    const T complement = tests::typed<T>(row.at("kc"));
    const precision_scope scope(250);
    const auto held = modulus<mpfr>::from_complement(narrow<mpfr>(widen(complement)));
    const auto exact = modulus<mpfr>::from_complement(tests::typed<mpfr>(row.at("kc")));
    return tests::moved(row.at("K_complementary"), complete_integral(held.swapped()),
                        complete_integral(exact.swapped()));
}

// OEIS A068466.
const tests::expected_value gamma_of_quarter = tests::decimal(
    "3."
    "625609908221908311930685155867672002995167682880065467433377999569919243538729121618360136723384300361471751392420"
    "719966");

}  // namespace

// Each level of the mean rounds it by half an epsilon, at random: sqrt(levels)/2 < 2 for all moduli here. The rounding
// of k' (which K passes on at most once: |k' K'(k')/K| < 1), of pi and of the quotient are the rest.
constexpr long few = 3;

TEMPLATE_LIST_TEST_CASE("K is its integral", "[elliptic][complete_integral]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const int eighths : {4, 6, 7}) {
        INFO("k' = " << eighths << "/8");
        CHECK_THAT(complete_at(T(T(eighths) / 8)), tests::near<T>(integral_at(eighths), few));
    }
}

TEMPLATE_LIST_TEST_CASE("K is pi/2 at k = 0 and Gauss's lemniscate at k = 1/sqrt 2", "[elliptic][complete_integral]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::sqrt;
    const typename TestType::precision precision;
    CHECK(complete_at(T(1)) == pi<T>() / 2);
    tests::expected_value lemniscate = gamma_of_quarter;
    {
        const precision_scope scope(150);
        lemniscate.value = gamma_of_quarter.value * gamma_of_quarter.value / (4 * sqrt(pi<mpfr>()));
        lemniscate.uncertainty *= 2;
    }
    CHECK_THAT(complete_at(T(1 / sqrt(T(2)))), tests::near<T>(lemniscate, few));
}

TEMPLATE_LIST_TEST_CASE("the singular value k = sin(pi/12) has K'/K = sqrt 3", "[elliptic][complete_integral]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::sqrt;
    const typename TestType::precision precision;
    const T k = (sqrt(T(6)) - sqrt(T(2))) / 4;
    const auto m = modulus<T>::from_modulus(k);
    // Two integrals, and k rounded thrice, which moves K'/K by its 0.4.
    CHECK_THAT(T(complete_integral(m.swapped()) / complete_integral(m)), tests::near<T>(T(sqrt(T(3))), 2 * few + 1));
}

TEMPLATE_LIST_TEST_CASE("K and K' are those of the table", "[elliptic][complete_integral]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto& row : tests::reference_table("complete.csv")) {
        const std::string& typed = row.at("kc");
        INFO(typed);
        const auto m = modulus<T>::from_complement(tests::typed<T>(typed));
        CHECK_THAT(complete_integral(m), tests::near<T>(tests::decimal(row.at("K")), few));
        if (row.at("K_complementary") != "inf") {
            CHECK_THAT(complete_integral(m.swapped()), tests::near<T>(complementary_at<T>(row), few));
        }
    }
}

TEST_CASE("Boost.Math agrees at benign moduli", "[elliptic][complete_integral]") {
    for (int tenths = 0; tenths <= 9; ++tenths) {
        const long double k = tenths / 10.0L;
        CHECK_THAT(complete_integral(modulus<long double>::from_modulus(k)),
                   tests::near<long double>(boost::math::ellint_1(k), few));
    }
}

TEMPLATE_LIST_TEST_CASE("K is infinite at k = 1, and K' at k = 0", "[elliptic][complete_integral]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(complete_at(T(0)), libration::error);
    CHECK_THROWS_AS(complete_integral(modulus<T>::from_modulus(T(0)).swapped()), libration::error);
}

}  // namespace elliptic_complete_integral_test
