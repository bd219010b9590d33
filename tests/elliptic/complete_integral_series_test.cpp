#include "libration/elliptic/complete_integral_series.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "libration/elliptic/complete_integral.hpp"
#include "scalars.hpp"

namespace elliptic_complete_integral_series_test {

using namespace libration;
using namespace libration::elliptic;
using libration::tests::all_scalars;

namespace {

// ((2n)!/n!^2)^2 16^-n exactly.
rational weight(int n) {
    integer binomial = 1;
    for (int i = 1; i <= n; ++i) {
        binomial = binomial * (n + i) / i;
    }
    return {binomial * binomial, integer(1) << (4 * n)};
}

// At k = 1/2, which every scalar holds: the sum without its factor pi/2, and the sum of k^(2n)/(2n+1).
struct partial_sums {
    rational weights = 0;
    rational odd = 0;
};
partial_sums exact_sums(int order) {
    partial_sums sums;
    for (int n = 0; n <= order; ++n) {
        const rational power(integer(1), integer(1) << (2 * n));
        sums.weights += weight(n) * power;
        sums.odd += power / (2 * n + 1);
    }
    return sums;
}

tests::expected_value with_digits(const auto& compute) {
    const precision_scope scope(200);
    return tests::exactly(mpfr(compute()));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("partial sums of both series are those of exact fractions", "[elliptic][complete_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto m = modulus<T>::from_modulus(T(T(1) / 2));
    for (const int order : {0, 1, 2, 5, 10, 30}) {
        INFO(order);
        const auto sums = exact_sums(order);
        const auto plain = with_digits([&] { return from_rational<mpfr>(sums.weights) * pi<mpfr>() / 2; });
        // artanh(1/2)/(1/2) = log 3.
        const auto resummed = with_digits([&] {
            return from_rational<mpfr>(sums.weights) * pi<mpfr>() / 2 - from_rational<mpfr>(sums.odd) + log(mpfr(3));
        });
        // An addition rounds by half an epsilon, at random: sqrt(30)/2 < 3 for the most; and 1 for pi/2 and products.
        CHECK_THAT(complete_integral_series(m, order), tests::near<T>(plain, 4));
        CHECK_THAT(complete_integral_resummed(m, order), tests::near<T>(resummed, 4));
    }
}

TEMPLATE_LIST_TEST_CASE("the series misses K by no more than its proven tail", "[elliptic][complete_series]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto m = modulus<T>::from_modulus(T(T(1) / 2));
    const mpfr value = widen(complete_integral(m));
    const mpfr rounding = widen(epsilon<T>()) * 4;  // of K = 1.69 and of the sum
    for (int order = 0; order <= 40; order += 4) {
        const auto next = with_digits(
            [&] { return from_rational<mpfr>(weight(order + 1) / (integer(1) << (2 * order + 2))) * pi<mpfr>() / 2; });
        const mpfr missed = value - widen(complete_integral_series(m, order));
        INFO(order);
        CHECK(missed >= next.value - rounding);          // all terms are positive
        CHECK(missed <= next.value * 4 / 3 + rounding);  // k'^2 = 3/4
    }
}

TEMPLATE_LIST_TEST_CASE("both series have K as their limit", "[elliptic][complete_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto m = modulus<T>::from_modulus(T(T(1) / 2));
    const int order = digits<T>() / 2 + 1;  // k^2 = 1/4
    // An addition rounds by half an epsilon of at most K, at random: sqrt(168)/2 < 7 for the most, and 3 for K itself.
    CHECK_THAT(complete_integral_series(m, order), tests::near<T>(complete_integral(m), 10));
    CHECK_THAT(complete_integral_resummed(m, order), tests::near<T>(complete_integral(m), 10));
    const auto round = modulus<T>::from_modulus(T(0));
    CHECK(complete_integral_series(round, 0) == pi<T>() / 2);
    CHECK(complete_integral_resummed(round, 7) == pi<T>() / 2);
}

TEMPLATE_LIST_TEST_CASE("artanh(k)/k has its digits at both ends", "[elliptic][complete_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // The quotient k/k', arsinh and the quotient by k: half an epsilon each, arsinh of quad up to 2 more.
    const auto at = [](const modulus<T>& m) { return artanh_over_modulus(m); };
    CHECK(at(modulus<T>::from_modulus(T(0))) == 1);
    const T tiny = from_exact<T>(read_exact("1e-60"));
    CHECK_THAT(at(modulus<T>::from_modulus(tiny)), tests::near<T>(T(1), 3));
    const auto three = with_digits([] { return log(mpfr(3)); });
    CHECK_THAT(at(modulus<T>::from_modulus(T(T(1) / 2))), tests::near<T>(three, 3));
    // k -> 1: log(2/k'), next term of the order k'^2 log k'.
    // Here k'^2 is below the range of double.
    const T tinier = from_exact<T>(read_exact("1e-200"));
    const auto steep = with_digits([&] { return log(2 / narrow<mpfr>(widen(tinier))); });
    CHECK_THAT(at(modulus<T>::from_complement(tinier)), tests::near<T>(steep, 3));
}

TEMPLATE_LIST_TEST_CASE("at k = 1 the brackets sum to log 2, slowly", "[elliptic][complete_series]", all_scalars) {
    using T = typename TestType::type;
    using std::log;
    const typename TestType::precision precision;
    const auto m = modulus<T>::from_both(T(1), from_exact<T>(read_exact("1e-3")));  // artanh stays finite
    for (const int order : {10, 100, 1000}) {
        INFO(order);
        const T brackets = complete_integral_resummed(m, order) - artanh_over_modulus(m);
        // Brackets are 1/(8 n^2) - 7/(64 n^3) + ..., their tail is 1/(8N) (1 - 15/(16 N) + O(N^-2)).
        const T scaled_tail = (log(T(2)) - brackets) * (8 * order);
        CHECK(scaled_tail < 1);
        CHECK((1 - scaled_tail) * order < 1);
        CHECK((1 - scaled_tail) * order > T(3) / 4);
    }
}

TEST_CASE("the proved bounds are above what the sums leave out, and never more than 1.4 times",
          "[elliptic][complete_series]") {
    std::mt19937 engine(20241121);
    std::uniform_int_distribution<int> digit(1, 999);
    std::uniform_int_distribution<int> exponent(0, 30);
    mpfr most(0);
    for (int i = 0; i < 60; ++i) {
        const precision_scope scope(500);  // k^(2N) down to 1e-3 to the power 2 * 60 is left out
        const mpfr part = mpfr(digit(engine)) / 1000;
        // Every second k' is small: next to k = 1 the bounds have to hold as well.
        const mpfr small = part * pow(mpfr(10), -exponent(engine));
        const auto m = i % 2 == 0 ? modulus<mpfr>::from_modulus(part) : modulus<mpfr>::from_complement(small);
        const mpfr exact = complete_integral(m);
        for (const int order : {0, 1, 2, 3, 7, 20, 60}) {
            INFO("k = " << to_decimal(m.k, 10) << ", k' = " << to_decimal(m.complement, 10) << ", N = " << order);
            const mpfr plain = exact - complete_integral_series(m, order);
            const mpfr resummed = exact - complete_integral_resummed(m, order);
            CHECK(resummed > 0);
            CHECK(plain > resummed);
            CHECK(complete_integral_series_bound(m, order) >= plain);
            CHECK(complete_integral_resummed_bound(m, order) >= resummed);
            most = std::max({most, mpfr(complete_integral_series_bound(m, order) / plain),
                             mpfr(complete_integral_resummed_bound(m, order) / resummed)});
        }
    }
    CHECK(most < mpfr(14) / 10);  // recorded: 1.36, at N = 0
}

TEMPLATE_LIST_TEST_CASE("the bounds have the digits of the scalar", "[elliptic][complete_series]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto m = modulus<T>::from_modulus(T(T(1) / 2));
    // N = 1: c_2 = (pi/2) 9/64, k^4 = 1/16, log(1 + 2/3); and 8/(15 (8 + 45/4)) / 16.
    const auto plain = with_digits([] { return pi<mpfr>() * 45 * log(mpfr(5) / 3) / 4096; });
    const auto resummed = with_digits([] { return mpfr(32) / (15 * 77) / 16; });
    // Ten operations of half an epsilon, and the logarithm of 1 + x, x = 2/3 to an epsilon: another one of 0.8.
    CHECK_THAT(complete_integral_series_bound(m, 1), tests::near<T>(plain, 6));
    CHECK_THAT(complete_integral_resummed_bound(m, 1), tests::near<T>(resummed, 6));
    const auto round = modulus<T>::from_modulus(T(0));
    CHECK(complete_integral_series_bound(round, 3) == 0);
    CHECK(complete_integral_resummed_bound(round, 3) == 0);
    CHECK_THROWS_AS(complete_integral_resummed_bound(round, -1), libration::error);
    CHECK_THROWS_AS(complete_integral_series_bound(round, -1), libration::error);
}

TEST_CASE("a partial sum of negative order is refused with its value", "[elliptic][complete_series]") {
    const auto m = modulus<double>::from_modulus(0.5);
    CHECK_THROWS_AS(complete_integral_series(m, -1), libration::error);
    CHECK_THROWS_WITH(complete_integral_resummed(m, -7), Catch::Contains("-7"));
}

}  // namespace elliptic_complete_integral_series_test
