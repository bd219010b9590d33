// Tables for papers: what LaTeX would read.
#include "text/latex.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

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

TEST_CASE("options and what the font of text lacks are printed as they are", "[sweep][latex]") {
    CHECK(latex_text("--energies 1") == "-{}-energies 1");
    CHECK(latex_text("a < b | c") == "a $<$ b $|$ c");
}

TEST_CASE("heads are symbols, or words", "[sweep][latex]") {
    CHECK(latex_head("energy") == "$E$");
    CHECK(latex_head("tstar") == "$T^*$");
    CHECK(latex_head("covered") == "covered");
    CHECK(latex_head("nonzero_multiplications") == "nonzero multiplications");
}

TEST_CASE("a framed table has its rules, its heads on every page, and no column that serves a figure",
          "[sweep][latex]") {
    const table data{{{"energy", "E"}, {"log10_gap", "log10 of |2 - E|"}, {"time_of_maximum", "t"}},
                     {{number_cell("1.71"), number_cell("-0.5"), ""}, {number_cell("2.02"), number_cell("-1.7"), 3}}};
    const std::string text = to_latex(data, {"A caption.", "a_label"});
    CHECK(text.find("\\begin{longtable}{r@{}lr}\n\\caption{A caption.}\\label{tab:a_label}\\\\\n\\toprule\n"
                    "\\multicolumn{2}{c}{$E$} & $t_{\\max}$ \\\\\n\\midrule\n\\endfirsthead\n") != std::string::npos);
    CHECK(text.ends_with("$1$ & ${.}71$ &  \\\\\n$2$ & ${.}02$ & $3$ \\\\\n\\end{longtable}\n\\endgroup\n"));
    CHECK(text.find("log10") == std::string::npos);
}

TEST_CASE("a column with one value throughout stands in the caption", "[sweep][latex]") {
    const table data{{{"energy", "E"}, {"scalar", ""}, {"order", "N"}},
                     {{number_cell("1.71"), "ball:50", 5}, {number_cell("2.02"), "ball:50", 5}}};
    const std::string text = to_latex(data, {"A caption.", "a_label"});
    CHECK(text.find("\\caption{A caption. Throughout: scalar $=$ ball:50, $N$ $=$ $5$.}") != std::string::npos);
    CHECK(text.find("\\begin{longtable}{r@{}l}\n") != std::string::npos);
}

TEST_CASE("a wide table comes in parts that begin with what says which row it is, and none is wider than the page",
          "[sweep][latex]") {
    std::vector<column> columns{{"energy", ""}};
    table_row_cells first{number_cell("1.9999999999")};
    table_row_cells second{number_cell("2.02")};
    for (int i = 0; i < 8; ++i) {
        columns.push_back({"column " + std::to_string(i), ""});
        first.push_back(number_cell("0.12345678"));
        second.push_back(number_cell("0.87654321"));
    }
    const std::string text = to_latex(table{columns, {first, second}}, {"A caption.", "a_label"});
    CHECK(text.find("Part 1 of 2.") != std::string::npos);
    CHECK(text.find("\\label{tab:a_label-2}") != std::string::npos);
    std::size_t parts = 0;
    for (std::size_t at = text.find("$1$ & ${.}9999999999$"); at != std::string::npos;
         at = text.find("$1$ & ${.}9999999999$", at + 1)) {
        ++parts;  // the energy keeps its digits: it is not 2
        // \textwidth is 345 pt, a digit of \footnotesize 4.25 pt: at most 80 in a line, and 10 in each of these
        // columns.
        const std::string line = text.substr(at, text.find('\n', at) - at);
        CHECK(std::count(line.begin(), line.end(), '&') / 2 <= 7);
    }
    CHECK(parts == 2);
}

TEST_CASE("a single row of many columns stands upright", "[sweep][latex]") {
    const table data{{{"energy", ""}, {"period", ""}, {"note", ""}, {"method", ""}},
                     {{number_cell("1"), number_cell("7.4162987092054876737"), "", "agm"}}};
    CHECK(to_latex(data) ==
          "\\begin{tabular}{ll}\n\\toprule\n$E$ & $1$ \\\\\n$T$ & $7.4162987092054876737$ \\\\\nmethod & agm \\\\\n"
          "\\bottomrule\n\\end{tabular}\n");
}

TEST_CASE("a short table keeps every digit, decimal points below each other, and no empty column", "[sweep][latex]") {
    const table data{{{"a", ""}, {"b", ""}, {"c", ""}},
                     {{"", number_cell("1.2345678901234567890"), "x"}, {"", number_cell("-10e-5"), "y"}}};
    CHECK(to_latex(data) ==
          "\\begin{tabular}{r@{}ll}\n\\toprule\n\\multicolumn{2}{c}{b} & c \\\\\n\\midrule\n"
          "$1$ & ${.}2345678901234567890$ & x \\\\\n$-10$ & ${}\\times10^{-5}$ & y \\\\\n\\bottomrule\n"
          "\\end{tabular}\n");
}

}  // namespace sweep_latex_test
