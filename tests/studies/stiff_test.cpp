// The study of stiff problems: digits, steps and seconds at times that double.
#include <catch2/catch.hpp>
#include <string>

#include "studies/study_rows.hpp"

namespace studies_stiff_test {

using namespace libration;
using namespace libration::tests;

// D4 changes within 1 and 1e-4 units of time: more and more explicit steps are replaced.
TEST_CASE("a stiff problem keeps its digits while steps become longer than explicit ones", "[studies][proved]") {
    const auto tables = rows_by_suffix("stiff", {{"--problems", "stiff_d4"}, {"--scalar", "ball:15"}});
    const auto& rows = tables.at("");
    REQUIRE(rows.size() == 12);
    CHECK(rows.back().at("time") == "50");
    double before = 0;
    for (const table_row& row : rows) {
        CHECK(std::stod(row.at("digits")) > 15);
        const double steps = std::stod(row.at("steps"));
        CHECK(steps >= before);
        before = steps;
        CHECK(std::stod(row.at("log10_explicit_steps")) >= std::stod(row.at("log10_ratio")));
    }
    CHECK(std::stod(rows.back().at("log10_ratio")) > 1);
    CHECK(tables.at("time").size() == 12);
}

}  // namespace studies_stiff_test
