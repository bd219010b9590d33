#include "cell_text.hpp"

#include "counted_text.hpp"

namespace libration {

namespace {

// A text is a sequence of numbers, each ended by a colon, and of strings, which their length precedes:
//   TABLES: { ROWS: { CELLS: { KIND DIGITS: LENGTH: TEXT } } }

void add_cell(std::string& text, const cell& each) {
    add_number(text, static_cast<long>(each.kind()));
    if (each.kind() == cell_kind::number) {
        add_number(text, each.digits());
    }
    if (!each.is_empty()) {
        add_string(text, each.text());
    }
}

cell next_cell(counted_text& rest) {
    switch (static_cast<cell_kind>(rest.number())) {
        case cell_kind::empty: return {};
        case cell_kind::text: return {rest.string()};
        case cell_kind::whole: return {integer(rest.string())};
        case cell_kind::list: return cell::list(rest.string());
        case cell_kind::number: {
            const long digits = rest.number();
            return cell::number(rest.string(), digits);
        }
    }
    counted_text::refuse();
}

}  // namespace

std::string to_cell_text(const cell_rows& rows) {
    std::string text;
    add_number(text, static_cast<long>(rows.size()));
    for (const auto& of_table : rows) {
        add_number(text, static_cast<long>(of_table.size()));
        for (const table_row_cells& row : of_table) {
            add_number(text, static_cast<long>(row.size()));
            for (const cell& each : row) {
                add_cell(text, each);
            }
        }
    }
    return text;
}

cell_rows rows_from(std::string_view text) {
    counted_text reader(text);
    cell_rows rows(reader.count());
    for (auto& of_table : rows) {
        of_table.resize(reader.count());
        for (table_row_cells& row : of_table) {
            const std::size_t cells = reader.count();
            row.reserve(cells);
            for (std::size_t i = 0; i < cells; ++i) {
                row.push_back(next_cell(reader));
            }
        }
    }
    reader.require_end();
    return rows;
}

}  // namespace libration
