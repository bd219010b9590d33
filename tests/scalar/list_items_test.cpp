#include "libration/scalar/list_items.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace scalar_list_items_test {

std::vector<std::string> items(std::string_view text, char separator = ',') {
    const auto parts = libration::list_items(text, separator);
    return {parts.begin(), parts.end()};
}

using list = std::vector<std::string>;

TEST_CASE("a list is split at separators outside parentheses", "[text]") {
    CHECK(items("1, bessel_j(0, 2) ,3") == list{"1", "bessel_j(0, 2)", "3"});
    CHECK(items(" 0 :\t1 : 5", ':') == list{"0", "1", "5"});
    CHECK(items("((1,2),3),4") == list{"((1,2),3)", "4"});
    CHECK(items("0:max(1,2):5", ':') == list{"0", "max(1,2)", "5"});
}

TEST_CASE("a list has at least one item, and empty items are kept", "[text]") {
    CHECK(items("") == list{""});
    CHECK(items(" , ") == list{"", ""});
    CHECK(items("1,,2,") == list{"1", "", "2", ""});
    CHECK(items("1),2") == list{"1)", "2"});
}

}  // namespace scalar_list_items_test
