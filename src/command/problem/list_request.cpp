#include "list_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "coefficient_file.hpp"
#include "libration/number/grid.hpp"
#include "option/options.hpp"
#include "text/column_file.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

std::vector<exact> numbers_of(const std::string& option, const std::string& value) {
    auto numbers = reading(option, value, "write numbers with commas between them", [&] { return read_grid(value); });
    for (const exact& number : numbers) {
        if (!number.is_number()) {
            throw input_error(option, value, "has a unit", "write numbers with commas between them");
        }
    }
    return numbers;
}

bool same_time(const exact& a, const exact& b) {
    return a.text == b.text || (a.is_fraction() && b.is_fraction() && a.coefficient == b.coefficient);
}

// A formula in t with a time in the place of t: "exp(t)" at 1/2 is "exp((1/2))".
std::string with_time(const std::string& formula, const std::string& time) {
    const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::string result;
    for (std::size_t i = 0; i < formula.size(); ++i) {
        const bool alone = formula[i] == 't' && (i == 0 || !in_word(formula[i - 1])) &&
                           (i + 1 == formula.size() || !in_word(formula[i + 1]));
        result += alone ? "(" + time + ")" : std::string(1, formula[i]);
    }
    return result;
}

reference_values by_formula(const std::string& formula, const std::vector<exact>& times) {
    reference_values values;
    for (const exact& time : times) {
        values.push_back(reading("--reference", formula,
                                 "write a value, a file with columns time,value or a formula in t",
                                 [&] { return read_exact(with_time(formula, time.text)); }));
    }
    return values;
}

// The rows time,value of a file, in this order where they have no names.
reference_values by_file(const std::string& path, const std::vector<exact>& times) {
    input_stream stream("--reference", path);
    column_file file(stream);
    const auto place = [&](const char* name, std::size_t otherwise) {
        const auto at = std::find(file.names().begin(), file.names().end(), name);
        return at == file.names().end() ? otherwise : static_cast<std::size_t>(at - file.names().begin());
    };
    const std::size_t time_at = place("time", 0);
    const std::size_t value_at = place("value", time_at == 1 ? 0 : 1);
    std::vector<std::pair<exact, exact>> rows;
    while (const auto record = file.next()) {
        const auto cells = file.cells(*record);
        if (!cells || cells->size() <= std::max(time_at, value_at)) {
            throw input_error("--reference", path, "has a row without time and value: " + quotation(record->text),
                              "write rows of two numbers");
        }
        rows.emplace_back(number_of("--reference", (*cells)[time_at]), number_of("--reference", (*cells)[value_at]));
    }
    reference_values values;
    for (const exact& time : times) {
        const auto row =
            std::find_if(rows.begin(), rows.end(), [&](const auto& each) { return same_time(each.first, time); });
        if (row == rows.end()) {
            throw input_error("--reference", path, "has no row of the time " + quotation(time.text),
                              "add it, or leave that time out");
        }
        values.push_back(row->second);
    }
    return values;
}

const char* const verdict_method = "verdict";

std::vector<list_method> methods_of(const list_words& words) {
    const bool at_end = words.end.has_value();
    if (!words.method) {
        auto methods = std::vector{list_method::series, list_method::pade};
        if (at_end) {
            methods.push_back(list_method::endpoint);
        }
        return methods;
    }
    for (const list_method method : {list_method::series, list_method::pade, list_method::endpoint}) {
        if (*words.method == name_of(method)) {
            return {method};
        }
    }
    if (*words.method == verdict_method) {
        return {};
    }
    throw input_error("--method", *words.method, "is not a method for a list",
                      "write verdict, series, pade or endpoint");
}

}  // namespace

std::string name_of(list_method method) {
    return method == list_method::series ? "series" : method == list_method::pade ? "pade" : "endpoint";
}

list_request list_request_of(const list_words& words, long digits) {
    list_request request{coefficients_in_file(words.file),
                         digits,
                         {},
                         !words.method || *words.method == verdict_method,
                         methods_of(words),
                         {},
                         {},
                         {}};
    if (words.order) {
        const auto order = static_cast<std::size_t>(order_of("--order", *words.order));
        if (order >= request.coefficients.size()) {
            throw input_error(
                "--order", *words.order,
                fmt::format("is more than {} has, whose last power is {}", quotation(words.file), request.order()),
                "write a smaller order or leave it out");
        }
        request.coefficients.resize(order + 1);
    }
    if (words.end) {
        request.end = number_of("--endpoint", *words.end);
        if (sign_of_exact(*request.end) == 0) {
            throw input_error("--endpoint", *words.end, "is the point of the list itself", "name another one");
        }
        request.at_end = numbers_of("--endpoint-values", *words.at_end);
    }
    if (words.times) {
        request.times = numbers_of("--times", *words.times);
    }
    if (words.reference) {
        std::error_code error;
        request.reference = std::filesystem::exists(*words.reference, error)
                                ? by_file(*words.reference, request.times)
                                : by_formula(*words.reference, request.times);
    }
    return request;
}

}  // namespace libration
