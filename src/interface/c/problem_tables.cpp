#include "problem_tables.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "guarded.hpp"
#include "libration/number/given_number.hpp"
#include "libration/problem/radius_answer.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/proved_digits.hpp"

namespace libration::c {

namespace {

// A column of the table, and those of the answer with its value and its uncertainty.
struct shown_column {
    std::string name, value, uncertainty = {};
};

std::size_t place_of(const answer& found, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(found.names, name) - found.names.begin());
}

void add_heuristic(libration_table& table, const answer_value& value, const std::string& uncertainty) {
    if (value.text.empty() || value.kind == value_kind::text || value.kind == value_kind::list) {
        table.add(value.text);
    } else if (value.kind == value_kind::whole_number) {
        table.add(typed_number(value.text));
    } else {
        table.add(libration_number{value.text, uncertainty, LIBRATION_HEURISTIC});
    }
}

// The decimal of a proved number of which no digit is proved is 0.
libration_number part_of_position(const answer_value& value, int rigour) {
    if (rigour == LIBRATION_PROVED && !has_a_digit({value.text, value.bound})) {
        const ball size = abs(from_rational<ball>(read_exact(value.text).coefficient));
        return proved_number({"0", upper_bound_text(size + from_rational<ball>(read_exact(value.bound).coefficient))});
    }
    return {value.text, value.bound, rigour};
}

}  // namespace

libration_table table_of_radii(const answer& found, const std::string& usual) {
    static const std::vector<shown_column> columns{{"radius", "radius", "uncertainty"},
                                                   {"position_re", "position_re", "uncertainty"},
                                                   {"position_im", "position_im", "uncertainty"},
                                                   {"exponent", "exponent", "exponent_uncertainty"},
                                                   {"kind", "kind"},
                                                   {"count", "count"},
                                                   {"note", "note"},
                                                   {"bound", "bound"},
                                                   {"gevrey", "gevrey"},
                                                   {"action", "action"},
                                                   {"suspect", "suspect"},
                                                   {"history", "history"},
                                                   {"ring", "ring"},
                                                   {"amplitude", "amplitude", "amplitude_uncertainty"},
                                                   {"fits", "fits"},
                                                   {"predictions", "predictions"}};
    libration_table table{{"method", "unknown"}, {}};
    std::ranges::transform(columns, std::back_inserter(table.names), &shown_column::name);
    const std::size_t unknown = place_of(found, "unknown");
    const auto unknown_of = [&](const auto& row) { return unknown < row.size() ? row[unknown].text : usual; };
    const auto& verdict = found.rows.front();
    for (const auto& row : found.rows) {
        // The verdict of several unknowns is in the answer once more, among the rows of its unknown.
        if (&row != &verdict && row[0].text == verdict[0].text && unknown_of(row) == unknown_of(verdict)) {
            continue;
        }
        table.add(row[0].text);
        table.add(unknown_of(row));
        for (const shown_column& each : columns) {
            const std::size_t uncertainty = place_of(found, each.uncertainty);
            add_heuristic(table, row[place_of(found, each.value)],
                          uncertainty < row.size() ? row[uncertainty].text : "");
        }
    }
    return table;
}

libration_table table_of_singularities(const answer& found, int rigour) {
    static const std::vector<std::string> columns{"position_re", "position_im", "modulus", "kind",
                                                  "exponent_re", "exponent_im", "unknown"};
    constexpr std::size_t in_position = 3;
    libration_table table{columns, {}};
    for (const auto& row : found.rows) {
        if (rigour == LIBRATION_PROVED && row[place_of(found, "rigour")].text != "proved") {
            throw error(error_kind::undecided, "singularity", row[0].text,
                        "is " + row[place_of(found, "evidence")].text);
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const answer_value& value = row[place_of(found, columns[i])];
            if (i < in_position) {
                table.add(part_of_position(value, rigour));
            } else {
                add_heuristic(table, value, "");
            }
        }
    }
    return table;
}

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_list_radius(const char* coefficients, long digits, libration_table** tests) {
    return made(tests, [&] {
        std::vector<exact> written;
        std::vector<mpfr> values;
        const precision_scope scope(given_digits(digits) + convergence::radius_guard_digits);
        for (const std::string& item : items_of(text_of(coefficients, "coefficients"), "coefficients")) {
            written.push_back(given_number("coefficient", item));
            values.push_back(from_exact<mpfr>(written.back()));
        }
        const convergence::listed_series list{series::power_series<mpfr>(std::move(values)), std::move(written)};
        return table_of_radii(radius_answer({{"", {{list}, 1}}}, std::nullopt, rounded_digits(digits)), "");
    });
}
