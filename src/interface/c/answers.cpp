#include "answers.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "libration/number/given_number.hpp"

namespace libration::c {

namespace {

// A value without proved digits is 0 to within its bound; there is none at a time that its equations do not reach.
void add_known(libration_table& table, const answer_value& value, const std::string& rigour) {
    const bool is_known = !value.text.empty() || value.kind != value_kind::number;
    if (is_known) {
        table.add(number_of(value, rigour));
    } else if (value.bound.empty()) {
        table.add(std::string());
    } else {
        table.add(libration_number{"0", value.bound, LIBRATION_PROVED});
    }
}

}  // namespace

request digits_by(long digits, int rigour) {
    return {.scalar = {asks_proof(rigour) ? scalar_kind::proved : scalar_kind::arbitrary, given_digits(digits)}};
}

libration_number number_of(const answer_value& value, const std::string& rigour) {
    switch (value.kind) {
        case value_kind::whole_number: return {value.text, "0", LIBRATION_PROVED};
        case value_kind::list:
        case value_kind::text: return typed_number(value.text);
        case value_kind::number: break;
    }
    return rigour == "exact"    ? typed_number(value.text)
           : rigour == "proved" ? proved_number({value.text, value.bound})
                                : rounded_number(value.text);
}

libration_table table_of_numbers(const answer& found) {
    libration_table table{found.names, {}};
    for (const auto& row : found.rows) {
        for (const answer_value& value : row) {
            add_known(table, value, found.rigour);
        }
    }
    return table;
}

libration_table table_of_values(const answer& found) {
    libration_table table{found.names, {}};
    for (const auto& row : found.rows) {
        table.add(row[0].text);
        table.add(number_of(row[1], found.rigour));
        for (std::size_t j = 2; j < row.size(); ++j) {
            table.add(row[j].text);
        }
    }
    return table;
}

libration_table table_of_branch(const answer& found) {
    libration_table table{found.names, {}};
    table.names.emplace_back("note");
    const auto end = std::ranges::find(found.notes, std::string("end"), &answer_note::name);
    for (const auto& row : found.rows) {
        table.add(row.front().text);
        for (auto value = row.begin() + 1; value != row.end(); ++value) {
            add_known(table, *value, found.rigour);
        }
        table.add(&row == &found.rows.back() && end != found.notes.end() ? end->text : std::string());
    }
    return table;
}

libration_table known_states::complete() && {
    if (missing) {
        throw error(*missing);
    }
    return std::move(table);
}

void known_states::write(libration_table** to) && {
    *to = std::make_unique<libration_table>(std::move(table)).release();
    if (missing) {
        throw error(*missing);
    }
}

known_states states_of(const solution& of, const std::string& times, request how, const watcher& watch,
                       std::vector<std::string> numbers) {
    const auto items = items_of(times, "times");
    std::vector<exact> at;
    std::ranges::transform(items, std::back_inserter(at),
                           [](const std::string& item) { return given_time("time", item); });
    how.derivatives = std::move(numbers);
    how.progress = [&](double part) { watch(part); };
    answer found = of.states(at, how);
    const std::string rigour = how.scalar.kind == scalar_kind::proved ? "proved" : "two-method";
    libration_table table{{"time"}, {}};
    table.names.insert(table.names.end(), found.names.begin(), found.names.end());
    for (std::size_t i = 0; i < items.size(); ++i) {
        table.add(items[i]);
        found.rows[i].resize(found.names.size());
        for (const answer_value& value : found.rows[i]) {
            add_known(table, value, rigour);
        }
    }
    return {std::move(table), std::move(found.missing)};
}

}  // namespace libration::c
