// Tables for papers: what LaTeX would read.
#include "text/latex.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace sweep_latex_test {

using namespace libration;

TEST_CASE("a number becomes mathematics, rounded from its text", "[sweep][latex]") {
    CHECK(latex_cell(read_cell("1.71")) == "$1.71$");
    CHECK(latex_cell(read_cell("-1.5e-300")) == "$-1.5\\times10^{-300}$");
    CHECK(latex_cell(read_cell("1e400")) == "$1\\times10^{400}$");
    // 1.2345678500...01 rounds up at 8 digits, although its double is that of 1.23456785.
    CHECK(latex_cell(read_cell("1.23456785000000000000000000001")) == "$1.2345679$");
    CHECK(latex_cell(read_cell("1.2345678499999999999999999999")) == "$1.2345678$");
    CHECK(latex_cell(read_cell("0.000012345678949e-2000")) == "$1.2345679\\times10^{-2005}$");
    CHECK(latex_cell(read_cell("123456784"), 8) == "$1.2345678\\times10^{8}$");
    CHECK(latex_cell(read_cell("0.0000123"), 3) == "$0.0000123$");
    CHECK(latex_cell(123456789) == "$123456789$");  // whole numbers keep all digits
    CHECK(latex_cell("1.5") == "1.5");              // text is text, whatever it looks like
}

TEST_CASE("words, infinities and special characters are text", "[sweep][latex]") {
    CHECK(latex_cell(read_cell("inf")) == "$\\infty$");
    CHECK(latex_cell(read_cell("-inf")) == "$-\\infty$");
    CHECK(latex_cell(read_cell("")) == "");
    CHECK(latex_cell(read_cell("two-method")) == "two-method");
    CHECK(latex_cell(read_cell("mpfr:50")) == "mpfr:50");
    CHECK(latex_cell(read_cell("3T/4")) == "3T/4");
    CHECK(latex_cell(read_cell("1.2.3")) == "1.2.3");
    CHECK(latex_text("50% & a_b {#} ~^\\ $") == "50\\% \\& a\\_b \\{\\#\\} \\~{}\\^{}\\textbackslash{} \\$");
}

TEST_CASE("a framed table has its rules, its heads on every page, and no column that serves a figure",
          "[sweep][latex]") {
    const table data{{{"energy", "E"}, {"log10_gap", "log10 of |2 - E|"}, {"time_of_maximum", "t"}},
                     {{number_cell("1.71"), number_cell("-0.5"), ""}, {number_cell("2.02"), number_cell("-1.7"), 3}}};
    const std::string text = to_latex(data, {"A caption.", "a_label"});
    CHECK(text.find("\\begin{longtable}{ll}\n\\caption{A caption.}\\label{tab:a_label}\\\\\n\\toprule\n"
                    "energy & time\\_of\\_maximum \\\\\n\\midrule\n\\endfirsthead\n") != std::string::npos);
    CHECK(text.ends_with("$1.71$ &  \\\\\n$2.02$ & $3$ \\\\\n\\end{longtable}\n"));
    CHECK(text.find("log10") == std::string::npos);
}

TEST_CASE("a short table keeps every digit, and an empty first cell its place", "[sweep][latex]") {
    const table data{{{"a", ""}, {"b", ""}}, {{"", number_cell("1.2345678901234567890")}}};
    CHECK(to_latex(data) ==
          "\\begin{tabular}{ll}\n\\toprule\na & b \\\\\n\\midrule\n & $1.2345678901234567890$ \\\\\n\\bottomrule\n"
          "\\end{tabular}\n");
}

}  // namespace sweep_latex_test
