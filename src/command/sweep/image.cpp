#include "sweep/image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace libration {

namespace {

using namespace std::string_literals;

const std::string png_end = "\0\0\0\0IEND\xae\x42\x60\x82"s;
// Length 9, 11811 dots per metre in x and y, unit 1 (the metre), and the checksum of the chunk.
const std::string png_resolution = "\0\0\0\x09pHYs\0\0\x2e\x23\0\0\x2e\x23\x01\x78\xa5\x3f\x76"s;
constexpr std::size_t png_header_bytes = 33;  // signature and IHDR

// The content without white space at its end.
std::string_view trimmed_image(const std::string& content) {
    const std::size_t last = content.find_last_not_of(" \t\r\n");
    return std::string_view(content).substr(0, last == std::string::npos ? 0 : last + 1);
}

std::string with_resolution(const std::string& png) {
    const bool known = png.find("pHYs") < 200;
    return known || png.size() < png_header_bytes
               ? png
               : png.substr(0, png_header_bytes) + png_resolution + png.substr(png_header_bytes);
}

// /CreationDate (D:20260102030405+00'00): its digits are replaced by those of a fixed day, keeping their number.
std::string without_time(std::string pdf) {
    constexpr std::string_view key = "/CreationDate (D:";
    constexpr std::string_view fixed = "20000101000000";
    if (const std::size_t at = pdf.find(key); at != std::string::npos) {
        for (std::size_t i = 0; i < fixed.size() && at + key.size() + i < pdf.size(); ++i) {
            char& c = pdf[at + key.size() + i];
            c = std::isdigit(static_cast<unsigned char>(c)) != 0 ? fixed[i] : c;
        }
    }
    return pdf;
}

// rgb( 68,  68,  68) as #444444, starting at `at`, which is moved behind it.
std::string hexadecimal_colour(const std::string& svg, std::size_t& at) {
    std::string colour = "#";
    at += std::string_view("rgb(").size();
    for (int part = 0; part < 3; ++part) {
        char* behind = nullptr;
        colour += fmt::format("{:02x}", std::strtol(svg.c_str() + at, &behind, 10));
        at = static_cast<std::size_t>(behind - svg.c_str()) + 1;  // the comma or the parenthesis
    }
    return colour;
}

// Within tags, never in text: colours in hexadecimal, numbers with one decimal, multiple blanks as one.
std::string shorter_words(const std::string& svg) {
    std::string out;
    out.reserve(svg.size());
    const auto digit = [&](std::size_t i) {
        return i < svg.size() && std::isdigit(static_cast<unsigned char>(svg[i])) != 0;
    };
    bool within = false;
    for (std::size_t i = 0; i < svg.size();) {
        within = svg[i] == '<' || (within && svg[i] != '>');
        if (within && svg.compare(i, 4, "rgb(") == 0) {
            out += hexadecimal_colour(svg, i);
        } else if (within && svg[i] == '.' && i > 0 && digit(i - 1) && digit(i + 1) && digit(i + 2)) {
            out.append(svg, i, 2);
            for (i += 2; digit(i);) {
                ++i;
            }
        } else if ((svg[i] == ' ' || svg[i] == '\t') && !out.empty() &&
                   (out.back() == '\n' || (within && out.back() == ' '))) {
            ++i;
        } else {
            out += svg[i++];
        }
    }
    return out;
}

// Removes empty groups <g ...></g>.
std::string without_empty_groups(const std::string& svg) {
    constexpr std::string_view end = "</g>";
    std::string out;
    out.reserve(svg.size());
    for (std::size_t i = 0; i < svg.size();) {
        if (svg.compare(i, end.size(), end) == 0) {
            const std::size_t last = out.find_last_not_of(" \n");
            const std::size_t open = out.rfind('<');
            if (last != std::string::npos && out[last] == '>' && out.compare(open, 3, "<g ") == 0) {
                out.resize(open);
                i += end.size();
                continue;
            }
        }
        out += svg[i++];
    }
    return out;
}

// The line that starts at `begin`, with its line end.
std::string line_at(const std::string& text, std::size_t begin) {
    return text.substr(begin, std::min(text.find('\n', begin), text.size() - 1) + 1 - begin);
}

// <path ... d='M1,2 L3,4 L5,6'/> without the letters that are implied by the next pair of coordinates.
std::string implied_lines(const std::string& path) {
    std::string out;
    const std::size_t data = path.find(" d='");
    for (std::size_t i = 0; i < path.size(); ++i) {
        out += i > data + 4 && path[i] == 'L' && path[i - 1] == ' ' ? "" : path.substr(i, 1);
    }
    return out;
}

// Joins two equal groups around one path each to one group around both, and in it two paths of one pen to one path.
std::string joined_groups(const std::string& svg) {
    constexpr std::string_view end = "</g>\n";
    constexpr std::string_view closing = "'/></g>\n";
    std::string out;
    out.reserve(svg.size());
    std::string group;  // the opening tag of the previous group, if it contained only paths
    std::string pen;    // the text before the lines of its last path
    for (std::size_t i = 0; i < svg.size();) {
        const std::string line = line_at(svg, i);
        i += line.size();
        const std::string next = i < svg.size() ? line_at(svg, i) : "";
        if (!line.starts_with("<g ") || !next.starts_with("<path ") || !next.ends_with(end)) {
            out += line.starts_with("<path ") ? implied_lines(line) : line;
            group.clear();
            continue;
        }
        i += next.size();
        const std::string path = implied_lines(next);
        const std::string head = path.substr(0, path.find(" d='") + 4);
        const bool same_group = group == line;
        if (same_group && pen == head && path.ends_with(closing)) {
            out.resize(out.size() - closing.size());  // the lines of one pen as one path
            out += path.substr(head.size());
            continue;
        }
        if (same_group) {
            out.resize(out.size() - end.size());
        } else {
            out += line;
        }
        out += path;
        group = line;
        pen = path.ends_with(closing) ? head : "";
    }
    return out;
}

// Removes the titles of curves, which a browser shows under the mouse pointer: a curve without a key entry has text of
// the script as its title.
std::string without_titles(const std::string& svg) {
    constexpr std::string_view begin = "<title>";
    constexpr std::string_view end = "</title>";
    std::string out;
    out.reserve(svg.size());
    std::size_t from = 0;
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, from)) {
        out.append(svg, from, at - from);
        const std::size_t last = svg.find(end, at);
        from = last == std::string::npos ? svg.size() : last + end.size();
    }
    return out.append(svg, from);
}

