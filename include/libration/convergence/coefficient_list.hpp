// A list of coefficients in the usual notations, read exactly.
//
//     1              0,1               n,coefficient
//     1/3            1,1/3             0,1
//     2/15           2,2/15            2,0.1333
// One number per line represents a_0, a_1, ...; two numbers are n and a_n. Cells are separated by commas, semicolons or
// blanks and may be quoted. Lines may end in CR LF; blank lines and everything after a # are skipped. A first line of
// names is a header.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libration/number/exact.hpp"
#include "libration/scalar/error.hpp"

namespace libration::convergence {

/// A line that is not a coefficient: its number from 1 on, its text, and the error in reason().
class malformed_line : public error {
public:
    malformed_line(std::size_t number, std::string text, const std::string& reason)
        : error(error_kind::argument, "line " + std::to_string(number), std::move(text), reason), number_(number) {}
    std::size_t number() const { return number_; }
    const std::string& text() const { return value(); }

private:
    std::size_t number_;
};

/// Reads a whole text. n has to increase from line to line; a missing n is a coefficient 0.
class coefficient_reader {
public:
    /// a_0 .. a_N, empty for an empty text. Throws malformed_line.
    std::vector<exact> read(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) {
            text.remove_prefix(3);
        }
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            line_ = trimmed(text.substr(0, end));
            ++number_;
            take(line_.substr(0, line_.find('#')));
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        return std::move(list_);
    }

private:
    static constexpr std::size_t largest_order = 100'000;
    static constexpr std::string_view blanks = " \t\r\v\f";

    /// Which cell is n, which is a_n, and the number of cells.
    struct layout {
        std::optional<std::size_t> index;
        std::size_t value = 0;
        std::size_t cells = 1;
    };

    static std::string_view trimmed(std::string_view text) {
        const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
        text.remove_prefix(first);
        return text.substr(0, text.find_last_not_of(blanks) + 1);
    }

    static std::vector<std::string_view> cells_of(std::string_view line) {
        const bool commas = line.find_first_of(",;") != std::string_view::npos;
        std::vector<std::string_view> cells;
        for (bool more = true; more;) {
            const std::size_t end = line.find_first_of(commas ? ",;" : blanks);
            std::string_view cell = trimmed(line.substr(0, end));
            if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') {
                cell = trimmed(cell.substr(1, cell.size() - 2));
            }
            cells.push_back(cell);
            more = end != std::string_view::npos;
            line = more ? line.substr(end + 1) : line;
            line = commas ? line : trimmed(line);
        }
        return cells;
    }

    [[noreturn]] void fail(const std::string& reason) const {
        throw malformed_line(number_, std::string(line_), reason);
    }

    // Names only; a single one has to be "coefficient", since it might be a misspelt number.
    static bool is_header(const std::vector<std::string_view>& cells) {
        if (cells.size() == 1) {
            return cells.front() == "coefficient";
        }
        return std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
            return !cell.empty() &&
                   (std::isalpha(static_cast<unsigned char>(cell.front())) != 0 || cell.front() == '_');
        });
    }

    layout named_layout(const std::vector<std::string_view>& cells) const {
        const auto place = [&](std::string_view name) {
            return static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) - cells.begin());
        };
        const std::size_t value = place("coefficient");
        if (cells.size() > 2 && value == cells.size()) {
            fail("has no column 'coefficient'");
        }
        if (cells.size() == 1) {
            return {std::nullopt, 0, 1};
        }
        const std::size_t index = place("n") < cells.size() ? place("n") : 0;
        return {index, value < cells.size() ? value : 1 - index, cells.size()};
    }

    layout layout_of_numbers(const std::vector<std::string_view>& cells) const {
        if (cells.size() > 2) {
            fail("has " + std::to_string(cells.size()) + " numbers");
        }
        return cells.size() == 1 ? layout{} : layout{0, 1, 2};
    }

    exact number_in(std::string_view cell) const {
        try {
            exact number = read_exact(cell);
            if (number.is_number()) {
                return number;
            }
        } catch (const error& problem) {
            fail(problem.reason());
        }
        fail("has a unit");
    }

    std::size_t index_in(std::string_view cell) const {
        const exact number = number_in(cell);
        const rational n = number.is_fraction() ? number.coefficient : rational(-1);
        if (boost::multiprecision::denominator(n) != 1 || n < 0) {
            fail("has an n that is not a nonnegative integer");
        }
        if (n > largest_order) {
            fail("has an n beyond " + std::to_string(largest_order));
        }
        return boost::multiprecision::numerator(n).convert_to<std::size_t>();
    }

    void take(std::string_view line) {
        line = trimmed(line);
        if (line.empty()) {
            return;
        }
        const auto cells = cells_of(line);
        if (!layout_) {
            const bool header = is_header(cells);
            layout_ = header ? named_layout(cells) : layout_of_numbers(cells);
            if (header) {
                return;
            }
        }
        if (cells.size() != layout_->cells) {
            fail("has a different number of cells than the previous lines");
        }
        const std::size_t n = layout_->index ? index_in(cells[*layout_->index]) : list_.size();
        if (n < list_.size()) {
            fail("has an n that is not greater than the previous ones");
        }
        if (n > largest_order) {
            fail("is the coefficient of a power beyond " + std::to_string(largest_order));
        }
        exact value = number_in(cells[layout_->value]);
        list_.resize(n);
        list_.push_back(std::move(value));
    }

    std::size_t number_ = 0;
    std::string_view line_;
    std::optional<layout> layout_;
    std::vector<exact> list_;
};

/// The coefficients in a text; throws malformed_line.
inline std::vector<exact> read_coefficients(std::string_view text) { return coefficient_reader().read(text); }

}  // namespace libration::convergence
