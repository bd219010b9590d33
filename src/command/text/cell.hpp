// A cell of a table: text, or a number with its digits. A number is already a decimal, so it is not rounded on output,
// and its type need not be inferred from its characters.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "libration/scalar/decimal.hpp"

namespace libration {

/// What a cell holds.
enum class cell_kind { empty, text, whole, number, list };

/// A cell. Words become text, integers whole numbers; decimals are made by the functions below, which say how many
/// digits they have.
class cell {
public:
    cell() = default;
    /// Text; no characters at all are an empty cell.
    cell(std::string words) : kind_(words.empty() ? cell_kind::empty : cell_kind::text), text_(std::move(words)) {}
    cell(std::string_view words) : cell(std::string(words)) {}
    cell(const char* words) : cell(std::string(words)) {}
    template <std::integral Whole>
    requires(!std::same_as<Whole, bool> && !std::same_as<Whole, char>) cell(Whole count)
        : kind_(cell_kind::whole), text_(std::to_string(count)) {}
    cell(const integer& count) : kind_(cell_kind::whole), text_(count.str()) {}

    /// A number as a decimal (1.71, -1.5e-300, inf, -inf, nan) with so many significant digits.
    static cell number(std::string decimal, long digits);
    /// A JSON array, which only JSON shows as such.
    static cell list(std::string json);

    cell_kind kind() const { return kind_; }
    bool is_empty() const { return kind_ == cell_kind::empty; }
    bool is_number() const { return kind_ == cell_kind::whole || kind_ == cell_kind::number; }
    /// As written in CSV, without quotes.
    const std::string& text() const { return text_; }
    /// Significant digits of a number; 0 where they have no bound, as those of a whole number.
    long digits() const { return digits_; }

    friend bool operator==(const cell& a, const cell& b) { return a.text_ == b.text_; }

private:
    cell_kind kind_ = cell_kind::empty;
    std::string text_;
    long digits_ = 0;
};

/// A number from its decimal, with all of its digits; empty for an empty text.
cell number_cell(const std::string& decimal);

/// A cell of a file: a number where one is written, else text.
cell read_cell(const std::string& text);

/// x with so many significant digits, rounded to nearest.
template <rounding_scalar T>
cell decimal_cell(const T& x, long digits) {
    return cell::number(to_decimal(x, digits), digits);
}

/// The same where there is a value, else empty.
template <rounding_scalar T>
cell decimal_cell(const std::optional<T>& x, long digits) {
    return x ? decimal_cell(*x, digits) : cell();
}

/// log10 |x| with 12 digits, -inf for 0.
template <rounding_scalar T>
cell log10_cell(const T& x) {
    return cell::number(log10_text(x), 12);
}

template <rounding_scalar T>
cell log10_cell(const std::optional<T>& x) {
    return x ? log10_cell(*x) : cell();
}

}  // namespace libration
