#include "text/latex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration {

namespace {

// Widths are in digits of the font: \textwidth of the class article in 10 points, in \normalsize and \footnotesize.
constexpr double page_width = 61;
constexpr double small_page_width = 73;
constexpr double between_columns = 2.4;
constexpr double prose_width = 26;  // text that is longer breaks into lines
constexpr long all_digits = 1'000'000;
constexpr long key_digits = 12;  // 1.9999999999 is not 2
constexpr std::size_t most_keys = 3;
constexpr std::size_t rows_of_a_page = 35;

std::string rounded(const cell& content, long digits) {
    const std::string& text = content.text();
    if (content.digits() <= digits) {
        return text;
    }
    const precision_scope scope(static_cast<long>(text.size()) + 20);
    mpfr value;
    const bool plain = mpfr_set_str(handle(value), text.c_str(), 10, MPFR_RNDN) == 0;
    return to_decimal(plain ? value : from_exact<mpfr>(read_exact(text)), digits);
}

bool is_decimal(const cell& content) {
    return content.is_number() && content.text().find_first_of("in") == std::string::npos;  // nan, inf
}

std::string power_of(const std::string& decimal) {
    const auto e = decimal.find('e');
    return e == std::string::npos ? "" : "\\times10^{" + decimal.substr(e + 1) + "}";
}

// The width of what LaTeX prints.
double width_of(std::string_view latex) {
    double width = 0;
    for (std::size_t i = 0; i < latex.size(); ++i) {
        const char c = latex[i];
        if (c == '\\') {
            const std::size_t begin = i + 1;
            while (i + 1 < latex.size() && ((latex[i + 1] >= 'a' && latex[i + 1] <= 'z') || latex[i + 1] == '%')) {
                ++i;
            }
            const std::string_view command = latex.substr(begin, i + 1 - begin);
            width += command == "times" ? 2.6 : command == "max" ? 3.5 : command.starts_with("math") ? 0 : 1.3;
        } else if (c == '-') {
            width += 1.6;
        } else if (c == '.' || c == ',' || c == '|') {
            width += 0.6;
        } else if (std::string_view("${}^_").find(c) == std::string_view::npos) {
            width += 1;
        }
    }
    return width;
}

// A column as LaTeX: of decimals it has two, which meet at the point.
struct latex_column {
    std::string name;
    bool of_numbers;
    bool of_decimals;
    std::vector<std::string> left, right;  // of text the right one is empty
    double width;

    double lines_width() const { return std::min(width, of_numbers ? width : prose_width); }
    bool is_prose() const { return !of_numbers && width > prose_width; }
    std::string head() const {
        return of_decimals ? "\\multicolumn{2}{c}{" + latex_head(name) + "}" : latex_head(name);
    }
    std::string line(std::size_t row) const { return of_decimals ? left[row] + " & " + right[row] : left[row]; }
};

// Whether a column identifies the row.
bool is_key(const std::string& name) {
    static const std::set<std::string> keys{"energy", "gap",    "order",   "method", "point",    "count",    "time",
                                            "scalar", "theta0", "omega0",  "digits", "problem",  "n",        "route",
                                            "half",   "kind",   "library", "step",   "function", "argument", "m1"};
    return keys.contains(name);
}

void add_number(latex_column& to, const cell& content, long digits) {
    if (content.is_empty()) {
        to.left.emplace_back();
        to.right.emplace_back();
        return;
    }
    const std::string decimal = rounded(content, digits);
    const std::string mantissa = decimal.substr(0, decimal.find('e'));
    const auto point = std::min(mantissa.find('.'), mantissa.size());
    const std::string behind = mantissa.substr(point) + power_of(decimal);
    to.left.push_back("$" + mantissa.substr(0, point) + "$");
    to.right.push_back(behind.empty() ? "" : "${" + behind.substr(0, 1) + "}" + behind.substr(1) + "$");
    if (behind.starts_with("\\")) {
        to.right.back() = "$" + std::string("{}") + behind + "$";
    }
}

// Prose may break behind what joins words.
std::string breakable(const std::string& latex) {
    if (width_of(latex) <= prose_width) {
        return latex;
    }
    std::string out;
    for (const char c : latex) {
        out += c;
        out += std::string_view("/_(=,").find(c) != std::string_view::npos ? "\\allowbreak{}" : "";
    }
    return out;
}

latex_column column_at(const table& data, std::size_t place, long digits) {
    const auto& rows = data.rows();
    const bool of_numbers =
        std::all_of(rows.begin(), rows.end(),
                    [&](const auto& row) { return row[place].is_empty() || is_decimal(row[place]); }) &&
        std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return !row[place].is_empty(); });
    latex_column result{data.columns()[place].name, of_numbers, false, {}, {}, 0};
    double left = 0;
    double right = 0;
    const long kept = is_key(result.name) ? std::max(digits, key_digits) : digits;
    for (const auto& row : rows) {
        if (of_numbers) {
            add_number(result, row[place], kept);
            right = std::max(right, width_of(result.right.back()));
            result.of_decimals = result.of_decimals || !result.right.back().empty();
        } else {
            result.left.push_back(breakable(latex_cell(row[place], digits)));
        }
        left = std::max(left, width_of(result.left.back()));
    }
    result.width = std::max(left + right, width_of(latex_head(result.name)));
    return result;
}

