#include "table/table_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

#include "text/input_error.hpp"

namespace libration {

namespace {

// Each between blanks.
constexpr std::string_view keywords =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class"
    " co_await co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype"
    " default delete do double dynamic_cast else enum explicit export extern false float for friend goto if inline"
    " int long main mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public"
    " register reinterpret_cast requires return short signed sizeof static static_assert static_cast std struct"
    " switch template this thread_local throw true try typedef typeid typename union unsigned using virtual void"
    " volatile wchar_t while xor xor_eq boost SC_ ";

// A format of rows: its texts, in which {name}, {rows}, {columns}, {names}, {members} and {cells} are replaced by those of
// the table, and {} by a single cell or meaning.
struct row_format {
    std::string_view format, comment, head;
    std::string_view member = {}, note = {};
    std::string_view row, last_row, cell, between;
    std::string_view tail = {};
    std::string_view infinity = "inf";  ///< empty: it has none
    bool floating = false;              ///< cells are floating literals
};

// C++: struct NAME_row with a const char* a column, and the constexpr array NAME of them; inf as strtod and mpfr_set_str
// read it. C99: the same with NAME_rows, their number. Boost.Math [boost/libs/math/test]: a static array of arrays, which
// needs SC_ or T, table_type<T> and BOOST_JOIN in sight. NumPy: columns under comments, as loadtxt and genfromtxt read
// them, the last comment names the columns. PARI/GP: a matrix with a row a row, whose numbers have all their digits.
constexpr auto row_formats = std::to_array<row_format>(
    {{.format = "cpp",
      .comment = "//",
      .head = "#pragma once\n\n#include <array>\n\n"
              "/// A row; every number is the text of its decimal, so that any type can be read from it.\n"
              "struct {name}_row {{\n{members}}};\n\ninline constexpr std::array<{name}_row, {rows}> {name}{{{{\n",
      .member = "    const char* {};",
      .note = "  ///< {}",
      .row = "    {{{cells}}},\n",
      .last_row = "    {{{cells}}},\n",
      .cell = "\"{}\"",
      .between = ", ",
      .tail = "}};\n"},
     {.format = "c",
      .comment = "//",
      .head = "#ifndef {name}_H\n#define {name}_H\n\n"
              "// A row; every number is the text of its decimal, so that any type can be read from it.\n"
              "struct {name}_row {{\n{members}}};\n\nenum {{ {name}_rows = {rows} }};\n\n"
              "static const struct {name}_row {name}[] = {{\n",
      .member = "    const char* {};",
      .note = "  // {}",
      .row = "    {{{cells}}},\n",
      .last_row = "    {{{cells}}},\n",
      .cell = "\"{}\"",
      .between = ", ",
      .tail = "};\n\n#endif\n"},
     {.format = "ipp",
      .comment = "//",
      .head = "\n#ifndef SC_\n#define SC_(x) static_cast<T>(BOOST_JOIN(x, L))\n#endif\n\n"
              "static const std::array<std::array<typename table_type<T>::type, {columns}>, {rows}> {name} = {{{{\n",
      .row = "    {{{{{cells}}}}},\n",
      .last_row = "    {{{{{cells}}}}}\n",
      .cell = "SC_({})",
      .between = ", ",
      .tail = "}};\n",
      .infinity = "",
      .floating = true},
     {.format = "numpy",
      .comment = "#",
      .head = "#{names}\n",
      .row = "{cells}\n",
      .last_row = "{cells}\n",
      .cell = "{}",
      .between = " "},
     {.format = "pari",
      .comment = "\\\\",
      .head = "{{{name} = [\n",
      .row = "{cells};\n",
      .last_row = "{cells}\n",
      .cell = "{}",
      .between = ", ",
      .tail = "];}\n",
      .infinity = "oo",
      .floating = true}});

std::string comment_of(const std::vector<std::string>& lines, const std::string& mark) {
    std::string text;
    for (const std::string& line : lines) {
        text += mark;
        text += line.empty() ? "" : " ";
        text += line;
        text += '\n';
    }
    return text;
}

// A line of Fortran has 132 characters at most: a long text continues on the next ones.
std::string wrapped(const std::string& text, const std::string& joint) {
    constexpr std::size_t longest = 90;
    std::string lines = text.substr(0, longest);
    for (std::size_t at = longest; at < text.size(); at += longest) {
        lines += joint + text.substr(at, longest);
    }
    return lines;
}

// Comments in lines of that length, too.
std::vector<std::string> fortran_lines(const std::vector<std::string>& lines) {
    std::vector<std::string> short_lines;
    for (const std::string& line : lines) {
        std::istringstream parts(wrapped(line, "\n    "));
        for (std::string part; std::getline(parts, part);) {
            short_lines.push_back(part);
        }
    }
    return short_lines;
}

// Names that differ when capitals count as small letters, from each other and from the module's.
std::vector<std::string> fortran_names(const table& data, const std::string& module) {
    std::vector<std::string> names;
    std::vector<std::string> taken{module, module + "_rows"};
    const auto small = [](std::string name) {
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return name;
    };
    std::transform(taken.begin(), taken.end(), taken.begin(), small);
    for (const column& c : data.columns()) {
        std::string name = c.name;
        while (std::find(taken.begin(), taken.end(), small(name)) != taken.end()) {
            name += "_value";
        }
        taken.push_back(small(name));
        names.push_back(std::move(name));
    }
    return names;
}

// A module NAME of Fortran 2003, free form: character arrays of NAME_rows elements, one a column, whose elements
// read(x(i), *) takes into any kind. Of two names that Fortran does not tell apart, as k and K, the second ends in _value.
std::string fortran_text(const table& data, const table_origin& origin) {
    std::string out = comment_of(fortran_lines(origin.lines), "!") + fmt::format("module {}\n", origin.name);
    out += fmt::format("    implicit none\n    integer, parameter :: {}_rows = {}\n", origin.name, data.rows().size());
    const auto names = fortran_names(data, origin.name);
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::size_t longest = 1;
        for (const auto& row : data.rows()) {
            longest = std::max(longest, row[i].text().size());
        }
        out += fmt::format("    character(len={}), save :: {}({})\n", longest, names[i], data.rows().size());
        for (std::size_t at = 0; at < data.rows().size(); ++at) {
            out += fmt::format("    data {}({}) /'{}'/\n", names[i], at + 1,
                               wrapped(data.rows()[at][i].text(), "&\n        &"));
        }
    }
    return out + fmt::format("end module {}\n", origin.name);
}

// A NamedTuple NAME of Julia with a vector of strings a column: parse.(BigFloat, NAME.theta).
std::string julia_text(const table& data, const table_origin& origin) {
    std::string out = comment_of(origin.lines, "#") + fmt::format("const {} = (;\n", origin.name);
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        out += "    " + data.columns()[i].name + " = [\n";
        for (const auto& row : data.rows()) {
            out += "        \"" + row[i].text() + "\",\n";
        }
        out += "    ],\n";
    }
    return out + ")\n";
}

