#include "text/cell.hpp"

#include <algorithm>
#include <cctype>

namespace libration {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// Takes a run of digits; false where there is none.
bool take_digits(std::string_view& rest) {
    const auto* const end = std::find_if_not(rest.begin(), rest.end(), is_digit);
    const auto count = static_cast<std::size_t>(end - rest.begin());
    rest.remove_prefix(count);
    return count > 0;
}

bool take(std::string_view& rest, char c) {
    const bool there = rest.starts_with(c);
    rest.remove_prefix(there ? 1 : 0);
    return there;
}

bool is_decimal(std::string_view rest) {
    take(rest, '-');
    if (!take_digits(rest) || (take(rest, '.') && !take_digits(rest))) {
        return false;
    }
    if (take(rest, 'e')) {
        take(rest, '-');
        return take_digits(rest) && rest.empty();
    }
    return rest.empty();
}

long significant_digits(const std::string& decimal) {
    long digits = 0;
    for (const char c : decimal.substr(0, decimal.find('e'))) {
        digits += (c >= '1' && c <= '9') || (c == '0' && digits > 0) ? 1 : 0;
    }
    return digits;
}

}  // namespace

cell cell::list(std::string json) {
    cell made(std::move(json));
    made.kind_ = made.is_empty() ? cell_kind::empty : cell_kind::list;
    return made;
}

cell cell::number(std::string decimal, long digits) {
    cell result(std::move(decimal));
    result.kind_ = result.is_empty() ? cell_kind::empty : cell_kind::number;
    result.digits_ = digits;
    return result;
}

cell number_cell(const std::string& decimal) { return cell::number(decimal, significant_digits(decimal)); }

cell read_cell(const std::string& text) {
    return is_decimal(text) || text == "inf" || text == "-inf" ? number_cell(text) : cell(text);
}

}  // namespace libration
