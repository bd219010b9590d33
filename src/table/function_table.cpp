#include "table/function_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <sstream>

#include "libration/digits/agreed_values.hpp"
#include "libration/elliptic/proved/function_condition.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "option/options.hpp"
#include "run/grid.hpp"
#include "run/parallel.hpp"
#include "table/elliptic_request.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;

namespace {

// Three digits of the condition: computed with twice the digits until they stay.
std::string condition_text(const std::string& function, const exact& at, const typed_parameter& parameter) {
    if (is_infinite(function, at, parameter.value())) {
        return "inf";
    }
    const auto value = [&](const exact& u, const exact& x) { return function_ball(function, u, parameter.from(x)); };
    const auto compute = [&](const precision_run& /*run*/) -> std::optional<std::string> {
        const auto condition = function_condition(value, at, parameter.typed);
        return condition ? to_decimal(*condition, 3) : "inf";
    };
    return until_two_agree({0, 40 + digits_before_point(at), most_agreement_digits},
                           fmt::format("the condition of {}({})", function, at.text), compute, std::equal_to<>());
}

std::vector<column> columns_of(const elliptic_request& request, input_style style) {
    const std::string parameter = request.option.substr(2);
    const std::string condition = "(|u df/du| + |x df/dx|)/|f|, x = " + parameter + ", heuristic, three digits";
    if (style == input_style::typed) {
        return {{"function", ""},         {"argument", "as typed"},         {parameter, "as typed"},   {"value", ""},
                {"condition", condition}, {"digits", "significant digits"}, {"rigour", "of the value"}};
    }
    std::vector<column> columns;
    columns.reserve(2 + 2 * request.functions.size());
    if (!request.argument.empty()) {
        columns.push_back({request.argument, "argument"});
    }
    columns.push_back({parameter, ""});
    for (const std::string& function : request.functions) {
        columns.push_back({function, ""});
    }
    for (const std::string& function : request.functions) {
        columns.push_back({"condition_" + function, condition});
    }
    return columns;
}

// The rows of one argument at one parameter.
class function_rows {
public:
    function_rows(const elliptic_request& request, const typed_parameter& parameter, const exact& at, long digits)
        : request_(request), parameter_(parameter), at_(at), digits_(digits) {}

    std::vector<table_row_cells> typed() const {
        std::vector<table_row_cells> rows;
        rows.reserve(request_.functions.size());
        for (const std::string& function : request_.functions) {
            rows.push_back({function, read_cell(at_.text), read_cell(parameter_.typed.text), value_of(function),
                            number_cell(condition_text(function, at_, parameter_)), digits_, "proved"});
        }
        return rows;
    }

    std::vector<table_row_cells> decimals() const {
        table_row_cells row;
        if (!request_.argument.empty()) {
            row.push_back(number_cell(decimal_text(at_, digits_ + more_input_digits)));
        }
        row.push_back(number_cell(decimal_text(parameter_.typed, digits_ + more_input_digits)));
        for (const std::string& function : request_.functions) {
            row.push_back(value_of(function));
        }
        for (const std::string& function : request_.functions) {
            row.push_back(number_cell(condition_text(function, at_, parameter_)));
        }
        return {row};
    }

private:
    cell value_of(const std::string& function) const {
        return number_cell(function_text(function, at_, parameter_.value(), digits_));
    }

    const elliptic_request& request_;
    const typed_parameter& parameter_;
    const exact& at_;
    long digits_;
};

}  // namespace

std::vector<std::string> functions_of(const std::string& list) {
    std::vector<std::string> functions;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        if (!is_elliptic_function(name)) {
            throw input_error("table", list, "is no function", "write pendulum, am, sn, cn, dn, K or F");
        }
        if (std::find(functions.begin(), functions.end(), name) != functions.end()) {
            throw input_error("table", list, "names " + name + " twice", "name each function once");
        }
        functions.push_back(name);
    }
    const bool alone = std::any_of(functions.begin(), functions.end(),
                                   [](const std::string& name) { return name == "K" || name == "F"; });
    if (functions.empty() || list.ends_with(',')) {
        throw input_error("table", list, "has an empty item", "write pendulum, am, sn, cn, dn, K or F");
    }
    if (alone && functions.size() > 1) {
        throw input_error("table", list, "mixes functions of different arguments", "name K and F alone");
    }
    return functions;
}

table function_table(const std::vector<std::string>& functions, const option_words& said, long digits,
                     input_style style, int jobs) {
    const auto request = read_elliptic(functions, said, elliptic_grid::lists);
    const std::size_t cells = request.parameters.size() * request.arguments.size();
    if (cells > static_cast<std::size_t>(most_grid_values)) {
        throw input_error(request.option, *said[request.option],
                          fmt::format("makes more than {} rows", most_grid_values), "choose fewer values");
    }
    progress shown("table", cells);
    const auto parts = parallel_map(cells, jobs, shown, [&](std::size_t i) {
        const function_rows at(request, request.parameters[i / request.arguments.size()],
                               request.arguments[i % request.arguments.size()], digits);
        return style == input_style::typed ? at.typed() : at.decimals();
    });
    table data(columns_of(request, style));
    for (const auto& part : parts) {
        for (const table_row_cells& row : part) {
            data.add_row(row);
        }
    }
    return data;
}

}  // namespace libration
