#include "text/measured_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "libration/number/exact.hpp"

namespace libration {

namespace {

using words = std::vector<std::string>;

[[noreturn]] void refuse(const std::string& placeholder, const std::string& reason) {
    throw std::runtime_error("{{" + placeholder + "}} " + reason);
}

// One reduction of a column: "max error of libration_series where order=2".
struct measure {
    std::string reduction, column, stem;
    std::vector<std::pair<std::string, std::string>> conditions;
};

// A placeholder: one measure, or the quotient of two, to so many digits.
struct request_for_number {
    std::vector<measure> measures;
    long digits = 0;
};

measure read_measure(words::const_iterator& at, words::const_iterator end, const std::string& placeholder) {
    if (end - at < 4 || at[2] != "of" || (at[0] != "max" && at[0] != "min" && at[0] != "the")) {
        refuse(placeholder, "is not 'max|min|the COLUMN of TABLE'");
    }
    measure result{at[0], at[1], at[3], {}};
    at += 4;
    if (at == end || *at != "where") {
        return result;
    }
    for (++at; at != end && *at != "/" && *at != "to"; ++at) {
        const auto equals = at->find('=');
        if (equals == std::string::npos) {
            refuse(placeholder, "has the condition '" + *at + "', which is not COLUMN=VALUE");
        }
        result.conditions.emplace_back(at->substr(0, equals), at->substr(equals + 1));
    }
    return result;
}

request_for_number read_request(const std::string& placeholder) {
    std::istringstream stream(placeholder);
    const words all{std::istream_iterator<std::string>(stream), {}};
    request_for_number result;
    auto at = all.begin();
    result.measures.push_back(read_measure(at, all.end(), placeholder));
    if (at != all.end() && *at == "/") {
        result.measures.push_back(read_measure(++at, all.end(), placeholder));
    }
    if (all.end() - at != 2 || *at != "to") {
        refuse(placeholder, "does not end in 'to DIGITS'");
    }
    const std::string& digits = at[1];
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result.digits);
    if (error != std::errc() || end != digits.data() + digits.size() || result.digits < 1) {
        refuse(placeholder, "does not end in a number of digits");
    }
    return result;
}

std::size_t place_of(const table& data, const std::string& name, const std::string& stem) {
    const auto found =
        std::find_if(data.columns().begin(), data.columns().end(), [&](const column& c) { return c.name == name; });
    if (found == data.columns().end()) {
        throw std::runtime_error(fmt::format("the table {} has no column {}", stem, name));
    }
    return static_cast<std::size_t>(found - data.columns().begin());
}

bool is(const cell& found, const std::string& wanted) {
    const cell value = read_cell(wanted);
    const bool finite = found.is_number() && value.is_number() && found.text().find("inf") == std::string::npos &&
                        wanted.find("inf") == std::string::npos;
    return finite ? read_exact(found.text()).coefficient == read_exact(wanted).coefficient : found.text() == wanted;
}

// The numbers of the column in the rows that are meant.
std::vector<mpfr> numbers_of(const measure& asked, const table& data) {
    const std::size_t column = place_of(data, asked.column, asked.stem);
    std::vector<std::pair<std::size_t, std::string>> conditions;
    conditions.reserve(asked.conditions.size());
    for (const auto& [name, value] : asked.conditions) {
        conditions.emplace_back(place_of(data, name, asked.stem), value);
    }
    std::vector<mpfr> numbers;
    for (const table_row_cells& row : data.rows()) {
        const bool meant = std::all_of(conditions.begin(), conditions.end(),
                                       [&](const auto& each) { return is(row[each.first], each.second); });
        if (meant && row[column].is_number()) {
            numbers.push_back(from_exact<mpfr>(read_exact(row[column].text())));
        }
    }
    return numbers;
}

std::optional<mpfr> value_of(const measure& asked, const table_source& tables) {
    const auto data = tables(asked.stem);
    const auto numbers = data ? numbers_of(asked, *data) : std::vector<mpfr>();
    if (numbers.empty()) {
        return std::nullopt;
    }
    const auto [least, largest] = std::minmax_element(numbers.begin(), numbers.end());
    if (asked.reduction == "the" && *least != *largest) {
        throw std::runtime_error(
            fmt::format("the column {} of {} has several values where one is meant", asked.column, asked.stem));
    }
    return asked.reduction == "min" ? *least : *largest;
}

std::string number_for(const std::string& placeholder, const table_source& tables) {
    const precision_scope scope(60);
    const request_for_number asked = read_request(placeholder);
    const auto first = value_of(asked.measures.front(), tables);
    const auto second = value_of(asked.measures.back(), tables);
    if (!first || !second) {
        return not_measured;
    }
    return to_decimal(asked.measures.size() == 1 ? *first : mpfr(*first / *second), asked.digits);
}

}  // namespace

std::string measured_text(const std::string& text, const table_source& tables) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t open = text.find("{{"); open != std::string::npos; open = text.find("{{", at)) {
        const std::size_t close = text.find("}}", open);
        if (close == std::string::npos) {
            throw std::runtime_error("a text opens {{ without }}");
        }
        result += text.substr(at, open - at) + number_for(text.substr(open + 2, close - open - 2), tables);
        at = close + 2;
    }
    return result + text.substr(at);
}

}  // namespace libration
