#include "libration/problem/known/pendulum.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace problem_known_pendulum_test {

using namespace libration;
using namespace libration::pendulum;

TEST_CASE("an energy of a sweep keeps its text and derives the gap exactly", "[problem]") {
    const sweep_energy e = energy_from(read_exact("1.710"));
    CHECK(e.energy == "1.710");
    CHECK(e.gap == "0.29");
    CHECK(e.value.coefficient == rational(171, 100));
    CHECK(e.energy_typed == "1.710");
    CHECK(e.gap_typed.empty());
    CHECK(energy_from(read_exact("2")).gap == "0");
    CHECK(energy_from(read_exact("0")).gap == "2");
}

TEST_CASE("a gap of 1e-30 is the energy 1.999...9 with thirty nines", "[problem]") {
    const sweep_energy below = energy_from_gap(read_exact("1e-30"));
    CHECK(below.gap == "1e-30");
    CHECK(below.energy == "1." + std::string(30, '9'));
    CHECK(below.value.coefficient == 2 - read_exact("1e-30").coefficient);
    const sweep_energy above = energy_from_gap(read_exact("-1e-30"));
    CHECK(above.gap == "-1e-30");
    CHECK(above.energy == "2." + std::string(29, '0') + "1");
    CHECK(read_exact(above.energy).coefficient == above.value.coefficient);
    CHECK(energy_from_gap(read_exact("2")).energy == "0");
}

TEST_CASE("a fraction stands as a decimal, exact where it ends, and as it was typed beside it", "[problem]") {
    const sweep_energy finite = energy_from(read_exact("171/100"));
    CHECK(finite.energy == "1.71");
    CHECK(finite.energy_typed == "171/100");
    const sweep_energy endless = energy_from(read_exact("1/3"));
    CHECK(endless.energy == "0." + std::string(50, '3'));
    CHECK(endless.gap == "1." + std::string(48, '6') + "7");
    CHECK(endless.value.coefficient == rational(1, 3));
    const sweep_energy by_gap = energy_from_gap(read_exact("1/3"));
    CHECK(by_gap.gap_typed == "1/3");
    CHECK(by_gap.energy_typed.empty());
    CHECK(decimal_of(read_exact("1e-3"), 50) == "1e-3");
    CHECK(decimal_of(read_exact("+2.50"), 50) == "2.5");
    CHECK(decimal_of(read_exact("180deg"), 10) == "3.141592654");
}

TEST_CASE("the axes of energy and gap are one coordinate", "[problem]") {
    const problem_family& pendulum = pendulum_problem();
    REQUIRE(pendulum.axes.size() == 6);
    CHECK(pendulum.axes[0].name == "energy");
    CHECK(pendulum.axes[1].name == "gap");
    CHECK(pendulum.axes[1].coordinate == "energy");
    CHECK(pendulum.axes[1].coordinate_of(read_exact("0.29")).coefficient == rational(171, 100));
    CHECK(pendulum.axes[0].coordinate_of(read_exact("1.71")).coefficient == rational(171, 100));
}

TEST_CASE("a sweep holds the energies of both axes by size", "[problem]") {
    axis_values values;
    values.set("energy", {read_exact("2.02"), read_exact("0.5")});
    values.set("gap", {read_exact("1")});
    values.set("periods", {read_exact("1e9")});
    const pendulum_sweep sweep(values);
    REQUIRE(sweep.energies.size() == 3);
    CHECK(sweep.energies[0].energy == "0.5");
    CHECK(sweep.energies[1].gap == "1");
    CHECK(sweep.energies[2].value.coefficient == rational(101, 50));
    CHECK(sweep.periods == std::vector<integer>{1'000'000'000});
    CHECK(sweep.times.empty());
}

TEST_CASE("where a study has no answer is said with its reason", "[problem]") {
    const auto excluded = no_answer_at_limits("it rests", "the period is infinite");
    CHECK(reason_against(excluded, "energy", exactly(0)) == "it rests");
    CHECK(reason_against(excluded, "energy", exactly(2)) == "the period is infinite");
    CHECK(reason_against(excluded, "energy", exactly(rational(1999999, 1000000))).empty());
    CHECK(reason_against(excluded, "time", exactly(2)).empty());
    CHECK(reason_against(no_answer_at_limits("", "infinite"), "energy", exactly(0)).empty());
}

TEST_CASE("what is no energy is refused", "[problem]") {
    CHECK_THROWS_WITH(energy_from(read_exact("-1")), Catch::Contains("'-1'") && Catch::Contains("negative"));
    CHECK_THROWS_WITH(energy_from_gap(read_exact("2.0001")),
                      Catch::Contains("'2.0001'") && Catch::Contains("negative"));
    for (const std::string text : {"pi", "90deg", "T/4"}) {
        CHECK_THROWS_AS(energy_from(read_exact(text)), libration::error);
        CHECK_THROWS_AS(energy_from_gap(read_exact(text)), libration::error);
        CHECK_THROWS_WITH(energy_from(read_exact(text)), Catch::Contains("'" + text + "'"));
    }
}

}  // namespace problem_known_pendulum_test
