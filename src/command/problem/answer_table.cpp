#include "answer_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace libration {

namespace {

cell cell_of(const answer_value& value) {
    switch (value.kind) {
        case value_kind::number: return number_cell(value.text);
        case value_kind::whole_number: return cell(integer(value.text));
        case value_kind::list: return cell::list(value.text);
        case value_kind::text: break;
    }
    return cell(value.text);
}

bool is_uncertain(const answer_value& value) { return value.kind == value_kind::number && !value.bound.empty(); }

// The columns whose uncertainty is a further one: none if the answer has such a column itself.
std::vector<std::size_t> uncertain_columns(const answer& found) {
    std::vector<std::size_t> columns;
    if (std::ranges::find(found.names, "uncertainty") != found.names.end()) {
        return columns;
    }
    for (std::size_t i = 0; i < found.names.size(); ++i) {
        if (std::ranges::any_of(found.rows, [&](const auto& row) { return !row.empty() && is_uncertain(row[i]); })) {
            columns.push_back(i);
        }
    }
    return columns;
}

}  // namespace

table table_of(const answer& found, const column_labels& labels) {
    const auto uncertain = uncertain_columns(found);
    const std::size_t numbers = uncertain.empty() ? found.names.size() : uncertain.back() + 1;
    std::vector<column> columns;
    const auto add = [&](const std::string& name) {
        const auto label = labels.find(name);
        columns.push_back(label == labels.end() ? column{name, ""} : label->second);
    };
    std::for_each_n(found.names.begin(), numbers, add);
    for (const std::size_t i : uncertain) {
        add(found.names[i] + "_uncertainty");
    }
    std::for_each(found.names.begin() + static_cast<std::ptrdiff_t>(numbers), found.names.end(), add);
    table data(std::move(columns));
    for (const auto& values : found.rows) {
        table_row_cells row;
        std::for_each_n(values.begin(), numbers, [&](const answer_value& each) { row.push_back(cell_of(each)); });
        for (const std::size_t i : uncertain) {
            row.push_back(number_cell(values[i].bound));
        }
        std::for_each(values.begin() + static_cast<std::ptrdiff_t>(numbers), values.end(),
                      [&](const answer_value& each) { row.push_back(cell_of(each)); });
        data.add_row(std::move(row));
    }
    return data;
}

std::string lines_of_notes(const answer& found) {
    std::string lines;
    for (const answer_note& each : found.notes) {
        lines += fmt::format("{:<14}{}\n", each.name, each.text);
    }
    return lines;
}

}  // namespace libration
