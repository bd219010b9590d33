#include "solution_table.hpp"
#include "text/members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace libration {

namespace {

bool is_undecided(const answer_value& value) { return value.text.empty(); }

// |y| < 1.2e-60, or that the time is not reached.
std::string undecided_text(const std::string& name, const answer_value& value) {
    return value.bound.empty() ? name + " is not reached" : fmt::format("|{}| < {}", name, value.bound);
}

}  // namespace

bool has_undecided(const answer& found) {
    return std::ranges::any_of(found.rows, [](const auto& row) { return std::ranges::any_of(row, is_undecided); });
}

std::string bounds_of(const answer& found, const std::vector<answer_value>& row) {
    std::string bounds;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (is_undecided(row[i])) {
            bounds += (bounds.empty() ? "" : "; ") + undecided_text(found.names[i], row[i]);
        }
    }
    return bounds;
}

namespace {

constexpr std::size_t least_width = 9;  // of the names before the values

std::string line_of(const std::string& name, const std::string& value, std::size_t width = least_width) {
    return value.empty() ? "" : fmt::format("{:<{}} {}\n", name, width, value);
}

// The width of all names, so that their values are aligned.
std::size_t width_of(const std::vector<std::string>& names) {
    std::size_t width = least_width;
    for (const std::string& name : names) {
        width = std::max(width, name.size());
    }
    return width;
}

std::string lines_of(const shared_cells::list& cells) {
    std::string text;
    for (const auto& [name, value] : cells) {
        text += line_of(name, value.text());
    }
    return text;
}

std::vector<column> columns_of_answer(const answer& found, const shared_cells& shared) {
    std::vector<column> columns;
    const auto add = [&](const shared_cells::list& cells) {
        for (const auto& each : cells) {
            columns.push_back({each.first, ""});
        }
    };
    add(shared.before_time);
    columns.push_back({"time", ""});
    for (const std::string& name : found.names) {
        columns.push_back({name, ""});
    }
    add(shared.behind_values);
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}});
    add(shared.behind_rigour);
    columns.push_back({"time_typed", ""});
    add(shared.behind_time);
    if (!found.drifts.empty()) {
        columns.push_back({"invariant_drift", ""});
    }
    if (has_undecided(found)) {
        columns.push_back({"undecided", ""});
    }
    return columns;
}

std::string paragraph_of(const answer& found, const std::vector<answer_value>& row, const std::string& time = {}) {
    const std::size_t width = width_of(found.names);
    std::string text = line_of("time", time, width);
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string& name = found.names[i];
        text += line_of(name, is_undecided(row[i]) ? undecided_text(name, row[i]) : row[i].text, width);
    }
    return text;
}

void add_numbers(table_row_cells& row, const std::vector<answer_value>& values, long digits) {
    for (const answer_value& value : values) {
        row.push_back(value.text.empty() ? cell() : cell::number(value.text, digits));
    }
}

// Each once.
void add_notes(partial_table& to, const partial_table& from) {
    for (const answer_note& each : from.notes) {
        if (std::ranges::find(to.notes, each.text, &answer_note::text) == to.notes.end()) {
            to.notes.push_back(each);
        }
    }
}

void add_paragraph(std::string& text, const std::string& paragraph) { text += (text.empty() ? "" : "\n") + paragraph; }

}  // namespace

void require_complete(const partial_table& of) {
    for (const answer_note& each : of.notes) {
        fmt::print(stderr, "libration: {}\n", each.text);
    }
    if (of.missing) {
        throw error(*of.missing);
    }
}

partial_table states_table(const answer& found, const std::vector<exact>& times,
                           const std::vector<std::string>& decimals, long digits, const shared_cells& shared) {
    const bool undecided = has_undecided(found);
    const auto columns = columns_of_answer(found, shared);
    partial_table result{table(columns),
                         lines_of(shared.before_time) + lines_of(shared.behind_values),
                         "",
                         found.missing,
                         found.collocation,
                         found.notes};
    if (!result.heading.empty()) {
        result.heading += line_of("digits", std::to_string(digits)) + line_of("rigour", found.rigour) +
                          lines_of(shared.behind_rigour);
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (found.rows[i].empty()) {
            continue;
        }
        table_row_cells row;
        const auto add = [&](const shared_cells::list& cells) {
            for (const auto& each : cells) {
                row.push_back(each.second);
            }
        };
        add(shared.before_time);
        row.push_back(number_cell(decimals[i]));
        add_numbers(row, found.rows[i], digits);
        add(shared.behind_values);
        row.insert(row.end(), {digits, found.rigour});
        add(shared.behind_rigour);
        row.emplace_back(times[i].text);
        add(shared.behind_time);
        if (!found.drifts.empty()) {
            row.push_back(found.drifts[i].empty() ? cell() : cell::number(found.drifts[i], digits_of_drift));
        }
        if (undecided) {
            row.emplace_back(bounds_of(found, found.rows[i]));
        }
        result.rows.add_row(std::move(row));
        add_paragraph(result.text, paragraph_of(found, found.rows[i], decimals[i]));
    }
    return result;
}

