#include "table/table_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr auto keywords =
    std::to_array<std::string_view>({"alignas",   "alignof",      "and",           "and_eq",
                                     "asm",       "auto",         "bitand",        "bitor",
                                     "bool",      "break",        "case",          "catch",
                                     "char",      "char16_t",     "char32_t",      "char8_t",
                                     "class",     "co_await",     "co_return",     "co_yield",
                                     "compl",     "concept",      "const",         "const_cast",
                                     "consteval", "constexpr",    "constinit",     "continue",
                                     "decltype",  "default",      "delete",        "do",
                                     "double",    "dynamic_cast", "else",          "enum",
                                     "explicit",  "export",       "extern",        "false",
                                     "float",     "for",          "friend",        "goto",
                                     "if",        "inline",       "int",           "long",
                                     "main",      "mutable",      "namespace",     "new",
                                     "noexcept",  "not",          "not_eq",        "nullptr",
                                     "operator",  "or",           "or_eq",         "private",
                                     "protected", "public",       "register",      "reinterpret_cast",
                                     "requires",  "return",       "short",         "signed",
                                     "sizeof",    "static",       "static_assert", "static_cast",
                                     "std",       "struct",       "switch",        "template",
                                     "this",      "thread_local", "throw",         "true",
                                     "try",       "typedef",      "typeid",        "typename",
                                     "union",     "unsigned",     "using",         "virtual",
                                     "void",      "volatile",     "wchar_t",       "while",
                                     "xor",       "xor_eq",       "boost",         "SC_"});

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

template <class Text>
std::string joined(std::size_t count, const Text& text_of) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += (i == 0 ? "" : ", ") + text_of(i);
    }
    return text;
}

bool holds_infinity(const cell& number) { return number.text() == "inf" || number.text() == "-inf"; }

// A floating literal once a suffix is joined to it.
std::string floating(const std::string& number) {
    return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
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

}  // namespace

void require_identifier(const std::string& name) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const bool letters = !name.empty() && std::all_of(name.begin(), name.end(), is_part);
    if (!letters || std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
        throw input_error("--name", name, "is not an identifier", "write letters, digits and _, a letter first");
    }
    const bool reserved = name.find("__") != std::string::npos || name.front() == '_' ||
                          std::find(keywords.begin(), keywords.end(), name) != keywords.end();
    if (reserved) {
        throw input_error("--name", name, "is reserved in C or C++", "choose another name");
    }
}

std::string to_cpp_header(const table& data, const table_origin& origin) {
    std::string out = comment_of(origin.lines, "//") + "#pragma once\n\n#include <array>\n\n";
    out += "/// A row; every number is the text of its decimal, so that any type can be read from it.\n";
    out += fmt::format("struct {}_row {{\n", origin.name);
    for (const column& c : data.columns()) {
        out += fmt::format("    const char* {};{}\n", c.name, c.meaning.empty() ? "" : "  ///< " + c.meaning);
    }
    out += fmt::format("}};\n\ninline constexpr std::array<{0}_row, {1}> {0}{{{{\n", origin.name, data.rows().size());
    for (const auto& row : data.rows()) {
        out += "    {" + joined(row.size(), [&](std::size_t i) { return '"' + row[i].text() + '"'; }) + "},\n";
    }
    return out + "}};\n";
}

std::string to_ipp(const table& data, const table_origin& origin) {
    std::string out = comment_of(origin.lines, "//");
    out += "\n#ifndef SC_\n#define SC_(x) static_cast<T>(BOOST_JOIN(x, L))\n#endif\n\n";
    out += fmt::format("static const std::array<std::array<typename table_type<T>::type, {}>, {}> {} = {{{{\n",
                       data.columns().size(), data.rows().size(), origin.name);
    for (std::size_t at = 0; at < data.rows().size(); ++at) {
        const auto& row = data.rows()[at];
        const auto infinite = std::find_if(row.begin(), row.end(), holds_infinity);
        if (infinite != row.end()) {
            const auto place = static_cast<std::size_t>(infinite - row.begin());
            throw input_error("--format", "ipp",
                              fmt::format("cannot hold the infinite {} of row {}", data.columns()[place].name, at + 1),
                              "leave that row out, or choose csv, cpp or numpy");
        }
        out += "    {{" + joined(row.size(), [&](std::size_t i) { return "SC_(" + floating(row[i].text()) + ")"; }) +
               "}}" + (at + 1 < data.rows().size() ? ",\n" : "\n");
    }
    return out + "}};\n";
}

std::string to_numpy(const table& data, const table_origin& origin) {
    std::string out = comment_of(origin.lines, "#") + "#";
    for (const column& c : data.columns()) {
        out += " " + c.name;
    }
    out += "\n";
    for (const auto& row : data.rows()) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += (i > 0 ? " " : "") + row[i].text();
        }
        out += "\n";
    }
    return out;
}

std::string to_c_header(const table& data, const table_origin& origin) {
    std::string out = comment_of(origin.lines, "//");
    out += fmt::format("#ifndef {0}_H\n#define {0}_H\n\n", origin.name);
    out += "// A row; every number is the text of its decimal, so that any type can be read from it.\n";
    out += fmt::format("struct {}_row {{\n", origin.name);
    for (const column& c : data.columns()) {
        out += fmt::format("    const char* {};{}\n", c.name, c.meaning.empty() ? "" : "  // " + c.meaning);
    }
    out += fmt::format("}};\n\nenum {{ {0}_rows = {1} }};\n\nstatic const struct {0}_row {0}[] = {{\n", origin.name,
                       data.rows().size());
    for (const auto& row : data.rows()) {
        out += "    {" + joined(row.size(), [&](std::size_t i) { return '"' + row[i].text() + '"'; }) + "},\n";
    }
    return out + "};\n\n#endif\n";
}

std::string to_fortran(const table& data, const table_origin& origin) {
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

std::string to_julia(const table& data, const table_origin& origin) {
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

std::string to_pari(const table& data, const table_origin& origin) {
    std::string out = comment_of(origin.lines, "\\\\") + "{" + origin.name + " = [\n";
    for (std::size_t at = 0; at < data.rows().size(); ++at) {
        const auto& row = data.rows()[at];
        out += joined(row.size(), [&](std::size_t i) {
            const std::string& text = row[i].text();
            return text == "inf" ? "+oo" : text == "-inf" ? std::string("-oo") : floating(text);
        });
        out += at + 1 < data.rows().size() ? ";\n" : "\n";
    }
    return out + "];}\n";
}

table_writer writer_of(const std::string& format) {
    constexpr auto writers = std::to_array<std::pair<std::string_view, table_writer>>({{"cpp", to_cpp_header},
                                                                                       {"ipp", to_ipp},
                                                                                       {"numpy", to_numpy},
                                                                                       {"c", to_c_header},
                                                                                       {"fortran", to_fortran},
                                                                                       {"julia", to_julia},
                                                                                       {"pari", to_pari}});
    const auto* const found =
        std::find_if(writers.begin(), writers.end(), [&](const auto& each) { return each.first == format; });
    return found == writers.end() ? nullptr : found->second;
}

}  // namespace libration
