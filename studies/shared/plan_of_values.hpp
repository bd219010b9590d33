// Plans whose cells share work along one axis, as the orders of one series do, and the orders that a study accepts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sweep/study.hpp"
#include "text/input_error.hpp"

namespace libration::studies {

inline std::string input_words(int order) { return std::to_string(order); }
inline std::string input_words(const exact& value) { return value.text; }

/// A cell for each of these values of the last axis, for each of `groups` groups with the inputs(i); the cells of a
/// group are computed together: rows(i, values) returns one table for each table of the plan, with the same number of
/// rows for each value, one value after the other.
template <class Value, class Inputs, class Rows>
study_plan plan_of_values(std::vector<study_table> tables, std::vector<std::string> axes, std::size_t groups,
                          const Inputs& inputs, const std::vector<Value>& values, const Rows& rows) {
    const auto group = [axis = axes.back(), inputs, values, rows](std::size_t i) {
        cell_group cells;
        cells.cells.reserve(values.size());
        for (const Value& value : values) {
            cells.cells.push_back(with_input(inputs(i), axis, input_words(value)));
        }
        cells.compute = [values, rows, i](const std::vector<std::size_t>& which) {
            std::vector<Value> chosen;
            chosen.reserve(which.size());
            for (const std::size_t each : which) {
                chosen.push_back(values[each]);
            }
            return equal_parts(rows(i, chosen), which.size());
        };
        return cells;
    };
    return {std::move(tables), std::move(axes), groups, group, {}, {}};
}

/// The orders in increasing order. Throws input_error with the reason `is` if one is below `least`.
inline std::vector<int> orders_from(const study_request& request, int least, const std::string& is) {
    std::vector<int> orders = request.orders();
    std::ranges::sort(orders);
    if (orders.front() < least) {
        throw input_error("--orders", std::to_string(orders.front()), is,
                          "write orders from " + std::to_string(least) + " on");
    }
    return orders;
}

/// The orders of a study that counts coefficients. Throws input_error for 0.
inline std::vector<int> numbers_of_coefficients(const study_request& request) {
    std::vector<int> counts = request.orders();
    for (const int count : counts) {
        if (count < 1) {
            throw input_error("--orders", std::to_string(count), "is not a number of coefficients", "write 1 or more");
        }
    }
    return counts;
}

}  // namespace libration::studies