partial_table states_table(const solution& of, const std::vector<exact>& times, const request& how,
                           const shared_cells& shared) {
    const long digits = how.printed_digits();
    return states_table(of.states(times, how), times, of.times_in_decimals(times, digits), digits, shared);
}

partial_table events_table(const answer& found, long digits) {
    std::vector<column> columns;
    for (const std::string& name : found.names) {
        columns.push_back({name, ""});
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}, {"count", ""}});
    const bool undecided = has_undecided(found);
    if (undecided) {
        columns.push_back({"undecided", ""});
    }
    partial_table result{table(std::move(columns)), "", "", found.missing, found.collocation, found.notes};
    long count = 0;
    for (const auto& event : found.rows) {
        table_row_cells row;
        add_numbers(row, event, digits);
        row.insert(row.end(), {digits, found.rigour, ++count});
        if (undecided) {
            row.emplace_back(bounds_of(found, event));
        }
        result.rows.add_row(std::move(row));
        add_paragraph(result.text, paragraph_of(found, event));
    }
    return result;
}

std::string lines_of_states(const table& data) {
    const std::size_t width = width_of(members_of(data.columns(), &column::name));
    std::string text;
    for (const auto& row : data.rows()) {
        text += text.empty() ? "" : "\n";
        for (std::size_t i = 0; i + 3 < row.size(); ++i) {
            text += fmt::format("{:<{}} {}\n", data.columns()[i].name, width, row[i].text());
        }
    }
    return text;
}

namespace {

// The columns of the first table that all of them have.
std::vector<std::string> common_columns(const std::vector<partial_table>& parts) {
    auto names = members_of(parts.front().rows.columns(), &column::name);
    for (const partial_table& part : parts) {
        const auto own = members_of(part.rows.columns(), &column::name);
        std::erase_if(names, [&](const std::string& name) { return std::ranges::find(own, name) == own.end(); });
    }
    return names;
}

}  // namespace

partial_table family_table(const std::vector<family_member>& family, const std::vector<partial_table>& parts) {
    const auto names = common_columns(parts);
    std::vector<column> columns;
    for (const auto& [name, value] : family.front().values) {
        columns.push_back({name, ""});
    }
    for (const std::string& name : names) {
        columns.push_back({name, ""});
    }
    partial_table all{table(std::move(columns)), "", "", {}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto own = members_of(parts[i].rows.columns(), &column::name);
        for (const auto& row : parts[i].rows.rows()) {
            table_row_cells cells;
            for (const auto& [name, value] : family[i].values) {
                cells.push_back(number_cell(value));
            }
            for (const std::string& name : names) {
                cells.push_back(row[static_cast<std::size_t>(std::ranges::find(own, name) - own.begin())]);
            }
            all.rows.add_row(std::move(cells));
        }
        all.missing = all.missing ? all.missing : parts[i].missing;
        all.collocation.insert(all.collocation.end(), parts[i].collocation.begin(), parts[i].collocation.end());
        add_notes(all, parts[i]);
    }
    all.text = lines_of_states(all.rows);
    return all;
}

partial_table stacked_states(const std::vector<partial_table>& parts) {
    partial_table all{table(parts.front().rows.columns()), "", "", {}};
    const std::string* heading = &all.heading;
    for (const partial_table& part : parts) {
        all.rows.append(part.rows);
        if (part.heading != *heading) {
            all.text += (all.text.empty() ? "" : "\n") + part.heading;
        }
        heading = &part.heading;
        all.text += (all.text.empty() || part.text.empty() ? "" : "\n") + part.text;
        all.missing = all.missing ? all.missing : part.missing;
        all.collocation.insert(all.collocation.end(), part.collocation.begin(), part.collocation.end());
        add_notes(all, part);
    }
    return all;
}

}  // namespace libration
