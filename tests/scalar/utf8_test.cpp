#include "libration/scalar/utf8.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace scalar_utf8_test {

using namespace libration;

TEST_CASE("characters of UTF-8 have their bytes, and others none", "[scalar]") {
    CHECK(bytes_of_character("x^2") == 1);
    CHECK(bytes_of_character("\n") == 1);
    CHECK(bytes_of_character("\u00b2") == 2);
    CHECK(bytes_of_character("\u2212 1") == 3);
    CHECK(bytes_of_character("\U0001d703") == 4);
    // A byte that continues, one that no character begins with, an overlong form, and characters that are cut off.
    for (const std::string& text :
         std::vector<std::string>{"\x80", "\xff", "\xc0\x80", "\xc2", "\xe2\x88", "\xe2\x28\xa1"}) {
        CHECK(bytes_of_character(text) == 0);
    }
}

TEST_CASE("control characters are not printable", "[scalar]") {
    CHECK((is_printable("x") && is_printable(" ") && is_printable("\u03b8") && is_printable("\u00a0")));
    CHECK_FALSE((is_printable("\n") || is_printable("\x7f") || is_printable("\u0085")));
}

}  // namespace scalar_utf8_test
