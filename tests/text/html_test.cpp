// Pieces of the page: what stands in text, and images within the page.
#include "text/html.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <utility>

namespace text_html_test {

using namespace libration;

TEST_CASE("text of a page holds no markup but code between backticks", "[text]") {
    CHECK(html_text("a < b & \"c\"") == "a &lt; b &amp; &quot;c&quot;");
    CHECK(html_prose("`x<y` and `z") == "<code>x&lt;y</code> and <code>z</code>");
}

TEST_CASE("a drawing within the page can be read back", "[text]") {
    CHECK(svg_uri("<svg a=\"1\" f='#fff'>\n50% &amp;</svg>") ==
          "data:image/svg+xml,<svg a='1' f='%23fff'> 50%25 &amp;amp;</svg>");
}

TEST_CASE("formulas on the page have symbols, subscripts and superscripts", "[text]") {
    for (const auto& [plain, html] : {std::pair{"theta'' + sin theta = 0", "θ′′ + sin θ = 0"},
                                      {"omega0 <= 1e-6", "ω<sub>0</sub> ≤ 10<sup>−6</sup>"},
                                      {"a_n t^n, a_(n+2)", "a<sub>n</sub> t<sup>n</sup>, a<sub>n+2</sub>"},
                                      {"T*^(N+1)", "T*<sup>N+1</sup>"},
                                      {"(T*/R)^N", "(T*/R)<sup>N</sup>"},
                                      {"sqrt(T*^2 + K~'^2)", "√(T*<sup>2</sup> + K̃′<sup>2</sup>)"},
                                      {"2 - E = 2.5e-7 +- 1e4", "2 − E = 2.5·10<sup>−7</sup> ± 10<sup>4</sup>"},
                                      {"2^-52", "2<sup>−52</sup>"},
                                      {"e^(a_0)", "e<sup>a<sub>0</sub></sup>"},
                                      {"sigma_N and ahat_N", "σ<sub>N</sub> and â<sub>N</sub>"}}) {
        CHECK(html_mathematics(plain) == html);
    }
}

TEST_CASE("what is no formula stays as it is", "[text]") {
    for (const std::string plain :
         {"the paper's words, a two-method check", "machine_precision_is_reached", "1.71 and 0xff", "0:T:401, 3T/4",
          "spin the pip, alphabet, E = 2.", "mpfr:50", "x ^ y", "f^(open", "1east"}) {
        CHECK(html_mathematics(plain) == plain);
    }
    CHECK(html_mathematics("a < b & c") == "a &lt; b &amp; c");
    CHECK(html_prose("`a_n^2` is a_n^2") == "<code>a_n^2</code> is a<sub>n</sub><sup>2</sup>");
}

}  // namespace text_html_test
