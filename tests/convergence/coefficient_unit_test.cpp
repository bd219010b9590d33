#include "libration/convergence/coefficient_unit.hpp"

#include <catch2/catch.hpp>

#include "scalars.hpp"

namespace convergence_coefficient_unit_test {

using namespace libration;
using namespace libration::series;
using namespace libration::convergence;
using namespace libration::tests;

namespace {

// f(n), n = 0 .. order.
template <class F>
power_series<mpfr> list_of(int order, const F& f) {
    std::vector<mpfr> values;
    values.reserve(static_cast<std::size_t>(order) + 1);
    for (int n = 0; n <= order; ++n) {
        values.push_back(f(n));
    }
    return power_series<mpfr>(std::move(values));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the unit of a geometric list is its radius, whatever its size",
                        "[convergence][coefficient_unit]", all_scalars) {
    using T = typename TestType::type;
    [[maybe_unused]] const typename TestType::precision precision;
    const precision_scope scope(120);
    for (const std::string radius : {"1", "2.90669962925582", "1e-30", "1e500", "1e5000"}) {
        for (const std::string size : {"1", "1e-5000", "-1e5000"}) {
            INFO(radius << " " << size);
            const auto list = list_of(300, [&](int n) { return mpfr(mpfr(size) / pow(mpfr(radius), n)); });
            const coefficient_unit unit = unit_of(list);
            // Twelve bits of the length.
            CHECK(abs(unit.length / mpfr(radius) - 1) <= ldexp(mpfr(1), -12));
            [[maybe_unused]] const typename TestType::precision again;
            const power_series<T> scaled = in_unit_of<T>(list, unit);
            REQUIRE(scaled.order() == 300);
            for (int n = 0; n <= 300; n += 50) {
                // (1 + 2^-12)^300 < 1.08, and half a power of two on either side.
                CHECK(abs(widen(scaled[n])) < 2);
                CHECK(abs(widen(scaled[n])) > mpfr("0.5") / 2);
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("a list in its unit is rounded once", "[convergence][coefficient_unit]", all_scalars) {
    using T = typename TestType::type;
    const precision_scope scope(160);
    const auto list = list_of(200, [](int n) { return mpfr(pow(mpfr(3), -n) / (n + 1)); });
    [[maybe_unused]] const typename TestType::precision precision;
    const coefficient_unit unit = unit_of(list);
    const power_series<T> scaled = in_unit_of<T>(list, unit);
    const mpfr rounding = widen(epsilon<T>());
    const precision_scope wide(160);
    const mpfr ratio = widen(unit.length) / 3;
    for (const int n : {0, 1, 100, 200}) {
        const mpfr exactly_scaled = ldexp(mpfr(pow(ratio, n) / (n + 1)), static_cast<int>(-unit.exponent));
        // Half an epsilon, and 20 digits less of the powers.
        CHECK(abs(widen(scaled[n]) - exactly_scaled) <= abs(exactly_scaled) * rounding * 51 / 100);
    }
}

TEST_CASE("lists without a radius have a unit too", "[convergence][coefficient_unit]") {
    const precision_scope scope(60);
    CHECK(unit_of(power_series<mpfr>::zero(50)).length == 1);
    CHECK(unit_of(list_of(50, [](int n) { return mpfr(n == 0 ? 7 : 0); })).length == 1);
    CHECK(unit_of(list_of(50, [](int n) { return mpfr(n < 4 ? 1 : 0); })).length == 1);
    CHECK(unit_of(list_of(250, [](int n) { return mpfr((n & (n - 1)) == 0 ? 1 : 0); })).length == 1);
    // 1/n! falls like (N/2 .. N)^-1, n! grows so.
    const mpfr entire = unit_of(list_of(100, [](int n) { return mpfr(1 / tgamma(mpfr(n + 1))); })).length;
    CHECK(entire > 50);
    CHECK(entire < 100);
    const mpfr divergent = unit_of(list_of(100, [](int n) { return mpfr(tgamma(mpfr(n + 1))); })).length;
    CHECK(divergent * 50 < 1);
    CHECK(divergent * 100 > 1);
}

TEST_CASE("the roundings that stand for 0 do not count in the unit", "[convergence][coefficient_unit]") {
    const precision_scope scope(40);
    const auto list =
        list_of(120, [](int n) { return mpfr(ldexp(mpfr(1), -n) * (n % 2 == 0 ? mpfr(1) : mpfr("1e-17"))); });
    CHECK(abs(unit_of(list).length - 2) <= ldexp(mpfr(1), -10));
}

TEST_CASE("what a scalar cannot hold in the unit of its list is refused", "[convergence][coefficient_unit]") {
    const precision_scope scope(60);
    const auto exponential = list_of(1200, [](int n) { return mpfr(1 / tgamma(mpfr(n + 1))); });
    CHECK_THROWS_AS(in_unit_of<double>(exponential, unit_of(exponential)), libration::error);
    CHECK_NOTHROW(in_unit_of<long double>(exponential, unit_of(exponential)));
    const auto tall = list_of(60, [](int n) { return mpfr(n == 0 ? mpfr("1e400") : mpfr(1)); });
    CHECK_THROWS_AS(in_unit_of<double>(tall, unit_of(tall)), libration::error);
}

}  // namespace convergence_coefficient_unit_test
