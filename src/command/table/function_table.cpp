#include "table/function_table.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

#include "run/parallel.hpp"
#include "table/elliptic_request.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;

namespace {

std::string meaning_of_condition(const elliptic_request& request) {
    const std::string argument = request.has_characteristic() ? "|phi df/dphi| + |n df/dn|"
                                 : request.is_complex()       ? "|u_re df/du_re| + |u_im df/du_im|"
                                                              : "|u df/du|";
    return "(" + argument + " + |x df/dx|)/|f|, x = " + request.modulus + ", heuristic, three digits";
}

std::vector<column> typed_columns(const elliptic_request& request) {
    std::vector<column> columns{{"function", ""},
                                {"argument", "as typed"},
                                {request.modulus, "as typed"},
                                {"value", ""},
                                {"condition", meaning_of_condition(request)},
                                {"digits", "significant digits"},
                                {"rigour", "of the value"}};
    if (request.has_characteristic()) {
        columns.push_back({"n", "as typed"});
    }
    if (request.is_complex()) {
        columns[3].meaning = "its real part";
        columns.push_back({"imaginary", "part of the value"});
    }
    return columns;
}

std::vector<column> decimal_columns(const elliptic_request& request) {
    std::vector<column> columns;
    if (request.is_complex()) {
        columns.push_back({request.argument + "_re", "argument, real part"});
        columns.push_back({request.argument + "_im", "argument, imaginary part"});
    } else if (!request.argument.empty()) {
        columns.push_back({request.argument, "argument"});
    }
    if (request.has_characteristic()) {
        columns.push_back({"n", "characteristic"});
    }
    columns.push_back({request.modulus, ""});
    for (const named_function* const function : request.functions) {
        const std::string name(function->name);
        if (request.is_complex()) {
            columns.push_back({name + "_re", "real part"});
            columns.push_back({name + "_im", "imaginary part"});
        } else {
            columns.push_back({name, ""});
        }
    }
    for (const named_function* const function : request.functions) {
        columns.push_back({"condition_" + std::string(function->name), meaning_of_condition(request)});
    }
    return columns;
}

// The rows of one point.
class function_rows {
public:
    function_rows(const elliptic_request& request, const elliptic_point& at, long digits)
        : request_(request), at_(at), digits_(digits) {}

    std::vector<table_row_cells> typed() const {
        std::vector<table_row_cells> rows;
        rows.reserve(request_.functions.size());
        for (const named_function* const function : request_.functions) {
            const auto value = value_of(*function);
            table_row_cells row{std::string(function->name),
                                at_.argument ? read_cell(at_.argument->text) : cell(),
                                read_cell(at_.parameter.typed.text),
                                number_cell(value[0]),
                                number_cell(condition_of(*function, at_)),
                                digits_,
                                "proved"};
            if (at_.characteristic) {
                row.push_back(read_cell(at_.characteristic->text));
            }
            if (request_.is_complex()) {
                row.push_back(number_cell(value[1]));
            }
            rows.push_back(std::move(row));
        }
        return rows;
    }

    std::vector<table_row_cells> decimals() const {
        table_row_cells row;
        const auto imaginary = request_.is_complex() ? std::optional(at_.imaginary.value_or(exactly(0))) : std::nullopt;
        for (const auto& input : {at_.argument, imaginary, at_.characteristic, std::optional(at_.parameter.typed)}) {
            if (input) {
                row.push_back(number_cell(decimal_text(*input, digits_ + more_input_digits)));
            }
        }
        for (const named_function* const function : request_.functions) {
            const auto value = value_of(*function);
            row.push_back(number_cell(value[0]));
            if (request_.is_complex()) {
                row.push_back(number_cell(value[1]));
            }
        }
        for (const named_function* const function : request_.functions) {
            row.push_back(number_cell(condition_of(*function, at_)));
        }
        return {row};
    }

private:
    std::array<std::string, 2> value_of(const named_function& function) const {
        return answer_at(request_, at_, [&] { return texts_of(function, at_, digits_); });
    }

    const elliptic_request& request_;
    const elliptic_point& at_;
    long digits_;
};

}  // namespace

std::vector<const named_function*> functions_of(const std::string& list) {
    std::vector<const named_function*> functions;
    std::istringstream names(list);
    const std::string remedy = "write pendulum, " + elliptic_names();
    for (std::string name; std::getline(names, name, ',');) {
        const named_function* const function = find_function(name);
        if (function == nullptr) {
            throw input_error("table", list, "is not a function", remedy);
        }
        if (std::find(functions.begin(), functions.end(), function) != functions.end()) {
            throw input_error("table", list, "names " + name + " twice", "name each function once");
        }
        functions.push_back(function);
    }
    if (functions.empty() || list.ends_with(',')) {
        throw input_error("table", list, "has an empty item", remedy);
    }
    const named_function& first = *functions.front();
    for (const named_function* const each : functions) {
        if (each->argument != first.argument || each->has_characteristic != first.has_characteristic ||
            each->of_nome != first.of_nome || each->may_be_complete != first.may_be_complete) {
            throw input_error("table", list, "mixes functions of different arguments",
                              "name functions of u, of phi, of x, or K and nome alone");
        }
    }
    return functions;
}

table function_table(const std::vector<const named_function*>& functions, const option_words& said, long digits,
                     input_style style, int jobs) {
    const auto request = read_elliptic(functions, said, elliptic_grid::lists);
    progress shown("table", request.points.size());
    const auto parts = parallel_map(request.points.size(), jobs, shown, [&](std::size_t i) {
        const function_rows at(request, request.points[i], digits);
        return style == input_style::typed ? at.typed() : at.decimals();
    });
    table data(style == input_style::typed ? typed_columns(request) : decimal_columns(request));
    for (const auto& part : parts) {
        for (const table_row_cells& row : part) {
            data.add_row(row);
        }
    }
    return data;
}

}  // namespace libration
