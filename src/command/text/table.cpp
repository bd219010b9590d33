#include "text/table.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "text/csv_records.hpp"

namespace libration {

namespace {

std::vector<column> named_columns(const std::vector<std::string>& names) {
    std::vector<column> columns;
    columns.reserve(names.size());
    for (const std::string& name : names) {
        columns.push_back({name, ""});
    }
    return columns;
}

table_row_cells read_cells(const std::vector<std::string>& texts) {
    table_row_cells cells;
    cells.reserve(texts.size());
    std::transform(texts.begin(), texts.end(), std::back_inserter(cells), read_cell);
    return cells;
}

void write_through(const std::string& path, const std::string& content) {
    errno = 0;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << content;
    file.close();
    if (!file) {
        throw std::runtime_error(errno != 0 ? std::strerror(errno) : "writing failed");
    }
}

}  // namespace

table::table(std::vector<column> columns, std::vector<table_row_cells> rows) : columns_(std::move(columns)) {
    rows_.reserve(rows.size());
    for (table_row_cells& row : rows) {
        add_row(std::move(row));
    }
}

void table::add_row(table_row_cells row) {
    if (row.size() != columns_.size()) {
        throw std::logic_error(fmt::format("a row of {} cells under {} columns", row.size(), columns_.size()));
    }
    rows_.push_back(std::move(row));
}

void table::append(const table& below) {
    const bool same = std::equal(columns_.begin(), columns_.end(), below.columns_.begin(), below.columns_.end(),
                                 [](const column& a, const column& b) { return a.name == b.name; });
    if (!same) {
        throw std::logic_error("two tables with different columns cannot be concatenated");
    }
    rows_.insert(rows_.end(), below.rows_.begin(), below.rows_.end());
}

table table::with_columns(const std::vector<std::size_t>& places) const {
    const auto chosen = [&](const auto& from) {
        std::remove_cvref_t<decltype(from)> some;
        some.reserve(places.size());
        for (const std::size_t place : places) {
            some.push_back(from.at(place));
        }
        return some;
    };
    table result(chosen(columns_));
    result.rows_.reserve(rows_.size());
    std::transform(rows_.begin(), rows_.end(), std::back_inserter(result.rows_), chosen);
    return result;
}

table table::without_lists() const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (std::ranges::none_of(rows_, [&](const auto& row) { return row[i].kind() == cell_kind::list; })) {
            places.push_back(i);
        }
    }
    return with_columns(places);
}

table table_of_list(const cell& list) {
    table data;
    for (const auto& item : nlohmann::ordered_json::parse(list.text())) {
        if (data.columns().empty()) {
            std::vector<std::string> names;
            for (const auto& member : item.items()) {
                names.push_back(member.key());
            }
            data = table(named_columns(names));
        }
        table_row_cells row;
        for (const auto& member : item.items()) {
            const auto& value = member.value();
            row.push_back(value.is_null() ? cell()
                                          : read_cell(value.is_string() ? value.get<std::string>() : value.dump()));
        }
        data.add_row(std::move(row));
    }
    return data;
}

table stacked(const std::vector<table>& parts) {
    if (parts.empty()) {
        throw std::logic_error("no table to stack");
    }
    table all(parts.front().columns());
    for (const table& part : parts) {
        all.append(part);
    }
    return all;
}

std::vector<table> stacked(const std::vector<std::vector<table>>& parts) {
    std::vector<table> all;
    for (const std::vector<table>& part : parts) {
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (k == all.size()) {
                all.emplace_back(part[k].columns());
            }
            all[k].append(part[k]);
        }
    }
    return all;
}

std::string to_csv(const table& data) {
    std::string out;
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        out += (i > 0 ? "," : "") + data.columns()[i].name;
    }
    out += '\n';
    for (const auto& row : data.rows()) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += (i > 0 ? "," : "") + written_cell(row[i].text());
        }
        out += '\n';
    }
    return out;
}

csv_stream::csv_stream(const std::string& path, const std::vector<column>& columns, std::vector<std::size_t> places)
    : path_(path), places_(std::move(places)), file_(path, std::ios::binary) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        file_ << (i > 0 ? "," : "") << columns[places_[i]].name;
    }
    file_ << '\n';
}

void csv_stream::add(const table_row_cells& row) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        file_ << (i > 0 ? "," : "") << written_cell(row[places_[i]].text());
    }
    file_ << '\n';
}

void csv_stream::finish() {
    file_.close();
    if (!file_) {
        throw std::runtime_error(path_ + " cannot be written");
    }
}

table from_csv(const std::string& text) {
    table data;
    std::size_t line = 1;
    for (std::size_t begin = 0; begin < text.size(); ++line) {
        std::size_t end = begin;
        split_record record;
        do {
            end = text.find('\n', end);
            if (end == std::string::npos) {
                throw std::runtime_error(fmt::format("line {} does not end", line));
            }
            record = split_cells(text.substr(begin, end - begin), separator::comma);
            ++end;
        } while (!record.closed);
        begin = end;
        if (data.columns().empty()) {
            data = table(named_columns(record.cells));
        } else if (record.cells.size() != data.columns().size()) {
            throw std::runtime_error(
                fmt::format("line {} has {} cells, not {}", line, record.cells.size(), data.columns().size()));
        } else {
            data.add_row(read_cells(record.cells));
        }
    }
    return data;
}

std::string to_json(const table& data) {
    auto out = nlohmann::ordered_json::array();
    for (const auto& row : data.rows()) {
        nlohmann::ordered_json object;
        for (std::size_t i = 0; i < row.size(); ++i) {
            auto& value = object[data.columns()[i].name];
            if (row[i].kind() == cell_kind::list) {
                value = nlohmann::ordered_json::parse(row[i].text());
            } else if (!row[i].is_empty()) {
                value = row[i].text();
            }
        }
        out.push_back(std::move(object));
    }
    return out.dump(2) + '\n';
}

std::string to_text(const table& data) {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        std::size_t width = data.columns()[i].name.size();
        for (const auto& row : data.rows()) {
            width = std::max(width, row[i].text().size());
        }
        widths.push_back(width);
    }
    std::string out;
    const auto line = [&](const auto& cell) {
        std::string text;
        for (std::size_t i = 0; i < widths.size(); ++i) {
            text += fmt::format("{:<{}}  ", cell(i), widths[i]);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out += text + '\n';
    };
    line([&](std::size_t i) { return data.columns()[i].name; });
    for (const auto& row : data.rows()) {
        line([&](std::size_t i) { return row[i].text(); });
    }
    return out;
}

void write_whole_file(const std::string& path, const std::string& content) {
    namespace fs = std::filesystem;
    std::error_code error;
    const std::string target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error).string() : path;
    if (fs::exists(target, error) && !fs::is_regular_file(target, error)) {
        write_through(target, content);
        return;
    }
    const std::string beside = fmt::format("{}.{}.part", target, ::getpid());
    try {
        write_through(beside, content);
        fs::rename(beside, target);
    } catch (const fs::filesystem_error& problem) {
        fs::remove(beside, error);
        throw std::runtime_error(problem.code().message());
    } catch (const std::runtime_error&) {
        fs::remove(beside, error);
        throw;
    }
}

void write_to_stdout(const std::string& content) {
    errno = 0;
    const bool written = std::fwrite(content.data(), 1, content.size(), stdout) == content.size();
    if (!written || std::fflush(stdout) != 0) {
        throw std::runtime_error(fmt::format("stdout cannot be written ({})", std::strerror(errno)));
    }
}

}  // namespace libration
