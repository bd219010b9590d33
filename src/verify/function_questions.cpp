#include "verify/function_questions.hpp"

#include <algorithm>
#include <memory>

namespace libration {

using namespace elliptic;

std::vector<known_column> function_layout::known() {
    auto columns = elliptic_columns::known();
    for (const named_function& each : named_functions()) {
        columns.push_back({each.name});
    }
    return columns;
}

bool function_layout::fits(const column_names& names) {
    return elliptic_columns::has_modulus(names) &&
           std::any_of(named_functions().begin(), named_functions().end(),
                       [&](const named_function& each) { return names.find(each.name).has_value(); });
}

function_layout::function_layout(const column_names& names) {
    for (const named_function& each : named_functions()) {
        if (const auto at = names.find(each.name)) {
            functions_.emplace_back(&each, elliptic_columns(names, each));
            compared_.push_back({std::string(each.name), *at});
        }
    }
}

std::vector<function_layout::question> function_layout::read(const std::vector<std::string>& cells,
                                                             bool as_doubles) const {
    std::vector<question> questions;
    questions.reserve(functions_.size());
    for (const auto& [function, columns] : functions_) {
        questions.emplace_back(function, columns.read(cells, as_doubles));
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
