#include "handles.hpp"

namespace {

const libration_table::cell* cell_of(const libration_table* table, size_t row, size_t column) {
    const bool there =
        table != nullptr && column < table->names.size() && row < table->cells.size() / table->names.size();
    return there ? &table->cells[row * table->names.size() + column] : nullptr;
}

}  // namespace

size_t libration_table_rows(const libration_table* table) {
    return table == nullptr || table->names.empty() ? 0 : table->cells.size() / table->names.size();
}

size_t libration_table_columns(const libration_table* table) { return table == nullptr ? 0 : table->names.size(); }

const char* libration_table_name(const libration_table* table, size_t column) {
    return column < libration_table_columns(table) ? table->names[column].c_str() : "";
}

const char* libration_table_text(const libration_table* table, size_t row, size_t column) {
    const auto* const cell = cell_of(table, row, column);
    return cell == nullptr ? "" : cell->number.decimal.c_str();
}

const libration_number* libration_table_number(const libration_table* table, size_t row, size_t column) {
    const auto* const cell = cell_of(table, row, column);
    return cell != nullptr && cell->is_number ? &cell->number : nullptr;
}

void libration_table_free(libration_table* table) { delete table; }
