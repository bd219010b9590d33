#include "text/csv_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "text/input_error.hpp"

namespace libration {

namespace {

constexpr std::size_t longest_record = std::size_t{1} << 16;

}  // namespace

separator separator_of(const std::string& line) {
    const auto commas = std::count(line.begin(), line.end(), ',');
    const auto semicolons = std::count(line.begin(), line.end(), ';');
    if (semicolons > 0 && semicolons >= commas) {
        return separator::semicolon;
    }
    return commas > 0                             ? separator::comma
           : line.find('\t') != std::string::npos ? separator::tabulator
                                                  : separator::blanks;
}

split_record split_cells(const std::string& record, separator between) {
    const bool blanks = between == separator::blanks;
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    const auto ends_cell = [&](char c) { return blanks ? is_blank(c) : c == static_cast<char>(between); };
    std::vector<std::string> cells{""};
    bool quoted = false;
    bool at_start = true;
    for (std::size_t i = blanks ? record.find_first_not_of(" \t") : 0; i < record.size(); ++i) {
        const char c = record[i];
        if (quoted && c == '"') {
            const bool doubled = i + 1 < record.size() && record[i + 1] == '"';
            cells.back() += doubled ? "\"" : "";
            quoted = doubled;
            i += doubled ? 1 : 0;
        } else if (!quoted && at_start && c == '"') {
            quoted = true;
            at_start = false;
        } else if (!quoted && ends_cell(c)) {
            while (blanks && i + 1 < record.size() && is_blank(record[i + 1])) {
                ++i;
            }
            if (blanks && i + 1 == record.size()) {
                break;
            }
            cells.emplace_back();
            at_start = true;
        } else {
            cells.back() += c;
            at_start = false;
        }
    }
    return {std::move(cells), !quoted};
}

std::optional<std::vector<std::string>> cells_of(const std::string& record, separator between) {
    split_record split = split_cells(record, between);
    return split.closed ? std::optional(std::move(split.cells)) : std::nullopt;
}

std::string written_cell(const std::string& cell) {
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
        return cell;
    }
    std::string quoted = "\"";
    for (const char c : cell) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

std::string trimmed(const std::string& text) {
    const char* const blanks = " \t\r";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Memory is bounded also where no line ends, as in /dev/zero.
bool csv_records::read_line(std::string& line) {
    line.clear();
    std::array<char, 1 << 12> piece{};
    do {
        in_.clear(in_.rdstate() & ~std::ios::failbit);
        in_.getline(piece.data(), piece.size());
        const bool ended = in_.good();
        line.append(piece.data(), static_cast<std::size_t>(in_.gcount()) - (ended ? 1 : 0));
        if (ended) {
            return true;
        }
        if (line.size() > longest_line) {
            throw input_error(
                fmt::format("{} has more than {} characters in line {}: give a text file of shorter lines", title_,
                            longest_line, line_ + 1));
        }
    } while (!in_.eof() && !in_.bad());
    return !line.empty();
}

bool csv_records::take_line(std::string& line) {
    if (!pending_.empty()) {
        line = std::move(pending_.front());
        pending_.pop_front();
    } else if (!read_line(line)) {
        return false;
    }
    ++line_;
    if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) {
        line.erase(0, 3);
    }
    if (line.ends_with('\r')) {
        line.pop_back();
    }
    return true;
}

std::optional<csv_record> csv_records::next() {
    csv_record record{0, ""};
    do {
        if (!take_line(record.text)) {
            return std::nullopt;
        }
    } while (trimmed(record.text).empty());
    record.line = line_;
    if (record.text.find('"') == std::string::npos || cells_of(record.text, between_)) {
        return record;
    }
    std::string joined = record.text;
    std::deque<std::string> ahead;
    std::string line;
    while (joined.size() < longest_record && take_line(line)) {
        ahead.push_back(line);
        joined += '\n' + line;
        if (line.find('"') != std::string::npos && cells_of(joined, between_)) {
            record.text = std::move(joined);
            return record;
        }
    }
    line_ -= static_cast<long>(ahead.size());
    pending_.insert(pending_.begin(), ahead.begin(), ahead.end());
    return record;
}

}  // namespace libration
