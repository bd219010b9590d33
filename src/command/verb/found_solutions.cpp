#include "found_solutions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "libration/number/grid.hpp"
#include "libration/number/two_proofs.hpp"
#include "libration/problem/limit_solution.hpp"
#include "problem/swept_problem.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct guessed_values {
    std::string name;
    std::vector<exact> values;
};

guessed_values read_guess(const std::string& words, const std::vector<std::string>& unknowns) {
    const auto equals = words.find('=');
    const std::string name = without_blanks(words.substr(0, equals));
    const bool given = equals != std::string::npos && equals + 1 < words.size();
    if (std::ranges::find(unknowns, name) == unknowns.end()) {
        const std::string values = given ? words.substr(equals + 1) : "0,1";
        throw input_error("--guess", words,
                          "does not name one of --unknown " + fmt::format("{}", fmt::join(unknowns, ",")),
                          fmt::format("write --guess \"{}={}\"", unknowns.front(), values));
    }
    if (!given) {
        throw input_error("--guess", words, "has no values", fmt::format("write --guess \"{}=0,1\"", name));
    }
    const auto read = [&] { return read_grid(without_blanks(words.substr(equals + 1))); };
    return {name, reading("--guess", words, fmt::format("write --guess \"{0}=1\", \"{0}=0,1\" or \"{0}=0:5:11\"", name),
                          read)};
}

// The last value of each row, with its bound.
bool same_solution(const answer& a, const answer& b) {
    return std::ranges::equal(a.rows, b.rows, [](const auto& first, const auto& second) {
        return enclosures_meet({first.back().text, first.back().bound}, {second.back().text, second.back().bound});
    });
}

std::string name_of_guess(const first_guess& guess) {
    return fmt::format("the first guess {}", fmt::join(guess, ", "));
}

}  // namespace

std::vector<first_guess> first_guesses(const std::vector<std::string>& given,
                                       const std::vector<std::string>& unknowns) {
    std::vector<first_guess> all{{}};
    std::vector<std::string> names;
    for (const std::string& words : given) {
        const auto [name, values] = read_guess(words, unknowns);
        if (std::ranges::find(names, name) != names.end()) {
            throw input_error("--guess", words, "is a second list for " + name,
                              fmt::format("write all its values in one list, \"{}=0,1\"", name));
        }
        names.push_back(name);
        std::vector<first_guess> longer;
        for (const first_guess& before : all) {
            for (const exact& value : values) {
                longer.push_back(before);
                longer.back().push_back(name + " = " + value.text);
            }
        }
        all = std::move(longer);
    }
    return all;
}

void found_solutions::keep(const first_guess& guess, answer found) {
    const auto same = std::ranges::find_if(solutions_, [&](const answer& each) { return same_solution(each, found); });
    if (same == solutions_.end()) {
        solutions_.push_back(std::move(found));
        return;
    }
    remarks_.push_back(
        fmt::format("{} leads to solution {} again", name_of_guess(guess), same - solutions_.begin() + 1));
}

void guessed_answers::add_failure(const first_guess& guess, const error& problem) {
    if (problem.kind() != error_kind::undecided || !problem.is_about_solution() || guess.empty()) {
        throw error(problem);
    }
    has_failures_ = true;
    remarks_.push_back(fmt::format("{}: it {}", failure(guess), problem.reason()));
}

std::string found_solutions::failure(const first_guess& guess) const {
    return name_of_guess(guess) + " leads to no solution";
}

namespace {

// The values, then the numbers of the notes.
std::vector<std::vector<answer_value>> rows_with_numbers(const answer& of, const std::vector<std::string>& shown) {
    auto rows = of.rows;
    for (const answer_note& each : of.notes) {
        if (is_shown(each, shown)) {
            rows.push_back({text_value(each.name), {each.text, ""}});
        }
    }
    return rows;
}

long significant_digits(const std::string& decimal) {
    const auto first = decimal.find_first_of("123456789");
    const std::string_view counted = std::string_view(decimal).substr(std::min(first, decimal.size()));
    return std::ranges::count_if(counted.substr(0, counted.find('e')), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

table found_solutions::as_table(long digits, bool numbered, const std::vector<std::string>& shown) const {
    std::vector<column> columns{{"name", ""}, {"value", ""}, {"digits", ""}, {"rigour", ""}};
    if (numbered) {
        columns.insert(columns.begin(), {"solution", ""});
    }
    table data(columns);
    for (std::size_t i = 0; i < solutions_.size(); ++i) {
        const auto rows = rows_with_numbers(solutions_[i], shown);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const auto& row = rows[k];
            const long own =
                k >= solutions_[i].rows.size() ? std::min(digits, significant_digits(row[1].text)) : digits;
            table_row_cells cells{row[0].text, cell::number(row[1].text, own), own, solutions_[i].rigour};
            if (numbered) {
                cells.insert(cells.begin(), cell(static_cast<long>(i + 1)));
            }
            data.add_row(std::move(cells));
        }
    }
    return data;
}

std::string found_solutions::as_text(const std::vector<std::string>& shown) const {
    std::string lines;
    for (const answer& each : solutions_) {
        lines += lines.empty() ? "" : "\n";
        std::size_t width = 10;
        const auto rows = rows_with_numbers(each, shown);
        for (const auto& row : rows) {
            width = std::max(width, row[0].text.size() + 2);
        }
        for (const auto& row : rows) {
            const bool known = !row[1].text.empty();
            lines += fmt::format("{:<{}}{}\n", row[0].text, width,
                                 known ? row[1].text : "less than " + row[1].bound + " in absolute value");
        }
    }
    return lines;
}

}  // namespace libration