// A number as a cell; a floating literal has a point or an exponent.
std::string number_in(const row_format& of, const std::string& number) {
    if (number == "inf" || number == "-inf") {
        return of.floating ? (number == "inf" ? "+" : "-") + std::string(of.infinity) : number;
    }
    return of.floating && number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

void require_finite(const row_format& of, const table& data) {
    for (std::size_t at = 0; of.infinity.empty() && at < data.rows().size(); ++at) {
        const auto& row = data.rows()[at];
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (row[i].text() == "inf" || row[i].text() == "-inf") {
                throw input_error("--format", std::string(of.format),
                                  fmt::format("cannot hold the infinite {} of row {}", data.columns()[i].name, at + 1),
                                  "leave that row out, or choose csv, cpp or numpy");
            }
        }
    }
}

std::string row_text(const row_format& of, const table& data, const table_origin& origin) {
    require_finite(of, data);
    std::string names;
    std::string declarations;
    for (const column& c : data.columns()) {
        names += " " + c.name;
        declarations += fmt::format(fmt::runtime(of.member), c.name) +
                        (c.meaning.empty() ? "" : fmt::format(fmt::runtime(of.note), c.meaning)) + "\n";
    }
    std::string out = comment_of(origin.lines, std::string(of.comment));
    out += fmt::format(fmt::runtime(of.head), fmt::arg("name", origin.name), fmt::arg("names", names),
                       fmt::arg("members", declarations), fmt::arg("columns", data.columns().size()),
                       fmt::arg("rows", data.rows().size()));
    for (std::size_t at = 0; at < data.rows().size(); ++at) {
        std::string cells;
        for (const cell& each : data.rows()[at]) {
            cells += (cells.empty() ? "" : std::string(of.between)) +
                     fmt::format(fmt::runtime(of.cell), number_in(of, each.text()));
        }
        out += fmt::format(fmt::runtime(at + 1 < data.rows().size() ? of.row : of.last_row), fmt::arg("cells", cells));
    }
    return out + std::string(of.tail);
}

const row_format* row_format_named(const std::string& format) {
    const auto* const found = std::ranges::find(row_formats, format, &row_format::format);
    return found == row_formats.end() ? nullptr : found;
}

}  // namespace

void require_identifier(const std::string& name) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const bool letters = !name.empty() && std::all_of(name.begin(), name.end(), is_part);
    if (!letters || std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
        throw input_error("--name", name, "is not an identifier", "write letters, digits and _, a letter first");
    }
    const bool reserved = name.find("__") != std::string::npos || name.front() == '_' ||
                          keywords.find(' ' + name + ' ') != std::string_view::npos;
    if (reserved) {
        throw input_error("--name", name, "is reserved in C or C++", "choose another name");
    }
}

bool is_program_format(const std::string& format) {
    return format == "fortran" || format == "julia" || row_format_named(format) != nullptr;
}

std::string program_text(const std::string& format, const table& data, const table_origin& origin) {
    return format == "fortran" ? fortran_text(data, origin)
           : format == "julia" ? julia_text(data, origin)
                               : row_text(*row_format_named(format), data, origin);
}

}  // namespace libration
