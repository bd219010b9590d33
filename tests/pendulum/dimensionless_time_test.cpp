#include "libration/pendulum/dimensionless_time.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "pendulum/typed.hpp"
#include "scalars.hpp"

namespace pendulum_dimensionless_time_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("times are numbers, and multiples of T are multiples of the period", "[dimensionless_time]",
                        all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    CHECK(dimensionless_time<T>(with_energy("1.71"), read_exact("3/4")) == from_rational<T>(rational(3, 4)));
    for (const std::string energy : {"1.71", "2.02"}) {
        const motion m = with_energy(energy);
        for (const table_row& row : reference_table("motions.csv")) {
            if (row.at("energy") == energy && row.at("gap").empty()) {
                CHECK_THAT(dimensionless_time<T>(m, read_exact("T")), near<T>(decimal(row.at("period")), 4));
                CHECK_THAT(
                    dimensionless_time<T>(m, read_exact("-T/2")),
                    near<T>(expected_value{-decimal(row.at("period")).value / 2, decimal(row.at("period")).uncertainty},
                            4));
            }
        }
        CHECK(elapsed_periods<T>(m, read_exact("3T/4")) == from_rational<T>(rational(3, 4)));
        const motion scaled = m.with_squared_frequency(rational(4));
        CHECK(dimensionless_time<T>(scaled, read_exact("3")) == T(6));  // sqrt(4) units of time per second
        CHECK(dimensionless_time<T>(scaled, read_exact("T")) == dimensionless_time<T>(m, read_exact("T")));
    }
    CHECK_THROWS_AS(dimensionless_time<T>(with_energy("2"), read_exact("T")), libration::error);
}

}  // namespace pendulum_dimensionless_time_test
