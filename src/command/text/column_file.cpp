#include "text/column_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <system_error>

#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

bool is_comment(const std::string& line) { return trimmed(line).starts_with('#'); }

// 0.7, -1e-3, .5, +2, T/4 no: no name begins so.
bool begins_a_number(const std::string& cell) {
    const std::size_t first = cell.find_first_not_of("+-");
    if (first == std::string::npos) {
        return false;
    }
    const std::string rest = cell.substr(first);
    return std::isdigit(static_cast<unsigned char>(rest.front())) != 0 || rest.front() == '.' || rest == "nan" ||
           rest == "inf";
}

std::vector<std::string> trimmed_cells(const std::string& line, separator between) {
    std::vector<std::string> names;
    if (const auto cells = cells_of(line, between)) {
        std::transform(cells->begin(), cells->end(), std::back_inserter(names), trimmed);
    }
    return names;
}

// The names in a comment above `count` columns: separated as they are, or by anything else.
std::vector<std::string> names_in_comment(const std::string& comment, separator between, std::size_t count) {
    const std::string line = trimmed(comment.substr(std::min(comment.find_first_not_of("# \t"), comment.size())));
    for (const separator each :
         {separator_of(line), between, separator::comma, separator::semicolon, separator::blanks}) {
        auto names = trimmed_cells(line, each);
        if (names.size() == count) {
            return names;
        }
    }
    return {};
}

}  // namespace

input_stream::input_stream(const std::string& option, const std::string& path)
    : option_(option), name_(path == "-" ? "stdin" : path) {
    if (path == "-") {
        return;
    }
    const char* const remedy = "name a readable file, or - for stdin";
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw input_error(option, path, "is a folder", remedy);
    }
    errno = 0;
    file_.open(path, std::ios::binary);
    if (!file_) {
        throw input_error(option, path, fmt::format("cannot be read ({})", std::strerror(errno)), remedy);
    }
}

std::istream& input_stream::in() {
    return file_.is_open() ? static_cast<std::istream&>(file_) : static_cast<std::istream&>(std::cin);
}

std::string input_stream::title() const { return option_ + " " + quotation(name_); }

column_file::column_file(input_stream& source) : records_(source.in(), source.title()) {
    std::string comment;
    auto record = records_.next();
    for (; record && is_comment(record->text); record = records_.next()) {
        comment = record->text;
    }
    const std::string line = record ? record->text : comment;
    if (line.empty()) {
        return;
    }
    between_ = separator_of(record ? line : line.substr(line.find('#') + 1));
    records_.separate_by(between_);
    if (!record) {  // nothing but comments: the last one may hold the names
        names_ = trimmed_cells(trimmed(line.substr(line.find('#') + 1)), between_);
        count_ = names_.size();
        return;
    }
    auto cells = trimmed_cells(line, between_);
    count_ = cells.size();
    if (std::all_of(cells.begin(), cells.end(), begins_a_number)) {
        names_ = names_in_comment(comment, between_, count_);
        first_ = std::move(record);
    } else {
        names_ = std::move(cells);
        first_ = next();
    }
}

std::optional<csv_record> column_file::next() {
    if (first_) {
        return std::exchange(first_, std::nullopt);
    }
    auto record = records_.next();
    while (record && is_comment(record->text)) {
        record = records_.next();
    }
    return record;
}

}  // namespace libration
