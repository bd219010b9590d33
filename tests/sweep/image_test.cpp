// Drawings: whole or cut short, and what is added and left out for print and for the page.
#include "sweep/image.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace sweep_image_test {

using namespace libration;
using namespace std::string_literals;

namespace {

// A PNG of one white pixel, as gnuplot's library would write it, by Python's zlib and struct.
const std::string pixel =
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x08\0\0\0\0\x3a\x7e\x9b\x55"
    "\0\0\0\nIDATx\x9c\x63\xf8\x0f\0\x01\x01\x01\0\x1b\xb6\xee\x56"
    "\0\0\0\0IEND\xae\x42\x60\x82"s;

}  // namespace

TEST_CASE("a drawing that was cut short anywhere is not whole", "[sweep][image]") {
    CHECK(is_whole_image(".png", pixel));
    CHECK(is_whole_image(".svg", "<svg>\n</svg>\n\n"));
    CHECK(is_whole_image(".pdf", "%PDF-1.5\nstartxref\n7\n%%EOF\n"));
    for (std::size_t length = 0; length < pixel.size(); ++length) {
        CHECK_FALSE(is_whole_image(".png", pixel.substr(0, length)));
    }
    CHECK_FALSE(is_whole_image(".svg", ""));
    CHECK_FALSE(is_whole_image(".svg", "<svg>\n<path d='M1,2"));
    CHECK_FALSE(is_whole_image(".pdf", "%PDF-1.5\nstartxref\n7\n%%EO"));
    CHECK_FALSE(is_whole_image(".txt", "text"));
}

TEST_CASE("a PNG says that it has 300 dots an inch, once", "[sweep][image]") {
    const std::string finished = finished_image(".png", pixel);
    CHECK(is_whole_image(".png", finished));
    // 300 / 0.0254 = 11811.02 dots a metre; the checksum is zlib.crc32 of the chunk.
    CHECK(finished ==
          pixel.substr(0, 33) + "\0\0\0\tpHYs\0\0\x2e\x23\0\0\x2e\x23\1\x78\xa5\x3f\x76"s + pixel.substr(33));
    CHECK(finished_image(".png", finished) == finished);
}

TEST_CASE("a PDF says no time of day, and keeps its length", "[sweep][image]") {
    const std::string pdf = "/Creator\n/CreationDate (D:20261122191110Z)\n%%EOF\n";
    CHECK(finished_image(".pdf", pdf) == "/Creator\n/CreationDate (D:20000101000000Z)\n%%EOF\n");
    CHECK(finished_image(".pdf", "%%EOF") == "%%EOF");
}

TEST_CASE("an SVG loses what draws nothing", "[sweep][image]") {
    const std::string svg =
        "<svg>\n<defs>\n<path id='gpPt0' stroke-width='0.190' d='M-1,0 h2'/>\n</defs>\n"
        "<g fill=\"none\" stroke=\"rgb( 68,  68,  68)\">\n</g>\n"
        "<g color=\"black\">\n\t<path stroke='rgb(  0, 114, 178)'  d='M527.95,394.71 L511.86,364.44  '/></g>\n"
        "<g color=\"black\">\n\t<path stroke='rgb(  0, 114, 178)'  d='M1.00,2.99 L3,4  '/></g>\n"
        "<g color=\"black\">\n\t<path stroke='rgb(213,  94,   0)'  d='M5,6 L7,8  '/></g>\n"
        "<text>1.718  is a Label L rgb(1, 2, 3)</text>\n</svg>\n";
    CHECK(finished_image(".svg", svg) ==
          "<svg>\n<defs>\n<path id='gpPt0' stroke-width='0.190' d='M-1,0 h2'/>\n</defs>\n\n"
          "<g color=\"black\">\n<path stroke='#0072b2' d='M527.9,394.7 511.8,364.4 M1.0,2.9 3,4 '/>"
          "<path stroke='#d55e00' d='M5,6 7,8 '/></g>\n"
          "<text>1.718  is a Label L rgb(1, 2, 3)</text>\n</svg>\n");
}

TEST_CASE("an SVG keeps the spaces around subscripts and superscripts", "[sweep][image]") {
    const auto drawing = [](const std::string& text) { return "<svg>\n<defs>\n</defs>\n" + text + "\n</svg>\n"; };
    CHECK(finished_image(".svg", drawing("<text><tspan > log</tspan><tspan dy=\"4.20px\">10</tspan><tspan> x</tspan>"
                                         "</text><text><tspan > 0.5</tspan></text>")) ==
          drawing("<text xml:space=\"preserve\"><tspan >log</tspan><tspan dy=\"4.2px\">10</tspan><tspan> x</tspan>"
                  "</text><text><tspan > 0.5</tspan></text>"));
    CHECK(finished_image(".svg", drawing("<text></text><text><tspan>a</tspan></text>")) ==
          drawing("<text></text><text><tspan>a</tspan></text>"));
}

TEST_CASE("an SVG names the figure, and no curve by the words of its script", "[sweep][image]") {
    CHECK(finished_image(".svg",
                         "<svg>\n<title>Gnuplot</title>\n<defs>\n</defs>\n"
                         "<g id=\"a\" ><title>rows(file, 1, 2, '$3 &lt; 1') using 1:2</title>\n"
                         "<path stroke='rgb(1, 2, 3)'  d='M1.00,2.99 L3,4  '/></g>\n"
                         "<g id=\"b\" ><title>E = 1</title></g>\n</svg>\n") ==
          "<svg>\n<title>Gnuplot</title>\n<defs>\n</defs>\n"
          "<g id=\"a\" >\n<path stroke='#010203' d='M1.0,2.9 3,4 '/></g>\n\n</svg>\n");
}

}  // namespace sweep_image_test
