#include "libration/elliptic/landen.hpp"

#include <catch2/catch.hpp>

#include "elliptic/table_input.hpp"

namespace elliptic_landen_test {

using namespace libration;
using namespace libration::elliptic;
using libration::tests::all_scalars;

namespace {

constexpr auto moduli = {"1", "0.999999", "0.9", "0.5", "0.1", "1e-3", "1e-10", "1e-50", "1e-100"};

template <class T>
landen_chain<T> chain_of(const T& complement) {
    return landen_chain<T>(modulus<T>::from_complement(complement));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("agm(1, sqrt 2) is what Gauss found", "[elliptic][landen]", all_scalars) {
    using T = typename TestType::type;
    using std::sqrt;
    const typename TestType::precision precision;
    // OEIS A053004. agm(1, sqrt 2) = sqrt 2 agm(1, 1/sqrt 2).
    const auto known = tests::decimal(
        "1."
        "198140234735592207439922492280323878227212663215651558263674952946405214143915670835885556489793389375907225");
    const T root = sqrt(T(2));
    // Each of the three levels that still change the mean rounds it by half an epsilon; sqrt 2 counts half (agm grows
    // less than its argument), and the product its half.
    CHECK_THAT(T(root * chain_of(T(1 / root)).mean()), tests::near<T>(known, 2));
}

TEMPLATE_LIST_TEST_CASE("a step of the chain leaves the mean where it is", "[elliptic][landen]", all_scalars) {
    using T = typename TestType::type;
    using std::sqrt;
    const typename TestType::precision precision;
    for (const auto* text : moduli) {
        INFO(text);
        const T b = tests::typed<T>(text);
        // agm(1, b) = (1+b)/2 agm(1, 2 sqrt b/(1+b)). A level rounds the mean by half an epsilon, at random: two means
        // of up to 13 levels that change, sqrt(26)/2 < 3, and the argument of the second.
        const T stepped = chain_of(T(sqrt(b) * 2 / (1 + b))).mean() * (1 + b) / 2;
        CHECK_THAT(stepped, tests::near<T>(chain_of(b).mean(), 4));
    }
}

TEMPLATE_LIST_TEST_CASE("the number of levels leaves nothing to compute", "[elliptic][landen]", all_scalars) {
    using T = typename TestType::type;
    using std::abs;
    const typename TestType::precision precision;
    for (const auto* text : moduli) {
        INFO(text);
        const auto chain = chain_of(tests::typed<T>(text));
        // k_N^2 = (a-b)(a+b)/a^2 is below epsilon/32 in exact arithmetic; the roundings of a and b, half an epsilon
        // each, are what is left to see of it.
        CHECK(abs(chain.last_parameter()) <= epsilon<T>() * 2);
        CHECK(chain.a(0) == 1);
        CHECK(chain.b(0) == chain.top().complement);
    }
}

TEST_CASE("the levels given by the precision suffice in exact arithmetic", "[elliptic][landen]") {
    // The count of a 40-digit chain, run with many more digits.
    for (const auto* text : moduli) {
        INFO(text);
        int levels = 0;
        mpfr promised;
        {
            const precision_scope scope(40);
            levels = chain_of(tests::typed<mpfr>(text)).levels();
            promised = epsilon<mpfr>() / 32;
        }
        const precision_scope scope(400);
        const auto fine = chain_of(tests::typed<mpfr>(text));
        REQUIRE(fine.levels() >= levels);
        const mpfr ratio = fine.b(levels) / fine.a(levels);
        CHECK(1 - ratio * ratio < promised);
    }
}

TEMPLATE_LIST_TEST_CASE("the chain has no end at k = 1", "[elliptic][landen]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK_THROWS_AS(chain_of(T(0)), libration::error);
    CHECK_THROWS_WITH(landen_chain<T>(modulus<T>::from_modulus(T(1))), Catch::Contains("K(1)"));
}

}  // namespace elliptic_landen_test
