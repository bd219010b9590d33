#include "verify/verify_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "libration/digits/growing_precision.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/text/written_number.hpp"
#include "motion/motion_cells.hpp"
#include "text/csv_records.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

std::string tenths_text(const std::optional<long>& tenths) {
    return tenths ? fmt::format("{}.{}", *tenths / 10, *tenths % 10) : "inf";
}

// By how many turns a value is away, to the nearest.
true_value turned_towards(const std::string& value, true_value truth) {
    written_number written{0, 1};
    try {
        written = read_written(value);
    } catch (const error&) {
        return truth;  // nan, or what the comparison complains of
    }
    const ball turn = pi<ball>() * 2;
    const integer turns = nearest_integer(ball((from_rational<ball>(written.value) - truth.value()) / turn));
    if (turns != 0) {
        truth.enclosure = truth.value() + from_rational<ball>(rational(turns)) * turn;
        truth.exactly = std::nullopt;
    }
    return truth;
}

}  // namespace

std::vector<std::string> added_columns(const std::vector<compared_column>& compared) {
    std::vector<std::string> names{"reference", "error", "correct_digits", "verdict", "condition"};
    for (std::size_t i = 1; i < compared.size(); ++i) {
        for (const char* const name : {"_reference", "_error", "_correct_digits"}) {
            names.push_back(compared[i].name + name);
        }
    }
    return names;
}

compared_row row_comparer::operator()(const csv_record& record) {
    const split_record split = split_cells(record.text, writer_.between());
    const std::size_t count = names_.count();
    if (!split.closed) {
        const std::size_t at = split.cells.size() - 1;
        return malformed(record, {record.text},
                         (at < count ? quotation(names_.own(at)) + ": " : std::string()) + "a quote is not closed");
    }
    if (split.cells.size() != count) {
        return malformed(record, split.cells,
                         fmt::format("has {} cells, the header has {}", split.cells.size(), count));
    }
    try {
        return row_of(record, split.cells, compared(split.cells));
    } catch (const error& problem) {  // what cannot be read, motions that there are not, and what cannot be proved
        return malformed(record, split.cells, message_of(problem));
    }
}

compared_row row_comparer::malformed(const csv_record& record, std::vector<std::string> cells,
                                     const std::string& reason) const {
    cells.resize(names_.count());
    std::vector<std::string> added(added_columns(reader_->columns()).size());
    added[3] = "malformed";
    compared_row row;
    row.line = record.line;
    row.text = writer_.row({record.line, ""}, cells, added);
    row.reason = reason;
    return row;
}

row_comparer::answers row_comparer::compared(const std::vector<std::string>& cells) {
    const auto& columns = reader_->columns();
    std::vector<std::string> values;
    long places = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const named_text cell{trimmed(cells[columns[i].at]), own_name(i)};
        if (cell.text.empty()) {
            throw error(error_kind::argument, cell.name, "", "is empty");
        }
        places =
            std::max(places, reading_cell(cell, [&](const std::string& text) { return places_for(text, rules_); }));
        values.push_back(cell.text);
    }
    const row_question question = reader_->read(cells);
    const long start = question.first_digits(places);
    constexpr int attempts = 5;
    return with_growing_precision({0, start, attempts * start, digit_growth::by_first}, own_name(0),
                                  [&](const precision_run& run) -> std::optional<answers> {
                                      answers here;
                                      auto truths = question.truths(run.more);
                                      for (std::size_t i = 0; i < truths.size(); ++i) {
                                          if (i == 0 && rules_.modulo_turn) {
                                              truths[i] = turned_towards(values[i], truths[i]);
                                          }
                                          auto value = compare_value(values[i], truths[i], rules_, run.last);
                                          if (!value) {
                                              return std::nullopt;
                                          }
                                          here.values.push_back(*std::move(value));
                                      }
                                      here.condition = question.condition(run.more);
                                      return here;
                                  });
}

compared_row row_comparer::row_of(const csv_record& record, const std::vector<std::string>& cells,
                                  const answers& here) const {
    std::vector<std::string> added;
    compared_row row;
    row.line = record.line;
    row.verdict = row_verdict::ok;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < here.values.size(); ++i) {
        const comparison& value = here.values[i];
        added.insert(added.end(), {value.reference, value.error, tenths_text(value.tenths_of_digits)});
        if (i == 0) {
            added.insert(added.end(), {"", here.condition});
        }
        worst = value.of_tolerance > here.values[worst].of_tolerance ? i : worst;
        if (!value.within && row.verdict == row_verdict::ok) {
            row.verdict = row_verdict::miss;
            row.reason = own_name(i) + " misses by " + value.error;
        }
    }
    added[3] = row.verdict == row_verdict::ok ? "ok" : "miss";
    row.text = writer_.row(record, cells, added);
    row.column = own_name(worst);
    row.error = here.values[worst].error;
    row.tenths_of_digits = here.values.front().tenths_of_digits;
    row.condition = here.condition;
    row.of_tolerance = here.values[worst].of_tolerance;
    return row;
}

}  // namespace libration
