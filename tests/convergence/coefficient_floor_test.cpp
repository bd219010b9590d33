// The floor of noise of a list: found at its level and place, on both kinds of circles, and not where there is none.
#include "libration/convergence/coefficient_floor.hpp"

#include <catch2/catch.hpp>

#include "../studies/population/radius_families.hpp"

namespace convergence_coefficient_floor_test {

using namespace libration;
using namespace libration::tests;

namespace {

// a_n + size rate^n times a number between -1 and 1.
power_series<mpfr> with_error(power_series<mpfr> a, const mpfr& size, const mpfr& rate) {
    dice random(7);
    mpfr now = size;
    for (int n = 0; n <= a.order(); ++n, now *= rate) {
        a[n] += now * random.thousandths(-1000, 1000);
    }
    return a;
}

}  // namespace

TEST_CASE("a floor is found with its level and where it begins", "[convergence][coefficient_floor]") {
    const precision_scope scope(50);
    const auto clean = population::power_at(mpfr(2), mpfr(mpfr(3) / 2), 120);
    CHECK_FALSE(floor_of(clean));
    const auto floor = floor_of(with_error(clean, mpfr("1e-16"), mpfr(1)));
    REQUIRE(floor);
    CHECK(floor->rate == 1);
    CHECK(floor->level > mpfr("2e-17"));
    CHECK(floor->level < mpfr("4e-16"));
    // |a_n| is 1e-16 at n = 41, and 16 times less at 45.
    CHECK(floor->first >= 36);
    CHECK(floor->first <= 46);
    const auto kept = above_floor(with_error(clean, mpfr("1e-16"), mpfr(1)), *floor, 256);
    CHECK(kept.order() < floor->first);
    CHECK(abs(kept[kept.order()]) >= floor->level * 256);
}

TEST_CASE("a floor on a circle of another radius is found with its rate", "[convergence][coefficient_floor]") {
    const precision_scope scope(50);
    const auto clean = population::power_at(mpfr(4), mpfr(mpfr(-1) / 2), 160);
    const auto floor = floor_of(with_error(clean, mpfr("1e-14"), mpfr(mpfr(2) / 3)));
    REQUIRE(floor);
    CHECK(abs(floor->rate - mpfr(2) / 3) < mpfr(1) / 50);
}

TEST_CASE("what symmetry leaves of noise alone becomes 0 above the floor", "[convergence][coefficient_floor]") {
    const precision_scope scope(50);
    auto even = power_series<mpfr>::zero(120);
    const auto half = population::power_at(mpfr(3), mpfr(mpfr(1) / 2), 60);
    for (int k = 0; k <= 60; ++k) {
        even[2 * k] = half[k];
    }
    const auto noisy = with_error(even, mpfr("1e-15"), mpfr(1));
    const auto floor = floor_of(noisy);
    REQUIRE(floor);
    const auto kept = above_floor(noisy, *floor, 16);
    for (int n = 1; n <= kept.order(); n += 2) {
        CHECK(kept[n] == 0);
    }
    CHECK(kept[2] != 0);
}

TEST_CASE("weak far singularities, beats, random signs and entire functions are no floor",
          "[convergence][coefficient_floor]") {
    const precision_scope scope(50);
    const int n = 100;
    using namespace population;
    CHECK_FALSE(floor_of(mpfr("1e-9") * power_at(mpfr(3), mpfr(-1), n) + power_at(mpfr(1), mpfr(mpfr(1) / 2), n)));
    CHECK_FALSE(floor_of(mpfr("1e-9") * power_of_pair(mpfr(1), mpfr("0.3"), mpfr(mpfr(1) / 3), n) +
                         rescale(convergence::exponential_series<mpfr>(n), mpfr(2))));
    CHECK_FALSE(floor_of(convergence::exponential_series<mpfr>(n)));
    dice random(3);
    CHECK_FALSE(floor_of(random_signs(random, n).a));
    CHECK_FALSE(floor_of(power_series<mpfr>::zero(n)));
}

}  // namespace convergence_coefficient_floor_test
