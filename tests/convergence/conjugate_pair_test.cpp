#include "libration/convergence/conjugate_pair.hpp"

#include <catch2/catch.hpp>

#include "convergence/singular_series.hpp"
#include "scalars.hpp"

namespace convergence_conjugate_pair_test {

using namespace libration;
using namespace libration::convergence;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("a quadratic of a pair has its roots", "[convergence][conjugate_pair]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    // 1 - w + w^2/2 = (w^2 - 2 w + 2)/2: 1 +- i.
    const auto w = pair_quadratic<T>{T(1), T(T(1) / 2)}.nearest_root();
    CHECK(w.re == 1);
    CHECK(w.im == 1);
    // 1 - w/2 - w^2/2: 1 and -2.
    const auto real = pair_quadratic<T>{T(T(1) / 2), T(T(-1) / 2)}.nearest_root();
    CHECK(real.re == 1);
    CHECK(real.im == 0);
    CHECK_FALSE((pair_quadratic<T>{T(T(1) / 2), T(T(-1) / 2)}.conjugate(100)));
    CHECK((pair_quadratic<T>{T(1), T(T(1) / 2)}.conjugate(12)));
}

}  // namespace convergence_conjugate_pair_test
