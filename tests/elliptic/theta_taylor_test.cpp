// The Taylor coefficients of the theta functions by identities among them and by the function itself at another point.
#include "libration/elliptic/theta_taylor.hpp"

#include <catch2/catch.hpp>
#include <tuple>
#include <vector>

#include "proved.hpp"
#include "scalars.hpp"

namespace elliptic_theta_taylor_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::tests;

namespace {

using long_scalars = std::tuple<scalar_tag<mpfr>>;

const std::vector<theta_kind> kinds{first_theta, second_theta, third_theta, fourth_theta};

template <class T>
T at(const theta_kind& kind, const theta_argument<T>& argument, int n = 0) {
    return theta_taylor<T>(kind, argument).coefficients(n % 2, 2, n / 2 + 1).back();
}

template <class T>
theta_argument<T> at_zero(const T& nome) {
    return {nome, T(0), T(1), false};
}

// The sum of the first 400 coefficients: the value at t = 1.
template <class T>
T value_at_one(const theta_kind& kind, const theta_argument<T>& argument) {
    T sum(0);
    for (const T& c : theta_taylor<T>(kind, argument).coefficients(0, 1, 400)) {
        sum += c;
    }
    return sum;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the theta functions at zero obey Jacobi's identities", "[theta_taylor]", long_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const T& nome : std::vector<T>{T(T(1) / 1000), T(exp(T(-pi<T>()))), T(T(3) / 10)}) {
        const auto zero = at_zero(nome);
        const T second = at(second_theta, zero);
        const T third = at(third_theta, zero);
        const T fourth = at(fourth_theta, zero);
        // theta_3^4 = theta_2^4 + theta_4^4 [DLMF 20.7.1] and theta_1' = theta_2 theta_3 theta_4 [DLMF 20.4.6]: a
        // rounding in each power and for each of the terms that count.
        CHECK_THAT(T(pow(second, 4) * nome + pow(fourth, 4)), near<T>(T(pow(third, 4)), 40));
        CHECK_THAT(at(first_theta, zero, 1), near<T>(T(second * third * fourth), 20));
    }
}

TEST_CASE("theta_3 at the nome of the square lattice has its closed form", "[theta_taylor][ball]") {
    const precision_scope scope(60);
    // pi^(1/4)/Gamma(3/4), because (pi/2) theta_3^2 = K(1/sqrt 2) = Gamma(1/4)^2/(4 sqrt pi) [DLMF 20.9.2]; a few
    // roundings for each of seven terms.
    const expected_value expected = decimal("1.08643481121330801457531612151022345707020570724521888592079");
    CHECK_THAT(at(third_theta, at_zero(ball(exp(-pi<ball>())))), encloses(expected, 40));
}

TEST_CASE("a theta function has one value, whatever point it is expanded about", "[theta_taylor][ball]") {
    const precision_scope scope(50);
    const ball nome = exp(-pi<ball>());
    for (const bool real : {false, true}) {
        for (int kind = 0; kind < 4; ++kind) {
            for (const int shift : {0, 1}) {
                if (!real && shift != 0) {
                    continue;
                }
                INFO("theta_" << kind + 1 << (real ? " of real x" : " of imaginary x") << ", shift " << shift);
                const ball half = ball(1) / 2;
                const auto& which = kinds[static_cast<std::size_t>(kind)];
                const ball there = at<ball>(which, {nome, half * 3, ball(1), real, shift});
                const ball through = value_at_one<ball>(which, {nome, half, ball(1), real, shift});
                // The last of 400 coefficients are below 20^400/400!, 1e-340.
                CHECK(overlaps(there, through));
                // A few roundings for each of 400 terms, which are below 100 here.
                CHECK(certainly_less(radius_of(through), epsilon<ball>() * 400'000));
            }
        }
    }
}

TEST_CASE("a shift divides by the exponential", "[theta_taylor][ball]") {
    const precision_scope scope(50);
    const ball nome = ball(1) / 50;
    const ball x = ball(7) / 3;
    for (const theta_kind& kind : kinds) {
        const ball plain = at<ball>(kind, {nome, x, ball(1), true, 0});
        CHECK(overlaps(at<ball>(kind, {nome, x, ball(1), true, 1}) * exp(x), plain));
    }
}

TEST_CASE("at the nome 0 only the first terms are left", "[theta_taylor][ball]") {
    const precision_scope scope(50);
    const theta_argument<ball> argument{ball(0), ball(2), ball(1), true};
    CHECK(overlaps(at(second_theta, argument), (exp(ball(2)) + exp(ball(-2)))));
    CHECK(overlaps(at(first_theta, argument), (exp(ball(2)) - exp(ball(-2)))));
    CHECK(is_exact(at(third_theta, argument)));
    CHECK(contains(at(fourth_theta, argument), ball(1)));
}

TEST_CASE("a nome that is not below 1 is refused", "[theta_taylor]") {
    const precision_scope scope(30);
    CHECK_THROWS_AS(theta_taylor<mpfr>(third_theta, at_zero(mpfr(1))), libration::error);
    CHECK_THROWS_AS(theta_taylor<ball>(third_theta, at_zero(ball(2))), libration::error);
}

}  // namespace elliptic_theta_taylor_test
