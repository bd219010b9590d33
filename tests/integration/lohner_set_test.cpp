// Sets of errors: what a map makes of their points lies in the moved set.
#include "libration/integration/lohner_set.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "corner_numbers.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace integration_lohner_set_test {

using namespace libration;
using namespace libration::ode;

namespace {

// Small exact numbers.
// Up to 2 in size; half of them corner cases, 1 in place of 0, for a map of rank 0 has no frame.
ball some(tests::corner_numbers& random) {
    const ball x = random.half([&] { return random.exact(random.length(200), 1); },
                               [&] { return ball(random.between(-1000, 1000)) / 512; });
    return contains_zero(x) ? ball(1) : x;
}

// Whether the set is moved in so few digits: maps whose rows are nearly parallel are refused then.
bool moves(lohner_set& set, const ball_matrix& map, const std::vector<magnitude>& added, long digits) {
    const precision_scope few(digits);
    try {
        set = set.moved(map, added);
        return true;
    } catch (const precision_exhausted&) {
        return false;
    }
}

// Q^-1 of two columns by the cofactors.
std::vector<ball> coordinates(const ball_matrix& q, const std::vector<ball>& x) {
    const ball determinant = q[0][0] * q[1][1] - q[1][0] * q[0][1];
    return {(q[1][1] * x[0] - q[1][0] * x[1]) / determinant, (q[0][0] * x[1] - q[0][1] * x[0]) / determinant};
}

bool holds(const lohner_set& set, const std::vector<ball>& x) {
    const auto inside = coordinates(set.columns(), x);
    return !certainly_less(set.radii()[0].exact(), abs(inside[0])) &&
           !certainly_less(set.radii()[1].exact(), abs(inside[1]));
}

}  // namespace

// Corners of the box are carried along exactly while the set is moved in 64 bits, through maps that stretch, turn,
// press flat and mirror; and in 20 bits, where frames are less orthogonal.
TEST_CASE("a moved frame holds the images of the corners", "[ode][proved]") {
    const long digits = GENERATE(6, 20);
    tests::corner_numbers random(20'261'123);
    int undecided = 0;
    for (int run = 0; run < 200; ++run) {
        const precision_scope exactly(400);
        lohner_set set({magnitude::of(1 + random.below(1000), -60), magnitude::of(1 + random.below(1000), -50)});
        std::vector<std::vector<ball>> corners;
        for (const int a : {-1, 1}) {
            for (const int b : {-1, 1}) {
                corners.push_back({set.radii()[0].exact() * a, set.radii()[1].exact() * b});
            }
        }
        for (int step = 0; step < 12; ++step) {
            const bool flat = random.below(3) == 0;
            const ball p = some(random);
            const ball q = some(random);
            const ball factor = some(random);
            const ball_matrix map = {{p, q}, {flat ? p * factor : some(random), flat ? q * factor : some(random)}};
            const std::vector<magnitude> added = {magnitude::of(random.below(100), -58),
                                                  magnitude::of(random.below(100), -58)};
            if (!moves(set, map, added, digits)) {
                ++undecided;
                break;
            }
            for (auto& x : corners) {
                const ball first = map[0][0] * x[0] + map[0][1] * x[1];
                const ball second = map[1][0] * x[0] + map[1][1] * x[1];
                x = {first + added[0].exact() * (random.below(2) == 0 ? 1 : -1),
                     second + added[1].exact() * (random.below(2) == 0 ? 1 : -1)};
                CAPTURE(run, step);
                CHECK(holds(set, x));
                CHECK(!certainly_less(set.reach(0).exact(), abs(x[0])));
            }
        }
    }
    CHECK(undecided < 50);
}

