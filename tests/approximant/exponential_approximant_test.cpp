#include "libration/approximant/exponential_approximant.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace approximant_exponential_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

namespace {

// The series of sum_j a_j e^(-j rate t), j from 0.
template <class R>
power_series<R> sum_of_exponentials(const std::vector<R>& a, const R& rate, int order) {
    auto f = power_series<R>::zero(order);
    for (std::size_t j = 0; j < a.size(); ++j) {
        R term = a[j];
        for (int n = 0; n <= order; ++n) {
            f[n] = R(f[n] + term);
            term = R(R(term * rate * -static_cast<int>(j)) / (n + 1));
        }
    }
    return f;
}

const std::vector<rational> amplitudes{rational(9, 4), -3, rational(1, 2), 7, rational(-5, 3)};

}  // namespace

TEST_CASE("a sum of exponentials is recovered by its Vandermonde system over fractions", "[approximant][asymptotic]") {
    const rational rate(3, 7);
    const auto f = sum_of_exponentials(amplitudes, rate, 3);
    const auto a = exponential_sum(f, amplitudes[0], rate);
    REQUIRE(a.size() == 4);
    for (std::size_t j = 0; j < 4; ++j) {
        CHECK(a[j] == amplitudes[j + 1]);
    }
}

TEST_CASE("both forms of the exponential approximant are one polynomial", "[approximant][asymptotic]") {
    // sum A_j (1 - z)^j + limit against sum c_k z^k, for a series that is no sum of exponentials.
    const rational rate(3, 7);
    auto f = power_series<rational>::zero(6);
    for (int n = 0; n <= 6; ++n) {
        f[n] = rational(n % 3 == 1 ? -2 : 5, n + 1);
    }
    const rational limit(4, 9);
    const auto a = exponential_sum(f, limit, rate);
    const auto c = series_in_decay(f, rate);
    auto expanded = power_series<rational>::zero(7);
    expanded[0] = limit;
    for (std::size_t j = 0; j < a.size(); ++j) {
        rational binomial = a[j];
        for (int k = 0; k <= static_cast<int>(j) + 1; ++k) {
            expanded[k] += binomial;
            binomial *= rational(-(static_cast<int>(j) + 1 - k), k + 1);
        }
    }
    for (int k = 0; k <= 6; ++k) {
        CHECK(expanded[k] == c[k]);
    }
}

TEMPLATE_LIST_TEST_CASE("the exponential approximant of its own form is exact everywhere", "[approximant][asymptotic]",
                        all_scalars) {
    using T = typename TestType::type;
    using std::exp;
    const typename TestType::precision precision;
    std::vector<T> a;
    for (const rational& each : amplitudes) {
        a.push_back(from_rational<T>(each));
    }
    const T rate = T(3) / 7;
    const exponential_approximant<T> of(sum_of_exponentials(a, rate, 3), a[0], rate);
    REQUIRE(of.order() == 4);
    for (const int t : {0, 1, 5, 40}) {
        T value = a[0];
        T slope(0);
        for (int j = 1; j <= 4; ++j) {
            const T decay = exp(T(-rate * t * j));
            value += a[static_cast<std::size_t>(j)] * decay;
            slope -= a[static_cast<std::size_t>(j)] * rate * j * decay;
        }
        // The c_k reach 30, the arguments of the exponentials 70: each loses as many eps.
        CHECK_THAT(of.value(T(t)), near(value, 200, T(30)));
        CHECK_THAT(of(T(t)).slope, near(slope, 400, T(30)));
    }
}

}  // namespace approximant_exponential_test
