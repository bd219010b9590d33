// Lists and ranges of whole numbers.
#include "run/whole_grid.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace run_whole_grid_test {

using namespace libration;
using Catch::Contains;

namespace {

std::vector<long> values_of(const std::string& text) {
    std::vector<long> values;
    for (const grid_item& item : read_whole_items(text, 100'000)) {
        for (const exact& value : item.values) {
            values.push_back(numerator(value.coefficient).convert_to<long>());
        }
    }
    return values;
}

}  // namespace

TEST_CASE("items know whether they are ranges", "[run][grid]") {
    const auto items = read_grid_items("0.5,1:2:3,T/4");
    REQUIRE(items.size() == 3);
    CHECK_FALSE(items[0].is_range);
    CHECK(items[1].is_range);
    CHECK(items[1].values.size() == 3);
    CHECK(items[2].values.front().text == "T/4");
    CHECK_THROWS_AS(read_grid_items("1,,2"), libration::error);
}

TEST_CASE("whole numbers come in lists and ranges", "[run][grid]") {
    CHECK(values_of("5,10,5:20:4") == std::vector<long>{5, 10, 5, 10, 15, 20});
    CHECK(values_of("1:1000:4log") == std::vector<long>{1, 10, 100, 1000});
    CHECK(values_of("20:5:4") == std::vector<long>{20, 15, 10, 5});
    CHECK(values_of("1e3") == std::vector<long>{1000});
}

TEST_CASE("a range that does not come out whole names the nearest counts that do", "[run][grid]") {
    CHECK_THROWS_WITH(values_of("5:100:10"), Contains("'5:100:10'") && Contains("are: 6 and 20"));
    CHECK_THROWS_WITH(values_of("100:5:10"), Contains("are: 6 and 20"));
    CHECK_THROWS_WITH(values_of("0:7:4"), Contains("are: 2 and 8"));
    CHECK_THROWS_WITH(values_of("0:7:20"), Contains("are: 8") && !Contains("and"));
    CHECK_THROWS_WITH(values_of("1:100:4log"), Contains("are: 3"));
    CHECK_THROWS_WITH(values_of("1.5:3:2"), Contains("ends are not whole"));
}

TEST_CASE("what is no whole number from 0 on, or too large, is refused", "[run][grid]") {
    for (const std::string text : {"1.5", "-1", "T", "1,2.5"}) {
        INFO(text);
        CHECK_THROWS_WITH(values_of(text), Contains("which is not a whole number"));
    }
    CHECK_THROWS_WITH(values_of("100001"), Contains("not between 0 and 100000"));
    CHECK_THROWS_WITH(values_of("0:200000:3"), Contains("not between 0 and 100000"));
    CHECK(read_whole_items("1e30", 0).front().values.size() == 1);
}

}  // namespace run_whole_grid_test
