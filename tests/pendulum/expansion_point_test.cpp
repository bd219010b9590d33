#include "libration/pendulum/expansion_point.hpp"

#include <string>

#include "pendulum/typed.hpp"
#include "proved.hpp"
#include "scalars.hpp"

namespace pendulum_expansion_point_test {

using namespace libration;
using namespace libration::pendulum;
using namespace libration::tests;

TEMPLATE_LIST_TEST_CASE("a fraction of T* after the top is the phase of that time", "[expansion_point]", all_scalars) {
    using T = typename TestType::type;
    const typename TestType::precision precision;
    for (const motion& m : {with_energy("1e-3"), with_energy("1.71"), with_gap("1e-10"), with_gap("-1e-10", -1),
                            with_energy("2.02", -1), with_energy("4")}) {
        const exact_solution<T> solution(m);
        const T effective_period = pendulum::effective_period(energy_level_of<T>(m));
        for (int eighths = 0; eighths <= 8; ++eighths) {
            INFO("E = " << *m.energy() << ", direction " << m.direction() << ", x = " << eighths << "/8");
            const rational x(eighths, 8);
            const phase<T> found = phase_from_top<T>(m, x, effective_period);
            // A canonical motion starts at the top, and its phase map has T; halfway both ends are the nearest.
            const exact time{x / quarters_per_period(m.regime()), unit::period, ""};
            const phase<T> expected = solution.phases().at(time);
            if (eighths != 4) {
                CHECK(found.quarter == expected.quarter);
                CHECK(found.side == expected.side);
                // T* within 4 ulps (period_test), and a product.
                CHECK_THAT(found.offset, near<T>(expected.offset, 8));
            }
            const phase<T> same = phase_from_top<T>(m, T(T(eighths) / 8), effective_period);
            CHECK(same.quarter == found.quarter);
            CHECK(same.side == found.side);
            CHECK(same.offset == found.offset);
        }
    }
}

TEST_CASE("half way is counted from the top, the ends are exact", "[expansion_point]") {
    const precision_scope precision(30);
    for (const int direction : {1, -1}) {
        const motion m = with_energy("4", direction);
        const ball effective_period = pendulum::effective_period(energy_level_of<ball>(m));
        const integer top = direction;
        const auto at = [&](const rational& x) { return phase_from_top<ball>(m, x, effective_period); };
        CHECK(at(rational(1, 2)).quarter == top);
        CHECK(at(rational(1, 2)).side == 1);
        CHECK(overlaps(ball(at(rational(1, 2)).offset * 2), effective_period));
        for (const int end : {0, 1}) {
            CHECK(at(end).quarter == top + end);
            CHECK(at(end).side == 0);
            CHECK(is_exact(at(end).offset));
            CHECK(contains_zero(at(end).offset));
        }
    }
}

TEST_CASE("points are read by name, and the separatrix has no top", "[expansion_point]") {
    CHECK(read_expansion_point("top").where == expansion_point::place::top);
    CHECK(read_expansion_point("bottom").where == expansion_point::place::bottom);
    CHECK(read_expansion_point("start").where == expansion_point::place::start);
    CHECK(read_expansion_point("T/8").time.coefficient == rational(1, 8));
    CHECK_THROWS_AS(read_expansion_point("30deg"), libration::error);
    CHECK_THROWS_AS(phase_of<double>(read_expansion_point("top"), with_energy("2")), libration::error);
}

}  // namespace pendulum_expansion_point_test