// The same in scales that differ by 2^3000, of maps of the unknowns in units of their own.
TEST_CASE("a moved frame holds the images of the corners in any scales", "[ode][proved]") {
    tests::corner_numbers random(20'261'125);
    for (int run = 0; run < 100; ++run) {
        const precision_scope exactly(2000);
        std::vector<long> scales = {random.between(-1500, 1500), random.between(-1500, 1500)};
        const auto in_scales = [&](std::size_t i) { return magnitude::of(1 + random.below(1000), scales[i] - 50); };
        lohner_set set({in_scales(0), in_scales(1)});
        std::vector<std::vector<ball>> corners;
        for (const int a : {-1, 1}) {
            for (const int b : {-1, 1}) {
                corners.push_back({set.radii()[0].exact() * a, set.radii()[1].exact() * b});
            }
        }
        for (int step = 0; step < 8; ++step) {
            const std::vector<long> before = scales;
            for (long& each : scales) {
                each += random.between(-100, 100);
            }
            ball_matrix map(2);
            for (std::size_t i = 0; i < 2; ++i) {
                for (std::size_t j = 0; j < 2; ++j) {
                    map[i].push_back(ldexp(some(random), scales[i] - before[j]));
                }
            }
            const std::vector<magnitude> added = {in_scales(0), in_scales(1)};
            {
                const precision_scope few(20);
                set = set.image(map, added).settled(scales);
            }
            for (auto& x : corners) {
                const ball first = map[0][0] * x[0] + map[0][1] * x[1];
                const ball second = map[1][0] * x[0] + map[1][1] * x[1];
                x = {first + added[0].exact(), second - added[1].exact()};
                CAPTURE(run, step);
                CHECK(holds(set, x));
                CHECK(!certainly_less(set.reach(0).exact(), abs(x[0])));
                CHECK(!certainly_less(set.reach(1).exact(), abs(x[1])));
                // Each coordinate as narrow as its own corners, up to the turns of the frame.
                CHECK(set.reach(0) <= magnitude::of(1, scales[0] + 5 * (step + 1)));
                CHECK(set.reach(1) <= magnitude::of(1, scales[1] + 5 * (step + 1)));
            }
        }
    }
}

TEST_CASE("a coordinate that is 0 remains 0, and one that is not does not", "[ode][proved]") {
    const precision_scope few(20);
    const magnitude some_width = magnitude::of(3, -40);
    lohner_set set({some_width, magnitude(), some_width});
    // The second coordinate depends on itself alone, and the others on it.
    const ball_matrix map = {
        {ball(1) / 3, ball(5), ball(2)}, {ball(0), ball(7) / 3, ball(0)}, {ball(-1), ball(1), ball(1)}};
    for (int step = 0; step < 20; ++step) {
        set = set.moved(map, {some_width, magnitude(), some_width});
        CHECK(set.reach(1).is_zero());
        CHECK_FALSE(set.reach(0).is_zero());
    }
    CHECK_FALSE(set.moved(map, {some_width, some_width, some_width}).reach(1).is_zero());
    const ball_matrix mixed = {{ball(1), ball(0), ball(0)}, {ball(1), ball(1), ball(0)}, {ball(0), ball(0), ball(1)}};
    const lohner_set stirred = set.moved(mixed, {magnitude(), magnitude(), magnitude()});
    CHECK(set.reach(0) <= stirred.reach(1) * magnitude(2U));
}

// A rotation, 64 times round in all: boxes along the axes would grow by (1 + sqrt 2)/.. in each step, as e^(0.5 n).
TEST_CASE("a turning set does not grow", "[ode][proved]") {
    const precision_scope few(20);
    const ball angle = ball(2) / 5;
    const ball_matrix turn = {{cos(angle), -sin(angle)}, {sin(angle), cos(angle)}};
    lohner_set set({magnitude::of(1, -40), magnitude::of(1, -60)});
    for (int step = 0; step < 1000; ++step) {
        set = set.moved(turn, {magnitude(), magnitude()});
    }
    CHECK(set.reach(0) <= magnitude::of(3, -41));
    CHECK(set.reach(1) <= magnitude::of(3, -41));
}

TEST_CASE("a point stays a point", "[ode][proved]") {
    const precision_scope few(20);
    lohner_set set({magnitude(), magnitude()});
    set = set.moved({{ball(3), ball(1)}, {ball(1), ball(3)}}, {magnitude(), magnitude()});
    CHECK(set.reach(0).is_zero());
    CHECK(set.reach(1).is_zero());
}

}  // namespace integration_lohner_set_test
