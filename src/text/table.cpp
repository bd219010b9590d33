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

namespace libration {

namespace {

// Quoted where CSV needs it.
std::string csv_cell(const std::string& cell) {
    if (cell.find_first_of(",\"\n") == std::string::npos) {
        return cell;
    }
    std::string quoted = "\"";
    for (const char c : cell) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
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

std::string to_csv(const table& data) {
    std::string out;
    for (std::size_t i = 0; i < data.columns.size(); ++i) {
        out += (i > 0 ? "," : "") + data.columns[i].name;
    }
    out += '\n';
    for (const auto& row : data.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += (i > 0 ? "," : "") + csv_cell(row[i]);
        }
        out += '\n';
    }
    return out;
}

table from_csv(const std::string& text) {
    table data;
    std::vector<std::string> cells{""};
    std::size_t line = 1;
    bool quoted = false;
    const auto finish_row = [&] {
        if (data.columns.empty()) {
            for (const std::string& name : cells) {
                data.columns.push_back({name, ""});
            }
        } else if (cells.size() != data.columns.size()) {
            throw std::runtime_error(
                fmt::format("line {} has {} cells, not {}", line, cells.size(), data.columns.size()));
        } else {
            data.rows.push_back(cells);
        }
        cells = {""};
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            // Within quotes a doubled quote is one.
            const bool doubled = quoted && i + 1 < text.size() && text[i + 1] == '"';
            cells.back() += doubled ? "\"" : "";
            quoted = doubled || !quoted;
            i += doubled ? 1 : 0;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else if (c == '\n' && !quoted) {
            finish_row();
            ++line;
        } else {
            cells.back() += c;
        }
    }
    if (quoted || cells.size() > 1 || !cells.back().empty()) {
        throw std::runtime_error(fmt::format("line {} does not end", line));
    }
    return data;
}

std::string to_json(const table& data) {
    auto out = nlohmann::ordered_json::array();
    for (const auto& row : data.rows) {
        nlohmann::ordered_json object;
        for (std::size_t i = 0; i < row.size(); ++i) {
            object[data.columns[i].name] = row[i];
        }
        out.push_back(std::move(object));
    }
    return out.dump(2) + '\n';
}

std::string to_text(const table& data) {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < data.columns.size(); ++i) {
        std::size_t width = data.columns[i].name.size();
        for (const auto& row : data.rows) {
            width = std::max(width, row[i].size());
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
    line([&](std::size_t i) { return data.columns[i].name; });
    for (const auto& row : data.rows) {
        line([&](std::size_t i) { return row[i]; });
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
