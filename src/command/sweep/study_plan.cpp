#include "sweep/study_plan.hpp"

#include <stdexcept>

namespace libration {

cell_rows rows_of(const std::vector<table>& tables) {
    cell_rows rows;
    rows.reserve(tables.size());
    for (const table& each : tables) {
        rows.push_back(each.rows());
    }
    return rows;
}

study_plan plan_of_cells(std::vector<study_table> tables, std::vector<std::string> axes, std::size_t cells,
                         std::function<cell_inputs(std::size_t)> inputs,
                         std::function<std::vector<table>(std::size_t)> rows) {
    const auto group = [inputs = std::move(inputs), rows = std::move(rows)](std::size_t i) {
        return cell_group{{inputs(i)}, [rows, i](const std::vector<std::size_t>& /*the only one*/) {
                              return std::vector<cell_rows>{rows_of(rows(i))};
                          }};
    };
    return {std::move(tables), std::move(axes), cells, group, {}, {}};
}

cell_inputs with_input(cell_inputs inputs, std::string axis, std::string words) {
    inputs.push_back({std::move(axis), std::move(words)});
    return inputs;
}

std::vector<cell_rows> equal_parts(const std::vector<table>& tables, std::size_t count) {
    std::vector<cell_rows> parts(count);
    for (const table& each : tables) {
        const std::size_t size = each.rows().size() / count;
        if (size * count != each.rows().size()) {
            throw std::logic_error("the cells of a study have different numbers of rows");
        }
        for (std::size_t i = 0; i < count; ++i) {
            const auto first = each.rows().begin() + static_cast<std::ptrdiff_t>(i * size);
            parts[i].emplace_back(first, first + static_cast<std::ptrdiff_t>(size));
        }
    }
    return parts;
}

}  // namespace libration
