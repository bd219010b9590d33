#include "table/table_order.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "equation/problem_trajectory.hpp"
#include "option/options.hpp"
#include "run/provenance.hpp"
#include "table/function_table.hpp"
#include "table/motion_table.hpp"
#include "table/table_formats.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr const char* motions = "pendulum";
constexpr std::array<const char*, 8> motion_names{"--energies",  "--gaps",   "--theta0",  "--omega0",
                                                  "--direction", "--length", "--gravity", "--times"};
constexpr std::array<const char*, 9> argument_names{"--u", "--phi", "--x", "--z", "--n", "--k", "--m", "--m1", "--q"};

constexpr const char* rigour = "proved to one unit in the last place";

// The description of the contents of a table.
std::string title_of(const table_order& order) {
    if (order.problem) {
        return "Reference values of the solution of";
    }
    return order.what == motions ? "Reference values of the pendulum theta'' + sin theta = 0."
                                 : "Reference values of the elliptic functions " + order.what + ".";
}

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

std::string rigour_of(const table_order& order) {
    return order.problem && order.problem->solution->closed_form().empty() ? rigour_of_problems : rigour;
}

std::vector<std::string> comment_lines(const table_order& order, const table& data, const std::string& command) {
    std::vector<std::string> lines{
        title_of(order), "Made by: " + without_controls(command, command.size()),
        fmt::format("{} significant digits, {}.", order.digits, rigour_of(order)),
        fmt::format("Typed numbers that no decimal holds, such as T/8 or pi/3, stand with {} digits.",
                    order.digits + more_input_digits)};
    if (order.problem) {
        const auto statements = lines_of_problem(order.problem->text);
        lines.insert(lines.begin() + 1, statements.begin(), statements.end());
    }
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
    return fmt::format("libration table{}{} --digits {}", problem ? problem->words : " " + what, said.text(), digits);
}

void require_own_options(const table_order& order) {
    const auto refuse = [&](const auto& names) {
        for (const char* const option : names) {
            if (order.said[option]) {
                throw input_error(option, *order.said[option],
                                  "has no meaning for the table " + (order.problem ? "of a problem" : order.what),
                                  "leave it out");
            }
        }
    };
    if (order.problem) {
        refuse(argument_names);
        refuse(std::to_array<const char*>({"--energies", "--gaps", "--theta0", "--omega0", "--direction", "--length",
                                           "--gravity", "--points", "--columns"}));
    } else if (order.what == motions) {
        refuse(argument_names);
    } else {
        refuse(motion_names);
    }
}

table table_for(const table_order& order, const std::string& format, int jobs) {
    const input_style style = has_comments(format) ? input_style::decimals : input_style::typed;
    if (order.problem) {
        if (!order.said["--times"]) {
            throw input_error("no --times are given: add --times such as 0,1.5,sqrt(2) or 0:20:201");
        }
        return problem_table(*order.problem, times_of_problem(*order.said["--times"]), order.digits, style);
    }
    return order.what == motions ? motion_table(order.said, order.digits, style, jobs)
                                 : function_table(functions_of(order.what), order.said, order.digits, style, jobs);
}

bool has_comments(const std::string& format) { return writer_of(format) != nullptr; }

std::string table_file(const table_order& order, const table& data, const std::string& format, const std::string& name,
                       const std::string& command) {
    if (!has_comments(format)) {
        return in_format(format, data);
    }
    return writer_of(format)(data, {name, comment_lines(order, data, command)});
}

std::string provenance_json(const table_order& order, const table& data, const std::string& command) {
    nlohmann::ordered_json description;
    description["command"] = command;
    for (const column& c : data.columns()) {
        description["columns"][c.name] = c.meaning;
    }
    description["rows"] = data.rows().size();
    description["digits"] = order.digits;
    description["rigour"] = rigour_of(order);
    if (order.problem) {
        description["problem"] = order.problem->text;
    }
    for (const auto& [name, version] : provenance()) {
        description["made with"][name] = version;
    }
    return description.dump(2) + '\n';
}

}  // namespace libration
