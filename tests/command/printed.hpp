// The output of the command, parsed: CSV rows, and numbers as decimal texts.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command/child_process.hpp"
#include "reference_table.hpp"
#include "scalars.hpp"

namespace libration::tests {

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// The rows of a CSV without quotes. Throws std::runtime_error if a row has other columns than the header.
inline std::vector<table_row> csv_rows(const std::string& csv) {
    const auto lines = lines_of(csv);
    const auto names = lines.empty() ? std::vector<std::string>() : split_cells(lines.front());
    std::vector<table_row> rows;
    for (std::size_t line = 1; line < lines.size(); ++line) {
        const auto cells = split_cells(lines[line]);
        if (cells.size() != names.size()) {
            throw std::runtime_error("other columns than the header: " + lines[line]);
        }
        table_row row;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            row[names[i]] = cells[i];
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The rows that a command prints with --format csv.
inline std::vector<table_row> rows_of(words line) {
    line.insert(line.end(), {"--format", "csv"});
    return csv_rows(output_of(line));
}

/// Significant digits of a printed nonzero number.
inline long significant_digits(const std::string& number) {
    std::string digits;
    for (const char c : number.substr(0, number.find('e'))) {
        digits += std::isdigit(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : "";
    }
    return static_cast<long>(digits.size() - digits.find_first_not_of('0'));
}

/// A printed number exactly as shown, at 200 digits.
inline mpfr number_of(const std::string& text) { return decimal(text).value; }

/// One unit in the last printed digit: 1e-4 of 0.0120, 1e-12 of 1.50e-10.
inline mpfr last_place(const std::string& number) {
    const auto e = number.find('e');
    const std::string significand = number.substr(0, e);
    const auto point = significand.find('.');
    const long places = point == std::string::npos ? 0 : static_cast<long>(significand.size() - point - 1);
    const long exponent = e == std::string::npos ? 0 : std::stol(number.substr(e + 1));
    const precision_scope scope(30);
    return pow(mpfr(10), static_cast<int>(exponent - places));
}

/// The guarantee of the command: every printed digit is correct to one unit in the last place. The expected text has
/// more digits, itself correct to one unit; 0 and inf must be printed as such.
class right_to_the_last_digit : public Catch::MatcherBase<std::string> {
public:
    explicit right_to_the_last_digit(std::string expected) : expected_(std::move(expected)) {}
    bool match(const std::string& printed) const override {
        const bool number = !printed.empty() && std::isdigit(static_cast<unsigned char>(printed.back())) != 0;
        if (!number || printed == "0" || expected_ == "0" || expected_ == "inf") {
            return printed == expected_;
        }
        const precision_scope scope(200);
        return abs(number_of(printed) - number_of(expected_)) <= last_place(printed) + last_place(expected_);
    }
    std::string describe() const override { return "is right to the last digit: " + expected_; }

private:
    std::string expected_;
};

/// The same for a value computed to many more digits than are printed.
inline right_to_the_last_digit right_to_the_last_digit_of(const mpfr& value) {
    return right_to_the_last_digit(to_decimal(value, 100));
}

}  // namespace libration::tests
