// Rows as text and back.
#include "sweep/cell_text.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

namespace sweep_cell_text_test {

using namespace libration;

namespace {

// The expectation is typed here, not taken from what is tested.
cell_rows some_rows() {
    return {
        {{cell("a, \"quoted\"\nline"), cell(-12), cell::number("-1.50e-300", 3), cell()}, {cell("x:3:y")}}, {}, {{}}};
}

}  // namespace

TEST_CASE("rows come back from their text with kinds and digits", "[journal]") {
    const cell_rows back = rows_from(to_cell_text(some_rows()));
    REQUIRE(back.size() == 3);
    REQUIRE(back[0].size() == 2);
    REQUIRE(back[0][0].size() == 4);
    CHECK(back[0][0][0].kind() == cell_kind::text);
    CHECK(back[0][0][0].text() == "a, \"quoted\"\nline");
    CHECK(back[0][0][1].kind() == cell_kind::whole);
    CHECK(back[0][0][1].text() == "-12");
    CHECK(back[0][0][2].kind() == cell_kind::number);
    CHECK(back[0][0][2].text() == "-1.50e-300");
    CHECK(back[0][0][2].digits() == 3);
    CHECK(back[0][0][3].is_empty());
    CHECK(back[0][1].front().text() == "x:3:y");
    CHECK(back[1].empty());
    REQUIRE(back[2].size() == 1);
    CHECK(back[2].front().empty());
    CHECK(rows_from(to_cell_text({})).empty());
}

TEST_CASE("a text that is cut short, or longer, is refused", "[journal]") {
    const std::string whole = to_cell_text(some_rows());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CHECK_THROWS_AS(rows_from(whole.substr(0, size)), std::runtime_error);
    }
    CHECK_THROWS_AS(rows_from(whole + "0:"), std::runtime_error);
    CHECK_THROWS_AS(rows_from("99999999999999999999:"), std::runtime_error);
    CHECK_THROWS_AS(rows_from("1:1:1:7:1:x"), std::runtime_error);  // a kind of cell that there is not
    CHECK_THROWS_AS(rows_from("-1:"), std::runtime_error);
}

}  // namespace sweep_cell_text_test
