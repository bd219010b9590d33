#include "verify/function_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;

namespace {

// The columns of one function: its value, and the parts of a complex one.
struct value_names {
    std::string_view whole;
    std::string real = std::string(whole) + "_re";
    std::string imaginary = std::string(whole) + "_im";
};

// Of each function, in the order of named_functions(). A known_column refers to its name.
const std::deque<value_names>& all_value_names() {
    static const auto all = [] {
        std::deque<value_names> names;
        for (const named_function& each : named_functions()) {
            names.push_back({each.name});
        }
        return names;
    }();
    return all;
}

// The parts of a value that is complex; 0 is measured by the size of the whole.
std::array<true_value, 2> parts_of(const named_function& function, const elliptic_point& at) {
    const auto value = complex_value_at(function, at);
    if (!value) {
        const true_value pole{ball(0), std::nullopt, ball(1), 1};
        return {pole, pole};
    }
    const ball size = sqrt(ball(value->real * value->real + value->imaginary * value->imaginary));
    return {true_value{value->real, std::nullopt, size}, true_value{value->imaginary, std::nullopt, size}};
}

}  // namespace

std::vector<known_column> function_layout::known() {
    auto columns = elliptic_columns::known();
    for (std::size_t i = 0; i < named_functions().size(); ++i) {
        columns.push_back({all_value_names()[i].whole});
        if (takes_complex(named_functions()[i])) {
            columns.push_back({all_value_names()[i].real});
            columns.push_back({all_value_names()[i].imaginary});
        }
    }
    return columns;
}

bool function_layout::fits(const column_names& names) {
    const auto has = [&](const named_function& each) {
        const value_names own{each.name};
        return names.find(own.whole) || (takes_complex(each) && (names.find(own.real) || names.find(own.imaginary)));
    };
    return elliptic_columns::has_modulus(names) || std::any_of(named_functions().begin(), named_functions().end(), has);
}

function_layout::function_layout(const column_names& names) {
    for (const named_function& each : named_functions()) {
        const value_names own{each.name};
        const bool complex = takes_complex(each);
        const auto whole = names.find(own.whole);
        const auto real = complex ? names.find(own.real) : std::nullopt;
        const auto imaginary = complex ? names.find(own.imaginary) : std::nullopt;
        if (whole && (real || imaginary)) {
            throw input_error(fmt::format("{} has both '{}' and '{}': leave one out by --columns {}=-", names.file(),
                                          names.own(*whole), names.own(real ? *real : *imaginary), names.own(*whole)));
        }
        if (whole || real || imaginary) {
            functions_.push_back({&each, elliptic_columns(names, each), real.has_value(), imaginary.has_value()});
        }
        for (const auto& [name, at] : {std::pair(std::string(own.whole), whole), std::pair(own.real, real),
                                       std::pair(own.imaginary, imaginary)}) {
            if (at) {
                compared_.push_back({name, *at});
            }
        }
    }
    if (compared_.empty()) {
        throw input_error(
            fmt::format("{} has no column of an elliptic function: its columns are {}: {}, as 'sn' or 'K'",
                        names.file(), names.listed(), mapping_remedy));
    }
}

std::vector<function_question> function_layout::read(const std::vector<std::string>& cells, bool as_doubles) const {
    std::vector<function_question> questions;
    questions.reserve(functions_.size());
    for (const asked_function& each : functions_) {
        elliptic_point at = each.columns.read(cells, as_doubles);
        const bool in_parts = each.real || each.imaginary;
        if (at.imaginary && !in_parts) {
            throw error(error_kind::argument, {error_subject::argument, "u"}, at.argument->text,
                        fmt::format("is complex: give the columns {0}_re and {0}_im", each.function->name));
        }
        if (in_parts && !at.imaginary) {
            at.imaginary = exactly(0);
        }
        questions.push_back({each.function, std::move(at), each.real, each.imaginary});
    }
    return questions;
}

std::vector<true_value> function_question::truths() const {
    if (!real && !imaginary) {
        return {value_at(*function, at)};
    }
    const auto parts = parts_of(*function, at);
    std::vector<true_value> asked;
    if (real) {
        asked.push_back(parts[0]);
    }
    if (imaginary) {
        asked.push_back(parts[1]);
    }
    return asked;
}

row_question function_questions::read(const std::vector<std::string>& cells) {
    const auto asked =
        std::make_shared<const std::vector<function_question>>(layout_.read(cells, rules_.inputs_are_doubles));
    row_question question;
    question.first_digits = [](long places) { return (places + 29) / 10 * 10; };
    question.truths = [asked](long /*digits*/) {
        std::vector<true_value> truths;
        for (const function_question& each : *asked) {
            const auto values = each.truths();
            truths.insert(truths.end(), values.begin(), values.end());
        }
        return truths;
    };
    question.condition = [asked](long /*digits*/) { return condition_of(*asked->front().function, asked->front().at); };
    return question;
}

}  // namespace libration