std::vector<latex_column> columns_of(const table& data, const std::vector<std::size_t>& shown, long digits) {
    std::vector<latex_column> columns;
    columns.reserve(shown.size());
    std::transform(shown.begin(), shown.end(), std::back_inserter(columns),
                   [&](std::size_t place) { return column_at(data, place, digits); });
    return columns;
}

// The first columns say which row it is: every part of a wide table begins with them.
// The first columns say which row it is: every part of a wide table begins with them.
std::size_t keys_of(const std::vector<latex_column>& columns) {
    std::size_t count = 0;
    while (count < std::min(columns.size(), most_keys) && is_key(columns[count].name)) {
        ++count;
    }
    return count;
}

double needed(const latex_column& each) { return each.lines_width() + between_columns; }

double needed(const std::vector<latex_column>& columns) {
    double width = 0;
    for (const latex_column& each : columns) {
        width += needed(each);
    }
    return width;
}

// Row numbers, used if the columns that identify the row would leave no space for others.
latex_column row_numbers(std::size_t rows) {
    latex_column numbers{"row", true, false, {}, {}, 3};
    for (std::size_t i = 1; i <= rows; ++i) {
        numbers.left.push_back(std::to_string(i));
        numbers.right.emplace_back();
    }
    return numbers;
}

// The columns of each part, so that none is wider than the page.
std::vector<std::vector<latex_column>> parts_of(const std::vector<latex_column>& columns, double page) {
    if (needed(columns) <= page || columns.empty()) {
        return {columns};
    }
    auto behind = columns.begin() + static_cast<std::ptrdiff_t>(keys_of(columns));
    std::vector<latex_column> repeated(columns.begin(), behind);
    const auto widest = std::max_element(
        behind, columns.end(), [](const auto& a, const auto& b) { return a.lines_width() < b.lines_width(); });
    if (widest == columns.end() || needed(repeated) + needed(*widest) > page) {
        repeated = {row_numbers(columns.front().left.size())};
        behind = columns.begin();
    }
    std::vector<std::vector<latex_column>> parts{repeated};
    for (auto each = behind; each != columns.end(); ++each) {
        if (needed(parts.back()) + needed(*each) > page && parts.back().size() > repeated.size()) {
            parts.push_back(repeated);
        }
        parts.back().push_back(*each);
    }
    return parts;
}

template <class Cell>
std::string line_of(const std::vector<latex_column>& columns, const Cell& cell) {
    std::string line;
    for (const latex_column& each : columns) {
        line += (&each == &columns.front() ? "" : " & ") + cell(each);
    }
    return line + " \\\\\n";
}

// Columns of prose share what the others leave of the page.
std::string preamble_of(const std::vector<latex_column>& columns, double page) {
    double left = page;
    int prose = 0;
    for (const latex_column& each : columns) {
        left -= between_columns + (each.is_prose() ? 0 : each.lines_width());
        prose += each.is_prose() ? 1 : 0;
    }
    const double width = prose > 0 ? std::max(prose_width, left / prose) : 0;
    std::string preamble;
    for (const latex_column& each : columns) {
        preamble += each.of_decimals  ? "r@{}l"
                    : each.of_numbers ? "r"
                    : each.is_prose() ? fmt::format("p{{{:.1f}em}}", width / 2)
                                      : "l";
    }
    return "{" + preamble + "}\n";
}

std::string heads_of(const std::vector<latex_column>& columns) {
    return "\\toprule\n" + line_of(columns, [](const latex_column& each) { return each.head(); }) + "\\midrule\n";
}

std::string lines_of(const std::vector<latex_column>& columns, std::size_t rows) {
    std::string lines;
    for (std::size_t row = 0; row < rows; ++row) {
        lines += line_of(columns, [&](const latex_column& each) { return each.line(row); });
    }
    return lines;
}

// A row of many columns as lines: what it is, and its value.
bool stands_upright(const table& data, const std::vector<std::size_t>& shown) {
    return data.rows().size() == 1 && shown.size() > 2;
}

std::string upright_lines(const table& data, const std::vector<std::size_t>& shown, long digits) {
    std::string lines;
    for (const std::size_t place : shown) {
        const cell& value = data.rows().front()[place];
        if (!value.is_empty()) {
            lines += latex_head(data.columns()[place].name) + " & " + latex_cell(value, digits) + " \\\\\n";
        }
    }
    return lines;
}

