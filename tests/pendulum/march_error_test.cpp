#include "libration/pendulum/march_error.hpp"

#include <catch2/catch.hpp>

namespace pendulum_march_error_test {

using namespace libration;
using namespace libration::elliptic;
using namespace libration::pendulum;

TEST_CASE("the march on the separatrix misses by its truncation where the step is large", "[march_error]") {
    const precision_scope precision(40);
    // Fourth order: half the step, a sixteenth of the error, up to terms of relative size h.
    const auto coarse = separatrix_march_error<long double>(rational(1, 50), 500, 100);
    const auto fine = separatrix_march_error<long double>(rational(1, 100), 1000, 100);
    CHECK(coarse.time == 500 * widen(from_rational<long double>(rational(1, 50))));
    CHECK(abs(coarse.norm / fine.norm - 16) < 1);
    // Rounding is far below both: the two arithmetics agree.
    const auto rounded = separatrix_march_error<double>(rational(1, 50), 500, 100);
    CHECK(abs(rounded.norm / coarse.norm - 1) * 1000 < 1);
    // The norm is dominated by the growth e^t of neighbours: without it, at most e^10 less, at least a little.
    CHECK(fine.undone < fine.norm);
    CHECK(fine.undone * exp(mpfr(11)) > fine.norm);
}

TEST_CASE("a march has at least one step and not too many", "[march_error]") {
    CHECK(march_steps(rational(1, 100'000), 10) == 1'000'000);
    CHECK(march_steps(rational(3), 10) == 3);
    CHECK_THROWS_AS(march_steps(rational(100), 10), libration::error);
    CHECK_THROWS_AS(march_steps(rational(1, integer("1000000000000")), 10), libration::error);
}

}  // namespace pendulum_march_error_test
