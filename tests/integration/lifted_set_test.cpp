// Sets of the given unknowns as sets of all unknowns of a polynomial form, and back: points of the first are in the
// second.
#include "libration/integration/lifted_set.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "libration/algebra/dense_matrix.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "proved.hpp"

namespace integration_lifted_set_test {

using namespace libration;
using namespace libration::ode;

namespace {

ball part(int numerator, int exponent) { return pow(ball(2), static_cast<long>(exponent)) * ball(numerator); }

// Two unknowns, with columns that are nearly dependent and of other sizes, and an added error as large as the widths.
state_set plane_set() {
    return {{part(3, -1), part(5, -2)},
            lohner_set({{part(1, 0), part(1, 0)}, {part(1, 0), part(1023, -10)}}, {1, 1},
                       {magnitude::of(1, -12), magnitude::of(3, -14)}, {magnitude::of(1, -12), magnitude::of(1, -13)})};
}

// Whether centre_i + sum_k C_ik e_k + a_i may be y, for |a_i| <= added_i.
bool may_contain(const state_set& set, std::size_t i, const std::vector<ball>& e, const ball& y) {
    ball sum = set.centre[i];
    for (std::size_t k = 0; k < e.size(); ++k) {
        sum += set.errors.columns()[k][i] * e[k];
    }
    return overlaps(widened(sum, set.errors.added()[i]), y);
}

struct point {
    std::vector<ball> e, y;
};

// The corners of a set of unknowns whose blocks are single columns.
std::vector<point> corners_of(const state_set& set) {
    const std::size_t columns = set.errors.columns().size();
    const std::size_t count = set.centre.size();
    std::vector<point> all;
    for (unsigned choice = 0; choice < 1U << (columns + count); ++choice) {
        const auto sign = [&](std::size_t bit) { return ball((choice >> bit & 1U) != 0 ? 1 : -1); };
        point corner{{}, set.centre};
        for (std::size_t k = 0; k < columns; ++k) {
            corner.e.push_back(set.errors.radii()[k].exact() * sign(k));
            for (std::size_t i = 0; i < count; ++i) {
                corner.y[i] += set.errors.columns()[k][i] * corner.e[k];
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            corner.y[i] += set.errors.added()[i].exact() * sign(columns + i);
        }
        all.push_back(std::move(corner));
    }
    return all;
}

}  // namespace

TEST_CASE("added unknowns of all points of a set are in the set of all unknowns, with the same errors",
          "[ode][proved]") {
    const precision_scope scope(60);
    // In the order in which they are added: exp(x), 1/y, sin(t) and cos(t).
    const auto form = lifted(explicit_system(parse("x' = exp(x)/y + sin(t); y' = exp(x)*cos(t); x(0) = 1; y(0) = 1")));
    const ball time = enclose(ball(1), part(1, -11));
    const auto all = lifted_set(form, time, plane_set());
    REQUIRE(all);
    REQUIRE(all->centre.size() == form.leaves.size());
    REQUIRE(form.leaves.size() > 3);
    for (const ball& at : {ball(1) - part(1, -11), ball(1), ball(1) + part(1, -11)}) {
        for (const point& corner : corners_of(plane_set())) {
            const auto values = lifted_values(form, at, corner.y);
            for (std::size_t i = 0; i < values.size(); ++i) {
                INFO("unknown " << i);
                CHECK(may_contain(*all, i, corner.e, values[i]));
            }
        }
    }
}

TEST_CASE("the set of the first unknowns contains theirs at all points of a set", "[ode][proved]") {
    const precision_scope scope(60);
    state_set space = plane_set();
    const lohner_set plane_errors = space.errors;
    ball_matrix space_columns = plane_errors.columns();
    space_columns[0].push_back(part(-7, 3));
    space_columns[1].push_back(part(1, -30));
    space_columns.push_back({part(1, -3), part(-1, -3), part(1, 0)});
    auto radii = plane_errors.radii();
    radii.push_back(magnitude::of(1, -12));
    auto added = plane_errors.added();
    added.push_back(magnitude::of(1, -5));
    space.centre.push_back(part(1, 0));
    space.errors = lohner_set(space_columns, {1, 1, 1}, radii, added);
    const auto plane = set_of_first(2, space);
    REQUIRE(plane);
    REQUIRE(plane->errors.columns().size() == 2);
    dense_matrix columns(2, 2);
    columns.set_column(0, plane->errors.columns()[0]);
    columns.set_column(1, plane->errors.columns()[1]);
    const auto back = inverse(columns);
    REQUIRE(back);
    for (const point& corner : corners_of(space)) {
        const auto e =
            product(*back, std::vector<ball>{corner.y[0] - plane->centre[0], corner.y[1] - plane->centre[1]});
        for (std::size_t k = 0; k < 2; ++k) {
            // One of the corners is on the edge, which rounding may pass.
            CHECK(certainly_less(abs(e[k]), plane->errors.radii()[k].exact() * (ball(1) + part(1, -25))));
        }
    }
}

}  // namespace integration_lifted_set_test
