// Coverings: every point of the half plane is in a cell, cells are in their discs, and what must not close does not.
#include "libration/plane/charted_covering.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "libration/equation/text/parse.hpp"
#include "libration/scalar/error.hpp"

namespace plane_charted_covering_test {

using namespace libration;
using namespace libration::ode;

namespace {

constexpr double half_turn = std::numbers::pi;

explicit_system typed(const std::string& text) { return explicit_system(parse(text)); }

double area_of(const charted_covering& covering) {
    double sum = 0;
    for (const covered_cell& each : covering.cells()) {
        sum += (each.cell.r2 * each.cell.r2 - each.cell.r1 * each.cell.r1) * (each.cell.a2 - each.cell.a1) / 2;
    }
    return sum;
}

}  // namespace

TEST_CASE("the cells are the half plane without the inner disc, each in a disc that starts below it",
          "[plane][proved]") {
    const precision_scope scope(40);
    for (const std::string text : {"y' = 1 + y^2; y(0) = 1/3", "y'' = 6*y^2 + t; y(0) = 1; y'(0) = 0"}) {
        const explicit_system system = typed(text);
        const chart_atlas atlas(system, 1.6);
        constexpr double rho = 2.5;
        const charted_covering covering(system, atlas, {.rho = rho});
        double inner = rho;
        for (const covered_cell& each : covering.cells()) {
            inner = std::min(inner, each.cell.r1);
            const covering_piece& in = covering.pieces()[each.holder];
            CHECK(in.base < each.cell.r1);
            for (int k = 0; k <= 8; ++k) {
                const double angle = each.cell.a1 + (each.cell.a2 - each.cell.a1) * k / 8;
                CHECK(std::abs(std::polar(each.cell.r2, angle) - in.centre) < in.radius);
                CHECK(std::abs(std::polar(each.cell.r1, angle) - in.centre) < in.radius);
            }
        }
        CHECK(inner < covering.pieces().front().radius);
        CHECK(area_of(covering) == Approx((rho * rho - inner * inner) * half_turn / 2));
        for (const covering_piece& each : covering.pieces()) {
            CHECK(each.base >= std::abs(each.centre));
        }
    }
}

TEST_CASE("a singularity without a chart or a tip is found by its place", "[plane][proved]") {
    const precision_scope scope(40);
    const explicit_system system = typed("y' = y^3; y(0) = 1");  // (1 - 2t)^(-1/2)
    const chart_atlas atlas(system, 1.6);
    CHECK_NOTHROW(charted_covering(system, atlas, {.rho = 0.49}));
    try {
        charted_covering(system, atlas, {.rho = 0.55});
        FAIL("the covering closed");
    } catch (const error& problem) {
        CHECK(problem.kind() == error_kind::undecided);
        CHECK(problem.reason().find("0.5") != std::string::npos);
    }
    // With a tip it does.
    CHECK_NOTHROW(charted_covering(system, atlas, {.rho = 0.55, .tips = {{0.5, 0.12, 0.45}}}));
    // The tip begins only at its base.
    CHECK_THROWS_AS(charted_covering(system, atlas, {.rho = 0.55, .tips = {{0.5, 0.12, 0.5000001}}}), error);
}

TEST_CASE("tips are used in the gaps at their slits, less than a half turn away", "[plane][proved]") {
    const auto alone = upper_sectors({{1.0, 0.5, 0.9}});
    REQUIRE(alone.size() == 2);
    CHECK(alone[0].tips == std::vector<std::size_t>{0});
    CHECK(alone[1].tips.empty());  // a half turn away at its end
    const auto pair = upper_sectors({{std::polar(1.0, 0.5), 0.5, 0.9}, {std::polar(1.2, 1.0), 0.5, 0.9}});
    for (const plane_sector& each : pair) {
        CHECK(each.to - each.from <= 2);
        for (const std::size_t tip : each.tips) {
            // Not beyond the slit of the other one.
            CHECK(tip == (each.to <= 0.5 + 1e-12 ? 0U : each.from >= 1.0 - 1e-12 ? 1U : tip));
        }
    }
    CHECK_THROWS_AS(upper_sectors({{std::polar(1.0, 0.5), 0.5, 0.9}, {std::polar(1.2, 0.5), 0.5, 0.9}}), error);
    // A point that is not on the real axis, and whose mirror image is as close to it.
    CHECK_THROWS_AS(upper_sectors({{{1.0, 1e-12}, 0.5, 0.9}}), error);
}

}  // namespace plane_charted_covering_test
