#include "coefficient_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "json_lines.hpp"
#include "libration/convergence/coefficient_list.hpp"
#include "run/progress.hpp"
#include "run/stream_content.hpp"
#include "text/column_file.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

using namespace convergence;

namespace {

constexpr std::size_t longest_list = std::size_t{1} << 28;

std::string content_of_list(const std::string& path) {
    input_stream stream("--coefficients", path);
    std::string content = content_of(stream.in(), path, longest_list);
    if (content.size() > longest_list) {
        throw input_error("--coefficients", path, fmt::format("is longer than {} characters", longest_list),
                          "give fewer coefficients or fewer digits");
    }
    return content;
}

// The list in a text; a wrong line is named.
std::vector<exact> list_in(const std::string& text, const std::string& path) {
    std::vector<exact> list;
    try {
        list = read_coefficients(text);
    } catch (const malformed_line& problem) {
        throw input_error("--coefficients", path,
                          fmt::format("line {}: {} {}", problem.number(), quotation(problem.text()), problem.reason()),
                          "write one number per line such as 0.25, 1/3 or 1e-30, or n,coefficient with increasing n");
    }
    if (list.empty()) {
        throw input_error("--coefficients", path, "holds no coefficient",
                          "write one number per line, or n,coefficient");
    }
    return list;
}

using list_cells = std::vector<std::string>;

// The cells of a line without its comment.
list_cells cells_of_line(const std::string& whole) {
    const std::string line = trimmed(whole.substr(0, whole.find('#')));
    const separator between = separator_of(line);
    list_cells found = split_cells(line, between == separator::tabulator ? separator::blanks : between).cells;
    std::transform(found.begin(), found.end(), found.begin(), trimmed);
    if (found.back().empty()) {  // a separator at the end, or nothing but a comment
        found.pop_back();
    }
    return found;
}

// The cells by line, none in an empty one.
std::vector<list_cells> lines_of_text(const std::string& text) {
    std::istringstream in(text);
    csv_records records(in);
    std::vector<list_cells> lines;
    while (const auto record = records.next()) {
        lines.resize(static_cast<std::size_t>(record->line - 1));
        lines.push_back(cells_of_line(record->text));
    }
    return lines;
}

bool is_name(const std::string& cell) {
    return !cell.empty() && (std::isalpha(static_cast<unsigned char>(cell.front())) != 0 || cell.front() == '_') &&
           cell != "i";
}

bool is_complex_cell(const std::string& cell) { return cell.ends_with('i') && cell != "pi"; }

// "1/2-3i" as "1/2" and "-3"; "i" is 0 and 1; a real number has the imaginary part 0.
std::pair<std::string, std::string> complex_parts_of(const std::string& cell) {
    if (!is_complex_cell(cell)) {
        return {cell, "0"};
    }
    std::string body = trimmed(cell.substr(0, cell.size() - 1));
    if (body.ends_with('*')) {
        body.pop_back();
    }
    std::size_t cut = body.find_last_of("+-");
    while (cut != std::string::npos && cut > 0 && (body[cut - 1] == 'e' || body[cut - 1] == 'E')) {
        cut = body.find_last_of("+-", cut - 1);
    }
    const bool both = cut != std::string::npos && cut > 0;
    std::string imaginary = trimmed(both ? body.substr(cut) : body);
    if (imaginary.empty() || imaginary == "+" || imaginary == "-") {
        imaginary += "1";
    }
    return {both ? trimmed(body.substr(0, cut)) : "0", imaginary};
}

// Which columns hold a list, by their places; the imaginary part's is that of the real part where the numbers are
// whole.
struct list_columns {
    std::string name;
    std::size_t real, imaginary;
    bool in_one() const { return real == imaginary; }
};

struct list_layout {
    std::optional<std::size_t> index;  // the column n
    std::size_t begin = 0;             // the first line of numbers
    std::vector<list_columns> lists;
};

std::optional<std::size_t> place_in(const list_cells& names, const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? std::nullopt : std::optional<std::size_t>(at - names.begin());
}

// NAME_re with NAME_im is one list, so is re with im; n and uncertainties are none.
std::vector<list_columns> named_columns(const list_cells& names, const std::optional<std::size_t>& index) {
    std::vector<list_columns> lists;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i];
        const bool plain = name != "re" && !name.ends_with("_re");
        const bool imaginary = name == "im" || name.ends_with("_im");
        const std::string stem = plain ? name : name.substr(0, name.size() - 2);
        if (i == index || name.ends_with("uncertainty")) {
            continue;
        }
        if (!plain && place_in(names, stem + "im")) {
            lists.push_back(
                {stem.empty() ? "coefficient" : stem.substr(0, stem.size() - 1), i, *place_in(names, stem + "im")});
        } else if (!imaginary || !place_in(names, name.substr(0, name.size() - 2) + "re")) {
            lists.push_back({name, i, i});
        }
    }
    return lists;
}

