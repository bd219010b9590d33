#include "verify/verify_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "libration/scalar/error.hpp"
#include "text/csv_records.hpp"
#include "text/quotation.hpp"

namespace libration {

std::vector<std::string> added_columns(const std::vector<compared_column>& compared) {
    std::vector<std::string> names{"reference", "error", "correct_digits", "verdict", "condition"};
    for (std::size_t i = 1; i < compared.size(); ++i) {
        for (const char* const name : {"_reference", "_error", "_correct_digits"}) {
            names.push_back(compared[i].name + name);
        }
    }
    return names;
}

bool is_worse(const std::optional<long>& tenths, const mpfr& of_tolerance, const std::optional<long>& other_tenths,
              const mpfr& other_of_tolerance) {
    constexpr long all = std::numeric_limits<long>::max();
    const long here = tenths.value_or(all);
    const long other = other_tenths.value_or(all);
    return here < other || (here == other && of_tolerance > other_of_tolerance);
}

compared_row row_comparer::operator()(const csv_record& record) {
    const split_record split = split_cells(record.text, writer_.between());
    const std::size_t count = names_.count();
    if (!split.closed) {
        const std::size_t at = split.cells.size() - 1;
        return without_values(
            row_verdict::malformed, record, {record.text},
            (at < count ? quotation(names_.own(at)) + ": " : std::string()) + "a quote is not closed");
    }
    if (split.cells.size() != count) {
        return without_values(row_verdict::malformed, record, split.cells,
                              fmt::format("has {} cells, the header has {}", split.cells.size(), count));
    }
    try {
        return row_of(record, split.cells, compared(split.cells));
    } catch (const error& problem) {  // what cannot be read, motions that there are not, and what cannot be proved
        const bool undecided = problem.kind() == error_kind::undecided;
        return without_values(undecided ? row_verdict::undecided : row_verdict::malformed, record, split.cells,
                              message_of(problem));
    }
}

compared_row row_comparer::without_values(row_verdict verdict, const csv_record& record, std::vector<std::string> cells,
                                          const std::string& reason) const {
    cells.resize(names_.count());
    std::vector<std::string> added(added_columns(reader_->columns()).size());
    added[3] = verdict == row_verdict::undecided ? "undecided" : "malformed";
    compared_row row;
    row.verdict = verdict;
    row.line = record.line;
    row.text = writer_.row({record.line, ""}, cells, added);
    row.reason = reason;
    return row;
}

compared_values row_comparer::compared(const std::vector<std::string>& cells) {
    const auto& columns = reader_->columns();
    std::vector<written_value> values;
    values.reserve(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        values.push_back({trimmed(cells[columns[i].at]), own_name(i), of_doubles_[i]});
    }
    require_numbers(values, rules_);
    return compare_row(values, reader_->read(cells), rules_);
}

compared_row row_comparer::row_of(const csv_record& record, const std::vector<std::string>& cells,
                                  const compared_values& here) const {
    std::vector<std::string> added;
    compared_row row;
    row.line = record.line;
    row.verdict = row_verdict::ok;
    row.proved = here.proved;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < here.values.size(); ++i) {
        const comparison& value = here.values[i];
        added.insert(added.end(), {value.reference, value.error, correct_digits_text(value.tenths_of_digits)});
        if (i == 0) {
            added.insert(added.end(), {"", here.condition});
        }
        const comparison& before = here.values[worst];
        worst = is_worse(value.tenths_of_digits, value.of_tolerance, before.tenths_of_digits, before.of_tolerance)
                    ? i
                    : worst;
        if (!value.within && row.verdict == row_verdict::ok) {
            row.verdict = row_verdict::miss;
            row.reason = own_name(i) + " misses by " + value.error;
        }
    }
    added[3] = row.verdict == row_verdict::ok ? "ok" : "miss";
    row.text = writer_.row(record, cells, added);
    row.column = own_name(worst);
    row.error = here.values[worst].error;
    row.least_tenths = here.values[worst].tenths_of_digits;
    row.condition = here.condition;
    row.of_tolerance = here.values[worst].of_tolerance;
    row.numbers = here.numbers;
    return row;
}

}  // namespace libration
