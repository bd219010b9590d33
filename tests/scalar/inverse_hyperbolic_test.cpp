#include "libration/scalar/inverse_hyperbolic.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace scalar_inverse_hyperbolic_test {

using namespace libration;
using libration::tests::all_scalars;
using libration::tests::near;

// Half an epsilon for the function here, and for the reference; libquadmath guarantees 2.
constexpr long few = 3;

TEMPLATE_LIST_TEST_CASE("arsinh undoes sinh", "[scalar][inverse_hyperbolic]", all_scalars) {
    using T = typename TestType::type;
    using std::sinh;
    const typename TestType::precision precision;
    for (const auto* text : {"1e-30", "1e-8", "0.1", "-0.75", "2", "-40", "200"}) {
        INFO(text);
        const T x = from_exact<T>(read_exact(text));
        // The error of sinh x is multiplied by tanh(x)/x: at most once.
        CHECK_THAT(arsinh(T(sinh(x))), near<T>(x, few));
    }
}

TEMPLATE_LIST_TEST_CASE("arsinh has its closed forms and is odd", "[scalar][inverse_hyperbolic]", all_scalars) {
    using T = typename TestType::type;
    using std::log;
    const typename TestType::precision precision;
    CHECK(arsinh(T(0)) == 0);
    CHECK_THAT(arsinh(T(T(3) / 4)), near<T>(T(log(T(2))), few));   // 3/4 + 5/4 = 2
    CHECK_THAT(arsinh(T(T(12) / 5)), near<T>(T(log(T(5))), few));  // 12/5 + 13/5 = 5
    CHECK(arsinh(T(-3)) == -arsinh(T(3)));
    // Far out log(2x), also where x^2 leaves the range of double.
    const T huge = from_exact<T>(read_exact("1e200"));
    CHECK_THAT(arsinh(huge), near<T>(T(log(huge * 2)), few));
}

}  // namespace scalar_inverse_hyperbolic_test
