#include "table/table_order.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "option/options.hpp"
#include "run/provenance.hpp"
#include "table/table_formats.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

// The statements of a problem, a line each, without its comments.
std::vector<std::string> lines_of_problem(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) {
        if (const std::string statement = line.substr(0, line.find('#')); !trimmed(statement).empty()) {
            lines.push_back("    " + without_controls(statement, statement.size()));
        }
    }
    return lines;
}

std::vector<std::string> comment_lines(const table_order& order, const table& data, const std::string& command) {
    std::vector<std::string> lines{
        order.subject->title(), "Made by: " + without_controls(command, command.size()),
        fmt::format("{} significant digits, {}.", order.digits, order.subject->rigour()),
        fmt::format("Typed numbers that no decimal holds, such as T/8 or pi/3, stand with {} digits.",
                    order.digits + more_input_digits)};
    const auto statements = lines_of_problem(order.subject->text());
    lines.insert(lines.begin() + 1, statements.begin(), statements.end());
    std::string made_with;
    for (const auto& [name, version] : provenance()) {
        made_with += fmt::format("{}{} {}", made_with.empty() ? "" : ", ", name, version);
    }
    lines.push_back("Made with: " + made_with);
    lines.emplace_back("Columns:");
    for (const column& c : data.columns()) {
        lines.push_back("    " + c.name + (c.meaning.empty() ? "" : ": " + c.meaning));
    }
    return lines;
}

}  // namespace

std::string table_order::command() const {
    return fmt::format("libration table{}{} --digits {}", subject->words(), said.text(), digits);
}

table table_for(const table_order& order, const std::string& format, int jobs) {
    const input_style style = has_comments(format) ? input_style::decimals : input_style::typed;
    return order.subject->rows(order.said, order.digits, style, jobs);
}

bool has_comments(const std::string& format) { return is_program_format(format); }

std::string table_file(const table_order& order, const table& data, const std::string& format, const std::string& name,
                       const std::string& command) {
    if (!has_comments(format)) {
        return in_format(format, data);
    }
    return program_text(format, data, {name, comment_lines(order, data, command)});
}

std::string provenance_json(const table_order& order, const table& data, const std::string& command) {
    nlohmann::ordered_json description;
    description["command"] = command;
    for (const column& c : data.columns()) {
        description["columns"][c.name] = c.meaning;
    }
    description["rows"] = data.rows().size();
    description["digits"] = order.digits;
    description["rigour"] = order.subject->rigour();
    if (const std::string text = order.subject->text(); !text.empty()) {
        description["problem"] = text;
    }
    for (const auto& [name, version] : provenance()) {
        description["made with"][name] = version;
    }
    return description.dump(2) + '\n';
}

}  // namespace libration
