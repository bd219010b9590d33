#include "sweep/study.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace sweep_study_test {

using namespace libration;

TEST_CASE("an energy of a sweep keeps its text and derives the gap exactly", "[sweep][study]") {
    const sweep_energy e = energy_from(read_exact("1.710"));
    CHECK(e.energy == "1.710");
    CHECK(e.gap == "0.29");
    CHECK(e.value == rational(171, 100));
    CHECK(energy_from(read_exact("1/3")).gap == "5/3");
    CHECK(energy_from(read_exact("22/7")).gap == "-8/7");
    CHECK(energy_from(read_exact("2")).gap == "0");
    CHECK(energy_from(read_exact("0")).gap == "2");
}

TEST_CASE("a gap of 1e-30 is the energy 1.999...9 with thirty nines", "[sweep][study]") {
    const sweep_energy below = energy_from_gap(read_exact("1e-30"));
    CHECK(below.gap == "1e-30");
    CHECK(below.energy == "1." + std::string(30, '9'));
    CHECK(below.value == 2 - read_exact("1e-30").coefficient);
    const sweep_energy above = energy_from_gap(read_exact("-1e-30"));
    CHECK(above.gap == "-1e-30");
    CHECK(above.energy == "2." + std::string(29, '0') + "1");
    CHECK(read_exact(above.energy).coefficient == above.value);
    CHECK(energy_from_gap(read_exact("1/3")).energy == "5/3");
    CHECK(energy_from_gap(read_exact("2")).energy == "0");
}

TEST_CASE("what is no energy is refused", "[sweep][study]") {
    CHECK_THROWS_WITH(energy_from(read_exact("-1")), Catch::Contains("'-1'") && Catch::Contains("negative"));
    CHECK_THROWS_WITH(energy_from_gap(read_exact("2.0001")),
                      Catch::Contains("'2.0001'") && Catch::Contains("negative"));
    for (const std::string text : {"pi", "90deg", "T/4"}) {
        CHECK_THROWS_AS(energy_from(read_exact(text)), libration::error);
        CHECK_THROWS_AS(energy_from_gap(read_exact(text)), libration::error);
        CHECK_THROWS_WITH(energy_from(read_exact(text)), Catch::Contains("'" + text + "'"));
    }
}

}  // namespace sweep_study_test
