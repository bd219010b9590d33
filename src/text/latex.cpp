#include "text/latex.hpp"

#include <string_view>
#include <vector>

#include "libration/scalar/exact.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration {

namespace {

std::string in_math(const std::string& decimal) {
    const auto e = decimal.find('e');
    const std::string power = e == std::string::npos ? "" : "\\times10^{" + decimal.substr(e + 1) + "}";
    return "$" + decimal.substr(0, e) + power + "$";
}

// Columns named log10_... serve the figures.
std::vector<std::size_t> shown_columns(const table& data) {
    std::vector<std::size_t> shown;
    shown.reserve(data.columns().size());
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        if (!data.columns()[i].name.starts_with("log10_")) {
            shown.push_back(i);
        }
    }
    return shown;
}

template <class Cell>
std::string line_of(const std::vector<std::size_t>& shown, const Cell& cell) {
    std::string line;
    for (const std::size_t i : shown) {
        line += (i == shown.front() ? "" : " & ") + cell(i);
    }
    return line + " \\\\\n";
}

}  // namespace

std::string latex_text(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) {
            out += std::string("\\") + c;
        } else if (c == '~' || c == '^') {
            out += std::string("\\") + c + "{}";
        } else if (c == '\\') {
            out += "\\textbackslash{}";
        } else {
            out += c;
        }
    }
    return out;
}

std::string latex_cell(const cell& content, long digits) {
    const std::string& text = content.text();
    if (!content.is_number() || text == "nan") {
        return latex_text(text);
    }
    if (text == "inf" || text == "-inf") {
        return text == "inf" ? "$\\infty$" : "$-\\infty$";
    }
    if (content.digits() <= digits) {
        return in_math(text);
    }
    const precision_scope scope(static_cast<long>(text.size()) + 20);
    return in_math(to_decimal(from_exact<mpfr>(read_exact(text)), digits));
}

std::string to_latex(const table& data, const latex_frame& frame) {
    const auto shown = shown_columns(data);
    std::string out =
        "% \\usepackage{booktabs,longtable}. Numbers are rounded to 8 digits; the CSV beside this has all.\n";
    for (const std::size_t i : shown) {
        out += "% " + data.columns()[i].name + ": " + data.columns()[i].meaning + "\n";
    }
    const std::string heads = line_of(shown, [&](std::size_t i) { return latex_text(data.columns()[i].name); });
    out += "\\begin{longtable}{" + std::string(shown.size(), 'l') + "}\n";
    out += "\\caption{" + frame.caption + "}\\label{tab:" + frame.label + "}\\\\\n";
    out += "\\toprule\n" + heads + "\\midrule\n\\endfirsthead\n";
    out += "\\toprule\n" + heads + "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n";
    for (const auto& row : data.rows()) {
        out += line_of(shown, [&](std::size_t i) { return latex_cell(row[i]); });
    }
    return out + "\\end{longtable}\n";
}

std::string to_latex(const table& data) {
    const auto shown = shown_columns(data);
    constexpr long all_digits = 1'000'000;
    std::string out = "\\begin{tabular}{" + std::string(shown.size(), 'l') + "}\n\\toprule\n";
    out += line_of(shown, [&](std::size_t i) { return latex_text(data.columns()[i].name); }) + "\\midrule\n";
    for (const auto& row : data.rows()) {
        out += line_of(shown, [&](std::size_t i) { return latex_cell(row[i], all_digits); });
    }
    return out + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace libration
