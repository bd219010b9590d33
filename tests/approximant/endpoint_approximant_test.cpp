#include "libration/approximant/endpoint_approximant.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"
#include "series/random_series.hpp"

namespace approximant_endpoint_approximant_test {

using namespace libration;
using namespace libration::series;
using libration::tests::all_scalars;
using libration::tests::near;

namespace {

// A function by N + 1 Taylor coefficients at 0 and m at 1.
template <class T>
struct two_ends {
    power_series<T> series;
    std::vector<T> endpoint;
};

// 1/(2-x) = sum x^n / 2^(n+1) = sum (x-1)^j: all of its approximants are exact in every scalar.
template <class T>
two_ends<T> reciprocal(int order, int m) {
    auto series = power_series<T>::zero(order);
    series[0] = T(1) / 2;
    for (int n = 1; n <= order; ++n) {
        series[n] = series[n - 1] / 2;
    }
    return {series, std::vector<T>(static_cast<std::size_t>(m), T(1))};
}

template <class T>
two_ends<T> exponential_function(int order, int m) {
    using std::exp;
    two_ends<T> f{power_series<T>::zero(order), {}};
    T factorial(1);
    for (int n = 0; n <= order; ++n) {
        f.series[n] = 1 / factorial;
        factorial *= n + 1;
    }
    factorial = T(1);
    for (int j = 0; j < m; ++j) {
        f.endpoint.push_back(exp(T(1)) / factorial);
        factorial *= j + 1;
    }
    return f;
}

// p^(j)(1)/j! = sum_n C(n, j) p_n.
template <class T>
T taylor_at_one(const power_series<T>& p, int j) {
    T sum(0);
    for (int n = j; n <= p.order(); ++n) {
        T binomial(1);
        for (int i = 0; i < j; ++i) {
            binomial = binomial * (n - i) / (i + 1);
        }
        sum += binomial * p[n];
    }
    return sum;
}

// The factored form multiplied out: sum_j e_j (x-1)^j + (1-x)^m h.
template <class T>
power_series<T> multiplied_out(const power_series<T>& inner, const std::vector<T>& endpoint) {
    const int m = static_cast<int>(endpoint.size());
    const int degree = inner.order() + m;
    const auto padded = [&](std::vector<T> coefficients) {
        coefficients.resize(static_cast<std::size_t>(degree) + 1, T(0));
        return power_series<T>(coefficients);
    };
    const auto x_minus_one = padded({T(-1), T(1)});
    auto product = padded(inner.coefficients());
    auto sum = padded({T(0)});
    auto power = padded({T(1)});
    for (int j = 0; j < m; ++j) {
        sum = sum + padded({endpoint[static_cast<std::size_t>(j)]}) * power;
        power = power * x_minus_one;
        product = padded({T(0)}) - product * x_minus_one;
    }
    return sum + product;
}

// What h is summed from, without its cancellation: (|a| + sum_j |e_j| (1+x)^j) / (1-x)^m.
template <class T>
power_series<T> magnitude_of_inner(const two_ends<T>& f) {
    auto magnitude = f.series;
    auto one_minus_x = power_series<T>::zero(f.series.order());
    one_minus_x[0] = T(1);
    one_minus_x[1] = T(-1);
    for (std::size_t j = 0; j < f.endpoint.size(); ++j) {
        T binomial(1);
        for (std::size_t i = 0; i <= j; ++i) {
            magnitude[static_cast<int>(i)] += f.endpoint[j] * binomial;
            binomial = binomial * static_cast<int>(j - i) / static_cast<int>(i + 1);
        }
    }
    for (std::size_t j = 0; j < f.endpoint.size(); ++j) {
        magnitude = magnitude / one_minus_x;
    }
    return magnitude;
}

constexpr int order = 10;

}  // namespace

TEMPLATE_LIST_TEST_CASE("the approximant has N+1 coefficients of f at 0 and m at 1, and degree N+m",
                        "[approximant][endpoint]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int m = GENERATE(0, 1, 2, 3, 5, order + 1);
    const auto f = reciprocal<T>(order, m);
    const auto p = endpoint_corrected(f.series, f.endpoint);
    CHECK(p.order() == order + m);
    CHECK(p.truncated(order).coefficients() == f.series.coefficients());
    for (int j = 0; j < m; ++j) {
        CHECK(taylor_at_one(p, j) == f.endpoint[static_cast<std::size_t>(j)]);
    }
}

TEMPLATE_LIST_TEST_CASE("both forms are one polynomial, both ways to the inner series one series",
                        "[approximant][endpoint]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int m = GENERATE(0, 1, 2, 3, 5, order + 1);
    const auto f = reciprocal<T>(order, m);
    const auto inner = inner_series(f.series, f.endpoint);
    CHECK(inner_series_by_convolution(f.series, f.endpoint).coefficients() == inner.coefficients());
    CHECK(multiplied_out(inner, f.endpoint).coefficients() == endpoint_corrected(f.series, f.endpoint).coefficients());
    const endpoint_approximant<T> factored(f.series, f.endpoint);
    CHECK(factored.order() == order);
    CHECK(factored.inner().coefficients() == inner.coefficients());
}

TEMPLATE_LIST_TEST_CASE("the forms agree to rounding where coefficients are rounded", "[approximant][endpoint]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int m = GENERATE(0, 1, 2, 3, 5);
    const auto f = exponential_function<T>(order, m);
    const endpoint_approximant<T> factored(f.series, f.endpoint);
    const auto corrected = endpoint_corrected(f.series, f.endpoint);
    const auto convolved = inner_series_by_convolution(f.series, f.endpoint);
    const auto scale = magnitude_of_inner(f);
    for (int n = 0; n <= order; ++n) {
        INFO("m = " << m << ", degree " << n);
        CHECK_THAT(factored.inner()[n], near<T>(convolved[n], 1, scale[n]));
    }
    // The corrected form has the rounding of f - sigma_N at 1, an epsilon of e, in its x^(N+1): N+1 times that in the
    // slope.
    const T end = f.series[0] * 3;
    for (int i = 0; i <= 8; ++i) {
        INFO("m = " << m << ", x = " << i << "/8");
        const T x = T(i) / 8;
        const jet<T> a = factored(x);
        const jet<T> b = evaluate(corrected, x);
        CHECK_THAT(a.value, near<T>(b.value, 1, end));
        CHECK_THAT(a.slope, near<T>(b.slope, 1, T(end * (order + 1))));
    }
}

TEMPLATE_LIST_TEST_CASE("value and slope are those of the polynomial, exactly", "[approximant][endpoint]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const int m = GENERATE(0, 1, 2, 3);
    // Degree 4 + 3 in eighths: at most 2^5 of the coefficients times 2^(3 7) of the powers.
    const auto f = reciprocal<T>(4, m);
    const endpoint_approximant<T> factored(f.series, f.endpoint);
    const auto p = endpoint_corrected(f.series, f.endpoint);
    for (int i = 0; i <= 8; ++i) {
        const jet<T> expected = evaluate(p, T(T(i) / 8));
        const jet<T> actual = factored(T(T(i) / 8));
        CHECK(actual.value == expected.value);
        CHECK(actual.slope == expected.slope);
    }
}

TEMPLATE_LIST_TEST_CASE("next to the end the factored form has the end's digits", "[approximant][endpoint]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    const auto f = exponential_function<T>(order, 2);
    const jet<T> end = endpoint_approximant<T>(f.series, f.endpoint)(T(1));
    CHECK(end.value == f.endpoint[0]);
    CHECK(end.slope == f.endpoint[1]);
}

TEMPLATE_LIST_TEST_CASE("a polynomial of degree N+m is its own approximant", "[approximant][endpoint]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    const int m = GENERATE(1, 2, 3, 5);
    const auto polynomial = random.of_order<T>(6 + m, 2);
    std::vector<T> endpoint(static_cast<std::size_t>(m));
    for (int j = 0; j < m; ++j) {
        endpoint[static_cast<std::size_t>(j)] = taylor_at_one(polynomial, j);
    }
    CHECK(endpoint_corrected(polynomial.truncated(6), endpoint).coefficients() == polynomial.coefficients());
    const endpoint_approximant<T> factored(polynomial.truncated(6), endpoint);
    for (int quarters = 0; quarters <= 4; ++quarters) {
        const T x = T(quarters) / 4;
        CHECK(factored(x).value == evaluate(polynomial, x).value);
        CHECK(factored(x).slope == evaluate(polynomial, x).slope);
    }
}

TEMPLATE_LIST_TEST_CASE("two derivatives at the end give the paper's alpha and beta, corrected",
                        "[approximant][endpoint]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    tests::random_series random;
    const int N = 5;
    // theta = sum a_n t^n on [0, T*] with T* = 2, theta(T*) = 7, omega(T*) = -3; the paper's time is not scaled.
    const auto a = random.of_order<T>(N, 1);
    const T end(2);
    const T theta_star(7);
    const T omega_star(-3);
    const jet<T> sigma = evaluate(a, end);
    // [paper (efficient)], with sigma_N - theta* where it prints sigma_N, which is right below E = 2 alone.
    const T defect = sigma.value - theta_star;
    const T alpha = -(N + 2) * defect / 64 - (omega_star - sigma.slope) / 32;  // T*^(N+1) = 64, T*^N = 32
    const T beta = (N + 1) * defect / 128 + (omega_star - sigma.slope) / 64;
    // In x = t/T*: coefficients times T*^n, slope times T*.
    const auto p = endpoint_corrected(rescale(a, end), {theta_star, T(omega_star * end)});
    CHECK(p[N + 1] == alpha * 64);
    CHECK(p[N + 2] == beta * 128);
}

TEMPLATE_LIST_TEST_CASE("endpoint data are expanded in powers of x", "[approximant][endpoint]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 5 - 2 (x-1) + 3 (x-1)^2 + (x-1)^3 = 9 - 5 x + 0 x^2 + x^3.
    CHECK(expand_at_zero(std::vector<T>{T(5), T(-2), T(3), T(1)}) == std::vector<T>{T(9), T(-5), T(0), T(1)});
    CHECK(expand_at_zero(std::vector<T>()).empty());
    // What is left of a series of lower order than the polynomial.
    const power_series<T> constant(std::vector<T>{T(4)});
    CHECK(endpoint_remainder(constant, std::vector<T>{T(5), T(-2)})[0] == -3);
}

TEST_CASE("the value alone has the bits of the jet's", "[approximant][endpoint]") {
    const power_series<double> series(std::vector<double>{1, -0.3, 0.7, 0.01, -0.2});
    for (const std::vector<double>& endpoint : {std::vector<double>{}, {0.4}, {0.4, -1.1}, {0.4, -1.1, 0.3}}) {
        const endpoint_approximant<double> approximant(series, endpoint);
        for (const double x : {0.0, 0.3, 0.999, 1.0}) {
            CHECK(approximant.value(x) == approximant(x).value);
        }
    }
}

}  // namespace approximant_endpoint_approximant_test