// Columns named log10_... are for the figures only; those with a constant value are in the caption.
std::vector<std::size_t> framed_columns(const table& data, std::string& constants) {
    std::vector<std::size_t> shown;
    const auto& rows = data.rows();
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        const bool constant = rows.size() > 1 && std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
                                  return row[i] == rows.front()[i];
                              });
        if (data.columns()[i].name.starts_with("log10_")) {
            continue;
        }
        if (!constant) {
            shown.push_back(i);
        } else if (!rows.front()[i].is_empty()) {
            constants += (constants.empty() ? " Throughout: " : ", ") + latex_head(data.columns()[i].name) + " $=$ " +
                         latex_cell(rows.front()[i]);
        }
    }
    constants += constants.empty() ? "" : ".";
    return shown;
}

// The largest number of digits with which all columns fit the page, 5 to 8; 8 if even 5 are too many.
std::vector<std::vector<latex_column>> framed_parts(const table& data, const std::vector<std::size_t>& shown) {
    for (const long digits : {8, 7, 6, 5}) {
        auto parts = parts_of(columns_of(data, shown, digits), small_page_width);
        if (parts.size() == 1) {
            return parts;
        }
    }
    return parts_of(columns_of(data, shown, 8), small_page_width);
}

std::string longtable(const std::string& preamble, const std::string& caption, const std::string& label,
                      const std::string& heads, const std::string& lines) {
    return "\\begin{longtable}" + preamble + "\\caption{" + caption + "}\\label{tab:" + label + "}\\\\\n" + heads +
           "\\endfirsthead\n" + heads + "\\endhead\n\\bottomrule\n\\endfoot\n" + lines + "\\end{longtable}\n";
}

}  // namespace

std::string latex_cell(const cell& content, long digits) {
    const std::string& text = content.text();
    if (!content.is_number() || text == "nan") {
        return latex_text(text);
    }
    if (text == "inf" || text == "-inf") {
        return text == "inf" ? "$\\infty$" : "$-\\infty$";
    }
    const std::string decimal = rounded(content, digits);
    return "$" + decimal.substr(0, decimal.find('e')) + power_of(decimal) + "$";
}

std::string to_latex(const table& data, const latex_frame& frame) {
    std::string out =
        "% \\usepackage{booktabs,longtable}. Numbers are rounded to 8 digits or fewer; the CSV beside this has all.\n";
    for (const column& each : data.columns()) {
        out += each.name.starts_with("log10_") ? "" : "% " + each.name + ": " + each.meaning + "\n";
    }
    std::string constants;
    const auto shown = framed_columns(data, constants);
    const std::string caption = frame.caption + constants;
    out += "\\begingroup\\footnotesize\\setlength{\\tabcolsep}{4pt}\n";
    if (stands_upright(data, shown)) {
        out += longtable("{ll}\n", caption, frame.label, "\\toprule\n", upright_lines(data, shown, 8));
    } else {
        const auto parts = framed_parts(data, shown);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::string part = parts.size() > 1 ? fmt::format(" Part {} of {}.", i + 1, parts.size()) : "";
            const std::string label = frame.label + (i > 0 ? fmt::format("-{}", i + 1) : "");
            out += longtable(preamble_of(parts[i], small_page_width), caption + part, label, heads_of(parts[i]),
                             lines_of(parts[i], data.rows().size()));
        }
    }
    return out + "\\endgroup\n";
}

std::string to_latex(const table& data) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        if (std::any_of(data.rows().begin(), data.rows().end(), [&](const auto& row) { return !row[i].is_empty(); })) {
            shown.push_back(i);
        }
    }
    if (stands_upright(data, shown)) {
        return "\\begin{tabular}{ll}\n\\toprule\n" + upright_lines(data, shown, all_digits) +
               "\\bottomrule\n\\end{tabular}\n";
    }
    std::string out;
    for (const auto& part : parts_of(columns_of(data, shown, all_digits), page_width)) {
        const bool prose = std::any_of(part.begin(), part.end(), [](const auto& each) { return each.is_prose(); });
        const bool is_long = data.rows().size() > (prose ? rows_of_a_page / 6 : rows_of_a_page);
        out += out.empty() ? "" : "\n\\medskip\n\n";
        out += is_long ? "\\begin{longtable}" : "\\begin{tabular}";
        out += preamble_of(part, page_width);
        out += heads_of(part);
        out += is_long ? "\\endhead\n" : "";
        out += lines_of(part, data.rows().size());
        out += is_long ? "\\bottomrule\n\\end{longtable}\n" : "\\bottomrule\n\\end{tabular}\n";
    }
    return out;
}

}  // namespace libration
