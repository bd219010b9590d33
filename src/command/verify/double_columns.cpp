#include "verify/double_columns.hpp"

#include <algorithm>
#include <iterator>

#include "libration/scalar/error.hpp"
#include "libration/verification/double_decimals.hpp"

namespace libration {

std::vector<bool> double_columns(const std::vector<csv_record>& records, separator between,
                                 const std::vector<compared_column>& compared) {
    std::vector<double_decimals> columns(compared.size());
    for (const csv_record& record : records) {
        const auto cells = split_cells(record.text, between).cells;
        for (std::size_t i = 0; i < compared.size(); ++i) {
            if (compared[i].at >= cells.size()) {
                continue;
            }
            try {
                columns[i].add(trimmed(cells[compared[i].at]));
            } catch (const error&) {  // the row is malformed
                continue;
            }
        }
    }
    std::vector<bool> recognised;
    std::ranges::transform(columns, std::back_inserter(recognised),
                           [](const double_decimals& each) { return each.recognised(); });
    return recognised;
}

bool are_double_columns(const std::vector<csv_record>& records, separator between,
                        const std::vector<std::size_t>& places) {
    std::vector<double_decimals> columns(places.size());
    for (const csv_record& record : records) {
        const auto cells = split_cells(record.text, between).cells;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i] >= cells.size()) {
                return false;
            }
            try {
                columns[i].add(trimmed(cells[places[i]]));
            } catch (const error&) {
                return false;
            }
        }
    }
    return std::ranges::any_of(columns, &double_decimals::recognised) &&
           std::ranges::all_of(columns, [](const double_decimals& each) { return each.recognised() || each.exact(); });
}

}  // namespace libration