list_layout layout_of(const std::vector<list_cells>& lines) {
    list_layout found;
    while (found.begin < lines.size() && lines[found.begin].empty()) {
        ++found.begin;
    }
    if (found.begin == lines.size()) {
        return found;
    }
    const list_cells& first = lines[found.begin];
    if (!std::all_of(first.begin(), first.end(), is_name)) {
        found.index = first.size() == 2 ? std::optional<std::size_t>(0) : std::nullopt;
        found.lists.push_back({"", first.size() - 1, first.size() - 1});
        return found;
    }
    ++found.begin;
    found.index = place_in(first, "n");
    if (!found.index && first.size() == 2 && !place_in(first, "re")) {
        found.index = place_in(first, "coefficient") == std::size_t(0) ? 1 : 0;
    }
    if (const auto only = place_in(first, "coefficient")) {
        found.lists.push_back({"", *only, *only});
    } else {
        found.lists = named_columns(first, found.index);
    }
    return found;
}

// One part of one list as a text for the reader, line for line as the file, so that line numbers stay.
std::string part_text(const std::vector<list_cells>& lines, const list_layout& columns, const list_columns& list,
                      bool real, std::size_t width) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const list_cells& line = lines[i];
        if (i >= columns.begin && !line.empty()) {
            const bool whole = line.size() == width;
            const std::string& cell = line[std::min(real ? list.real : list.imaginary, line.size() - 1)];
            const std::string value = !list.in_one() ? cell
                                      : real         ? complex_parts_of(cell).first
                                                     : complex_parts_of(cell).second;
            text += (columns.index ? line[std::min(*columns.index, line.size() - 1)] + "," : "") +
                    (whole ? value : "another number of cells");
        }
        text += '\n';
    }
    return text;
}

// A list on one line, as it is copied from an encyclopedia of sequences, with one number per line.
std::string with_lines(std::string content) {
    const auto lines = lines_of_text(content);
    const auto first = std::ranges::find_if(lines, [](const list_cells& line) { return !line.empty(); });
    const auto others = std::ranges::count_if(lines, [](const list_cells& line) { return !line.empty(); }) - 1;
    if (others != 0 || first->size() < 3 || std::ranges::any_of(*first, is_name)) {
        return content;
    }
    return fmt::format("{}\n", fmt::join(*first, "\n"));
}

// The numbers n without a line that are few among those with one: a symmetry leaves out every second one or more.
std::vector<std::size_t> missing_in(const std::vector<list_cells>& lines, const list_layout& columns) {
    std::vector<std::size_t> missing;
    std::size_t next = 0;
    std::size_t count = 0;
    for (std::size_t i = columns.begin; i < lines.size() && columns.index; ++i) {
        const std::string cell = lines[i].size() > *columns.index ? lines[i][*columns.index] : "";
        if (cell.empty() || cell.size() > 9 || cell.find_first_not_of("0123456789") != std::string::npos) {
            continue;
        }
        const std::size_t n = std::stoul(cell);
        for (; count > 0 && next < n && missing.size() <= lines.size(); ++next) {
            missing.push_back(next);
        }
        next = n + 1;
        ++count;
    }
    return 10 * missing.size() <= count ? missing : std::vector<std::size_t>();
}

void say_missing(const std::string& content, const std::string& path) {
    const auto lines = lines_of_text(content);
    if (const auto missing = missing_in(lines, layout_of(lines)); !missing.empty()) {
        say_line(fmt::format("--coefficients '{}' has no line for n = {}: read as 0", path, fmt::join(missing, ", ")));
    }
}

}  // namespace

std::vector<exact> coefficients_in_file(const std::string& path) {
    const std::string content = with_lines(content_of_list(path));
    say_missing(content, path);
    return list_in(content, path);
}

std::vector<named_list> lists_in_file(const std::string& path) {
    std::string content = content_of_list(path);
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && (content[first] == '[' || content[first] == '{')) {
        try {
            content = lines_of_json(content);
        } catch (const std::runtime_error& problem) {
            throw input_error(
                "--coefficients", path, problem.what(),
                "write an array of numbers, of pairs [re, im] or of objects with the keys n and coefficient");
        }
    }
    content = with_lines(std::move(content));
    say_missing(content, path);
    const auto lines = lines_of_text(content);
    const list_layout columns = layout_of(lines);
    const bool any_complex = std::any_of(lines.begin(), lines.end(), [](const list_cells& line) {
        return std::any_of(line.begin(), line.end(), is_complex_cell);
    });
    const bool plain =
        columns.lists.size() < 2 && !any_complex && (columns.lists.empty() || columns.lists.front().in_one());
    if (plain) {
        return {{"", list_in(content, path), {}}};
    }
    const std::size_t width = lines[columns.begin < lines.size() ? columns.begin : 0].size();
    std::vector<named_list> lists;
    for (const list_columns& list : columns.lists) {
        const auto part = [&](bool real) { return list_in(part_text(lines, columns, list, real, width), path); };
        const bool is_complex = !list.in_one() || std::any_of(lines.begin(), lines.end(), [&](const list_cells& line) {
            return list.real < line.size() && is_complex_cell(line[list.real]);
        });
        lists.push_back({list.name, part(true), is_complex ? part(false) : std::vector<exact>{}});
    }
    return lists;
}

}  // namespace libration
