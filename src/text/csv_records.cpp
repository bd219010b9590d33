#include "text/csv_records.hpp"

#include <utility>

namespace libration {

namespace {

constexpr std::size_t longest_record = std::size_t{1} << 16;

}  // namespace

std::optional<std::vector<std::string>> cells_of(const std::string& record) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    bool at_start = true;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const char c = record[i];
        if (quoted && c == '"') {
            const bool doubled = i + 1 < record.size() && record[i + 1] == '"';
            cells.back() += doubled ? "\"" : "";
            quoted = doubled;
            i += doubled ? 1 : 0;
        } else if (!quoted && at_start && c == '"') {
            quoted = true;
            at_start = false;
        } else if (!quoted && c == ',') {
            cells.emplace_back();
            at_start = true;
        } else {
            cells.back() += c;
            at_start = false;
        }
    }
    return quoted ? std::nullopt : std::optional<std::vector<std::string>>(std::move(cells));
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

bool csv_records::take_line(std::string& line) {
    if (!pending_.empty()) {
        line = std::move(pending_.front());
        pending_.pop_front();
    } else if (!std::getline(in_, line)) {
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
    if (record.text.find('"') == std::string::npos || cells_of(record.text)) {
        return record;
    }
    std::string joined = record.text;
    std::deque<std::string> ahead;
    std::string line;
    while (joined.size() < longest_record && take_line(line)) {
        ahead.push_back(line);
        joined += '\n' + line;
        if (line.find('"') != std::string::npos && cells_of(joined)) {
            record.text = std::move(joined);
            return record;
        }
    }
    line_ -= static_cast<long>(ahead.size());
    pending_.insert(pending_.begin(), ahead.begin(), ahead.end());
    return record;
}

}  // namespace libration
