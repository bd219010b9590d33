#include "verify/function_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "libration/scalar/text/written_number.hpp"
#include "motion/motion_cells.hpp"
#include "table/elliptic_request.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;

namespace {

constexpr std::array<const char*, 3> moduli{"k", "m", "m1"};
constexpr std::array<const char*, 4> inputs{"u", "phi", "x", "n"};

}  // namespace

std::vector<known_column> function_layout::known() {
    std::vector<known_column> columns;
    for (const char* const name : inputs) {
        columns.push_back({name});
    }
    for (const char* const name : moduli) {
        columns.push_back({name});
    }
    for (const named_function& each : named_functions()) {
        columns.push_back({each.name});
    }
    return columns;
}

bool function_layout::fits(const column_names& names) {
    const auto is_there = [&](std::string_view name) { return names.find(name).has_value(); };
    return std::any_of(moduli.begin(), moduli.end(), is_there) &&
           std::any_of(named_functions().begin(), named_functions().end(),
                       [&](const named_function& each) { return is_there(each.name); });
}

function_layout::function_layout(const column_names& names) : names_(names) {
    for (const char* const name : moduli) {
        const auto at = names.find(name);
        if (at && !modulus_.empty()) {
            throw input_error(fmt::format("{} has both '{}' and '{}': leave one out by --columns {}=-", names.file(),
                                          modulus_, name, names.own(*at)));
        }
        modulus_ = at ? name : modulus_;
        modulus_at_ = at.value_or(modulus_at_);
    }
    for (const named_function& each : named_functions()) {
        const auto at = names.find(each.name);
        if (!at) {
            continue;
        }
        const auto argument = each.argument.empty() ? std::nullopt : names.find(each.argument);
        const auto characteristic = each.has_characteristic ? names.find("n") : std::nullopt;
        if (!each.argument.empty() && !argument && !each.may_be_complete) {
            throw input_error(fmt::format("{} has no column '{}', the argument of {}: its columns are {}", names.file(),
                                          each.argument, each.name, names.listed()));
        }
        if (each.has_characteristic && !characteristic) {
            throw input_error(fmt::format("{} has no column 'n', the characteristic of {}: its columns are {}",
                                          names.file(), each.name, names.listed()));
        }
        functions_.push_back({&each, argument, characteristic});
        compared_.push_back({std::string(each.name), *at});
    }
}

exact function_layout::number_in(const std::vector<std::string>& cells, std::size_t at, bool as_double) const {
    return reading_cell({trimmed(cells[at]), names_.own(at)}, [&](const std::string& text) {
        if (text.empty()) {
            throw error(error_kind::argument, "number", text, "is empty");
        }
        const exact number = read_typed(text);
        return as_double ? nearest_double(number) : number;
    });
}

std::vector<function_layout::question> function_layout::read(const std::vector<std::string>& cells,
                                                             bool as_doubles) const {
    const exact typed = number_in(cells, modulus_at_, as_doubles);
    if (!typed.is_number()) {
        throw error(error_kind::argument, names_.own(modulus_at_), typed.text, "has a unit");
    }
    const typed_parameter parameter = reading_cell({typed.text, names_.own(modulus_at_)},
                                                   [&](const std::string&) { return parameter_of(modulus_, typed); });
    std::vector<question> questions;
    for (const function_column& each : functions_) {
        elliptic_point at{std::nullopt, parameter, std::nullopt};
        if (each.argument) {
            at.argument = number_in(cells, *each.argument, as_doubles);
            require_argument(std::string(each.function->argument), *at.argument);
        }
        if (each.characteristic) {
            at.characteristic = number_in(cells, *each.characteristic, as_doubles);
        }
        questions.emplace_back(each.function, std::move(at));
    }
    return questions;
}

row_question function_questions::read(const std::vector<std::string>& cells) {
    const auto asked =
        std::make_shared<const std::vector<function_layout::question>>(layout_.read(cells, rules_.inputs_are_doubles));
    row_question question;
    question.first_digits = [](long places) { return (places + 29) / 10 * 10; };
    question.truths = [asked](long /*digits*/) {
        std::vector<true_value> truths;
        for (const auto& [function, at] : *asked) {
            truths.push_back(value_at(*function, at));
        }
        return truths;
    };
    question.condition = [asked](long /*digits*/) {
        return condition_text(*asked->front().first, asked->front().second);
    };
    return question;
}

}  // namespace libration
