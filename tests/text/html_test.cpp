// Pieces of the page: what stands in text, and images within the page.
#include "text/html.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>

namespace text_html_test {

using namespace libration;

TEST_CASE("an image within the page is base64 as in RFC 4648, section 10", "[text]") {
    for (const auto& [content, encoded] : {std::pair{"", ""},
                                           {"f", "Zg=="},
                                           {"fo", "Zm8="},
                                           {"foo", "Zm9v"},
                                           {"foob", "Zm9vYg=="},
                                           {"fooba", "Zm9vYmE="},
                                           {"foobar", "Zm9vYmFy"}}) {
        CHECK(data_uri("image/svg+xml", content) == std::string("data:image/svg+xml;base64,") + encoded);
    }
    CHECK(data_uri("a/b", std::string("\0\xff\x80", 3)) == "data:a/b;base64,AP+A");
}

TEST_CASE("text of a page holds no markup but code between backticks", "[text]") {
    CHECK(html_text("a < b & \"c\"") == "a &lt; b &amp; &quot;c&quot;");
    CHECK(html_prose("`x<y` and `z") == "<code>x&lt;y</code> and <code>z</code>");
}

}  // namespace text_html_test
