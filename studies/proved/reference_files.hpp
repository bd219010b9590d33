// The published reference values: a CSV and a text file per test problem, all of them for C, Julia and Python, and a page
// about them.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "reference_languages.hpp"
#include "sweep/study.hpp"
#include "test_problems.hpp"

namespace libration::studies::proved {

inline constexpr const char* dedication =
    "To the extent possible under law, the authors of Libration have dedicated these data to the public domain:\n"
    "CC0 1.0 Universal, https://creativecommons.org/publicdomain/zero/1.0/\n";

inline std::size_t place_of_column(const table& data, const std::string& name) {
    const auto found = std::ranges::find(data.columns(), name, &column::name);
    return static_cast<std::size_t>(found - data.columns().begin());
}

/// The rows of one problem, without its name.
inline table rows_of_problem(const table& all, const std::string& problem) {
    const std::size_t place = place_of_column(all, "problem");
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < all.columns().size(); ++i) {
        if (i != place) {
            others.push_back(i);
        }
    }
    table own(all.columns());
    for (const table_row_cells& row : all.rows()) {
        if (row[place].text() == problem) {
            own.add_row(row);
        }
    }
    return own.with_columns(others);
}

/// The problem as comments: its text in the catalogue, and the changes to it.
inline std::string problem_as_comments(const test_problem& of) {
    std::string text;
    std::istringstream lines{std::string(problem_text(of.catalogue))};
    for (std::string line; std::getline(lines, line);) {
        text += line.starts_with('#') ? line + "\n" : "#     " + line + "\n";
    }
    for (const std::string& each : of.changes) {
        text += "# changed:  " + each + "\n";
    }
    return text;
}

/// The values of a problem from its rows, in which the unknowns of one time follow each other.
inline value_grid grid_of(const std::string& problem, const table& values) {
    const std::size_t time = place_of_column(values, "time");
    const std::size_t unknown = place_of_column(values, "unknown");
    const std::size_t value = place_of_column(values, "value");
    value_grid grid{problem, {}, {}, {}};
    for (const table_row_cells& row : values.rows()) {
        if (grid.times.empty() || row[time].text() != grid.times.back()) {
            grid.times.push_back(row[time].text());
            grid.values.emplace_back();
        }
        if (grid.times.size() == 1) {
            grid.unknowns.push_back(row[unknown].text());
        }
        grid.values.back().push_back(row[value].text());
    }
    return grid;
}

/// NAME.txt: comments, then one row per time: the time, and the values of all unknowns in their order.
inline std::string text_of_problem(const test_problem& of, const value_grid& grid, const table& invariants) {
    std::string text = problem_as_comments(of);
    for (const table_row_cells& row : invariants.rows()) {
        text += fmt::format("# {} = {}\n", row[0].text(), row[1].text());
    }
    text += fmt::format(
        "# Each digit is proved to one unit in the last place. The data are in the public domain (CC0 1.0).\n# time "
        "{}\n",
        fmt::join(grid.unknowns, " "));
    for (std::size_t i = 0; i < grid.times.size(); ++i) {
        text += fmt::format("{} {}\n", grid.times[i], fmt::join(grid.values[i], " "));
    }
    return text;
}

/// README.md of the directory.
inline std::string page_of(const std::vector<test_problem>& problems, const table& values) {
    std::string page = fmt::format(
        "# Reference values of {} test problems\n\n"
        "Made by `./run study reference_problems --out results`: do not edit. For each problem NAME.csv and NAME.txt "
        "hold its\nsolution at {} times, or {} if it is stiff, every digit proved to one unit in the last place; "
        "[reference_problems.h](reference_problems.h),\n[.jl](reference_problems.jl) and [.py](reference_problems.py) "
        "hold all of them for C, Julia and Python. What the columns mean,\nand programs that read them, are in "
        "[docs/reference_problems.md](../../docs/reference_problems.md).\n\n{}\n"
        "| problem | set | up to | lost digits |\n| --- | --- | --- | --- |\n",
        problems.size(), times_of_each, times_of_stiff, dedication);
    const std::size_t name = place_of_column(values, "problem");
    const std::size_t start = place_of_column(values, "condition_start");
    const std::size_t parameters = place_of_column(values, "condition_parameters");
    for (const test_problem& each : problems) {
        double largest = 1;
        for (const table_row_cells& row : values.rows()) {
            if (row[name].text() == each.name && !row[start].text().empty() && row[start].text() != "inf") {
                largest = std::max({largest, std::stod(row[start].text()), std::stod(row[parameters].text())});
            }
        }
        page += fmt::format("| [{0}]({0}.csv), [text]({0}.txt) | {1} | {2} | {3} |\n", each.name,
                            fmt::format("{}", fmt::join(each.changes, "; ")), each.end,
                            each.is_stiff() ? "" : fmt::format("{:.0f}", std::ceil(std::log10(largest))));
    }
    page +=
        "\n`lost digits` is the logarithm of the largest condition number, with respect to the start or to the "
        "parameters, over\nall unknowns and times, rounded up: an integrator in double cannot be blamed for losing so "
        "many of 16. It is not\ncomputed for stiff problems over long times.\n";
    return page;
}

/// All of these files for the problems in the tables.
inline std::vector<text_file> reference_files(const std::vector<study_table>& tables) {
    const table& values = tables.at(0).data;
    const table& invariants = tables.at(1).data;
    const std::size_t name = place_of_column(values, "problem");
    std::vector<test_problem> problems = test_problems();
    std::erase_if(problems, [&](const test_problem& each) {
        return std::ranges::none_of(values.rows(),
                                    [&](const table_row_cells& row) { return row[name].text() == each.name; });
    });
    std::vector<text_file> files{{"README.md", page_of(problems, values)}, {"LICENSE", dedication}};
    std::vector<value_grid> grids;
    for (const test_problem& each : problems) {
        const table own = rows_of_problem(values, each.name);
        grids.push_back(grid_of(each.name, own));
        files.push_back({each.name + ".csv", to_csv(own)});
        files.push_back(
            {each.name + ".txt", text_of_problem(each, grids.back(), rows_of_problem(invariants, each.name))});
    }
    for (const reference_language& each : reference_languages) {
        files.push_back({std::string(each.file), text_in(each, grids)});
    }
    return files;
}

}  // namespace libration::studies::proved
