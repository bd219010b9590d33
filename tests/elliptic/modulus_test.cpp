#include "libration/elliptic/modulus.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace elliptic_modulus_test {

using namespace libration;
using namespace libration::elliptic;
using libration::tests::all_scalars;

namespace {

// sqrt(1 - x^2) of the value held, with digits for x = 1e-100 on either side of the subtraction.
template <class T>
tests::expected_value other_side(const T& x) {
    const precision_scope scope(500);
    const mpfr wide = narrow<mpfr>(widen(x));
    return tests::exactly(mpfr(sqrt(1 - wide * wide)));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("either modulus gives the other to full relative precision", "[elliptic][modulus]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const auto* text : {"1e-100", "1e-20", "0.001", "0.1", "0.5", "0.9", "0.999999"}) {
        INFO(text);
        const T x = from_exact<T>(read_exact(text));
        const auto from_k = modulus<T>::from_modulus(x);
        const auto from_complement = modulus<T>::from_complement(x);
        CHECK(from_k.k == x);
        CHECK(from_complement.complement == x);
        // 1 - x is exact above 1/2, and where it is rounded its half epsilon counts half under the root, as do 1 + x
        // and the product; the root adds its own half.
        CHECK_THAT(from_k.complement, tests::near<T>(other_side(x), 2));
        CHECK_THAT(from_complement.k, tests::near<T>(other_side(x), 2));
    }
}

TEMPLATE_LIST_TEST_CASE("the ends of the range are exact", "[elliptic][modulus]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(modulus<T>::from_modulus(T(0)).complement == 1);
    CHECK(modulus<T>::from_modulus(T(1)).complement == 0);
    CHECK(modulus<T>::from_complement(T(0)).k == 1);
    CHECK(modulus<T>::from_complement(T(1)).k == 0);
}

TEMPLATE_LIST_TEST_CASE("exchanging the moduli twice gives them back", "[elliptic][modulus]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto m = GENERATE(modulus<T>::from_modulus(T(T(1) / 3)), modulus<T>::from_complement(T(T(1) / 3)));
    const auto once = m.swapped();
    CHECK(once.k == m.complement);
    CHECK(once.complement == m.k);
    CHECK(once.given != m.given);
    const auto twice = once.swapped();
    CHECK(twice.k == m.k);
    CHECK(twice.complement == m.complement);
    CHECK(twice.given == m.given);
}

TEMPLATE_LIST_TEST_CASE("more digits come from the given one of the pair", "[elliptic][modulus]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T tiny = from_exact<T>(read_exact("1e-30"));
    const auto near_one = modulus<T>::from_complement(tiny);
    const auto near_zero = modulus<T>::from_modulus(tiny);
    const auto swapped = near_one.swapped();
    const precision_scope scope(200);
    // k = sqrt(1 - k'^2) = 1 - 5e-61 - ..., next term (k'^2)^2 / 8.
    const tests::expected_value defect = tests::exactly(mpfr(widen(tiny) * widen(tiny) / 2));
    CHECK_THAT(convert<double>(mpfr(1 - wide_modulus(near_one).k)), tests::near<double>(defect, 1));
    CHECK_THAT(convert<double>(mpfr(1 - wide_modulus(near_zero).complement)), tests::near<double>(defect, 1));
    CHECK_THAT(convert<double>(mpfr(1 - wide_modulus(swapped).complement)), tests::near<double>(defect, 1));
    CHECK(wide_modulus(near_one).complement == widen(tiny));
    CHECK(wide_modulus(near_zero).k == widen(tiny));
}

TEMPLATE_LIST_TEST_CASE("both moduli may be given where both are known", "[elliptic][modulus]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const T tiny = from_exact<T>(read_exact("1e-80"));
    const auto m = modulus<T>::from_both(tiny, T(1));
    CHECK(m.k == tiny);
    CHECK(m.complement == 1);
    const precision_scope scope(200);
    CHECK(wide_modulus(m).k == widen(tiny));  // the smaller one tells, at either end
    CHECK(wide_modulus(m.swapped()).complement == widen(tiny));
    CHECK(wide_modulus(modulus<T>::from_both(T(1), tiny)).complement == widen(tiny));
}

}  // namespace elliptic_modulus_test
