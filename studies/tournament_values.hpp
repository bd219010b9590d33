// The values of series in the tournament: the sum of a list of coefficients at a point, against a closed form.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "libration/convergence/sum.hpp"
#include "population/known_values.hpp"
#include "shared/sweep_columns.hpp"

namespace libration::studies::tournament_results {

inline constexpr long digits_of_lists_to_sum = 400;  // for exact lists: far more than their sums have
inline constexpr long digits_of_values = 40;         // printed, and at most counted
inline constexpr long digits_of_value_errors = 6;

// The sum of a list at a point.
struct judged_value {
    std::string region, family;
    int list = 0, order = 0;
    mpfr x, truth;
    convergence::series_value found;
    std::optional<mpfr> error = std::nullopt;   // relative
    std::optional<mpfr> digits = std::nullopt;  // that the uncertainty leaves
    bool covered = false;
};

inline const column_list<judged_value>& value_columns() {
    using row = judged_value;
    static const column_list<row> all{
        {"list", "number of the random list", [](const row& r) { return r.list; }},
        {"family", "of functions", [](const row& r) { return r.family; }},
        {"region",
         "inside the circle of convergence | beyond it | pole beyond: a pole alone | entire | divergent: radius 0 | "
         "hard: of functions that satisfy no short linear equation, or with several singularities",
         [](const row& r) { return r.region; }},
        {"order", "N, last power of the list", [](const row& r) { return r.order; }},
        {"x", "the point", [](const row& r) { return decimal_cell(r.x, digits_of_values); }},
        {"value", "sum of the list; empty where fewer than one digit is certain",
         [](const row& r) { return decimal_cell(r.found.value, digits_of_values); }},
        {"uncertainty", "of the value, absolute",
         [](const row& r) {
             return r.found.value ? decimal_cell(r.found.uncertainty, digits_of_value_errors) : cell();
         }},
        {"exact", "closed form", [](const row& r) { return decimal_cell(r.truth, digits_of_values); }},
        {"relative_error", "|value/exact - 1|",
         [](const row& r) { return decimal_cell(r.error, digits_of_value_errors); }},
        {"digits", "that the uncertainty leaves, -log10 |uncertainty/exact|, at most 40",
         [](const row& r) { return decimal_cell(r.digits, digits_of_value_errors); }},
        {"covered", "yes: the error is within the uncertainty | no",
         [](const row& r) { return r.found.value ? cell(r.covered ? "yes" : "no") : cell(); }},
        {"note", "why there is no value, or on which branch it is", [](const row& r) { return r.found.note; }}};
    return all;
}

// The k-th random list, drawn from the seed, at these orders.
inline std::vector<judged_value> values_of_drawn(int k, int seed, const std::vector<int>& orders) {
    const precision_scope scope(digits_of_lists_to_sum);
    std::vector<judged_value> all;
    for (const int order : orders) {
        // Families follow one another with the number of the list: 20 of them (known_values.hpp).
        const auto known = tests::known_value_of(static_cast<unsigned>(k) + 1000U * static_cast<unsigned>(seed), order);
        const std::vector<mpfr> points{known.x};
        judged_value row{known.region,
                         known.family,
                         k,
                         order,
                         known.x,
                         known.truth,
                         convergence::sums_of_list({.values = known.a}, {}, points).front()};
        if (row.found.value) {
            const mpfr away = abs(mpfr(*row.found.value - row.truth));
            row.covered = away <= row.found.uncertainty;
            row.error = away / abs(row.truth);
            const mpfr left(-log10(mpfr(row.found.uncertainty / abs(row.truth))));
            row.digits = std::clamp(left, mpfr(0), mpfr(digits_of_values));
        }
        all.push_back(std::move(row));
    }
    return all;
}

// The values of a region at one order.
struct value_score_row {
    std::string region;
    int order = 0, lists = 0, values = 0, covered = 0;
    std::vector<mpfr> digits = {};
};

inline const column_list<value_score_row>& value_score_columns() {
    using row = value_score_row;
    static const column_list<row> all{
        {"region", "of the point, as in the table values; all: every list", [](const row& r) { return r.region; }},
        {"order", "N, last power of the lists", [](const row& r) { return r.order; }},
        {"lists", "random lists", [](const row& r) { return r.lists; }},
        {"values", "given for them", [](const row& r) { return r.values; }},
        {"covered", "share of the values whose error is within the uncertainty",
         [](const row& r) { return r.values == 0 ? cell() : decimal_cell(mpfr(mpfr(r.covered) / r.values), 4); }},
        {"median_digits", "that the uncertainty leaves", [](const row& r) {
             auto sorted = r.digits;
             std::sort(sorted.begin(), sorted.end());
             return sorted.empty() ? cell() : decimal_cell(sorted[sorted.size() / 2], digits_of_value_errors);
         }}};
    return all;
}

// From the printed rows of the table of values.
inline table value_scores(const table& values) {
    std::map<std::tuple<int, bool, std::string>, value_score_row> groups;  // all lists of an order before its regions
    for (const table_row_cells& row : values.rows()) {
        const int order = std::stoi(row[3].text());
        for (const std::string& region : {std::string("all"), row[2].text()}) {
            auto& here = groups[{order, region != "all", region}];
            here.region = region;
            here.order = order;
            ++here.lists;
            if (!row[5].is_empty()) {
                ++here.values;
                here.covered += row[10].text() == "yes" ? 1 : 0;
                here.digits.push_back(from_exact<mpfr>(read_exact(row[9].text())));
            }
        }
    }
    std::vector<value_score_row> all;
    for (auto& [key, row] : groups) {
        all.push_back(std::move(row));
    }
    return make_table(value_score_columns(), all);
}

}  // namespace libration::studies::tournament_results
