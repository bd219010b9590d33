#include "sweep/study_plan.hpp"

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

}  // namespace libration