// Texts of several pieces, such as "log", "10" and " rad", keep their spaces except in front: librsvg omits a space at
// the start of a piece unless the text requests it.
std::string with_spaces_kept(const std::string& svg) {
    constexpr std::string_view begin = "<text>";
    constexpr std::string_view piece = "<tspan";
    std::string out;
    out.reserve(svg.size());
    std::size_t from = 0;
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, from)) {
        const std::size_t end = std::min(svg.find("</text>", at), svg.size());
        const std::size_t first = svg.find(piece, at);
        const std::size_t second = first == std::string::npos ? first : svg.find(piece, first + piece.size());
        out.append(svg, from, at - from);
        from = at + begin.size();
        if (second >= end) {
            out += begin;
            continue;
        }
        out += "<text xml:space=\"preserve\">";
        const std::size_t inside = svg.find('>', first) + 1;
        out.append(svg, from, inside - from);
        from = std::min(svg.find_first_not_of(' ', inside), svg.size());
    }
    return out.append(svg, from);
}

std::string compact(const std::string& svg) {
    const std::size_t body = svg.find("</defs>");  // the marks before it are measured in other units
    if (body == std::string::npos) {
        return svg;
    }
    return svg.substr(0, body) +
           with_spaces_kept(joined_groups(without_empty_groups(without_titles(shorter_words(svg.substr(body))))));
}

}  // namespace

bool is_whole_image(const std::string& extension, const std::string& content) {
    if (extension == ".png") {
        return content.ends_with(png_end);
    }
    return (extension == ".pdf" && trimmed_image(content).ends_with("%%EOF")) ||
           (extension == ".svg" && trimmed_image(content).ends_with("</svg>"));
}

std::string finished_image(const std::string& extension, const std::string& content) {
    if (extension == ".png") {
        return with_resolution(content);
    }
    return extension == ".pdf" ? without_time(content) : extension == ".svg" ? compact(content) : content;
}

}  // namespace libration
