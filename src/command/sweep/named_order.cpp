#include "sweep/named_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "libration/scalar/near_word.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"
#include "text/members.hpp"

namespace libration {

namespace {

bool is_study(const std::string& name) {
    return std::ranges::any_of(all_studies(), [&](const study* each) { return each->name == name; });
}

// Whether the axis of a study is the problems of the catalogue, so that --problem is one of them.
bool is_of_catalogue(const study& what) {
    return std::ranges::any_of(what.parameters, [](const study_parameter& p) { return p.option == "--problems"; });
}

void require_any_equation(const study& what, const equation_words& asked) {
    if (what.any_equation) {
        return;
    }
    const auto names = members_of(studies_of_equations(), &study::name);
    throw input_error("--problem", asked.problem, "is not supported by the study " + what.name,
                      fmt::format("leave it out, or choose one of {}", fmt::join(names, ", ")));
}

// The words of a command, split at blanks, except within double quotes.
std::vector<std::string> split_command(const std::string& text) {
    std::vector<std::string> items;
    std::string item;
    bool within = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        within = text[i] == '"' ? !within : within;
        if (!within && text.compare(i, 3, " --") == 0) {
            items.push_back(std::exchange(item, {}));
            continue;
        }
        item += text[i];
    }
    items.push_back(item);
    return items;
}

}  // namespace

std::vector<const study*> studies_of_own_problems() {
    auto all = all_studies();
    std::erase_if(all, [](const study* each) { return each->needs_equation(); });
    return all;
}

std::vector<const study*> studies_of_equations() {
    auto all = all_studies();
    std::erase_if(all, [](const study* each) { return !each->any_equation; });
    return all;
}

std::shared_ptr<const study> study_about(const study& what, const shared_problem& equation) {
    const equation_form& form = *what.any_equation;
    const auto own = [](const std::string& differs, const std::string& same) {
        return differs.empty() ? same : differs;
    };
    auto result = std::make_shared<study>();
    result->name = what.name + "-" + equation->name;
    result->title = own(form.title, what.title) + ": " + equation->name;
    result->question = own(form.question, what.question);
    result->reading = own(form.reading, what.reading);
    result->of = &equation->axes;
    for (const set_axis& each : equation->sets) {
        result->parameters.push_back({each.option(), each.words, each.name + " of the problem"});
    }
    result->parameters.insert(result->parameters.end(), form.parameters.begin(), form.parameters.end());
    result->parameters.push_back({"--unknowns", "", "unknowns of the problem; default all"});
    result->seconds = form.seconds;
    result->plan = [plan = form.plan, equation](study_request request) {
        request.equation = equation;
        return plan(request);
    };
    result->version = what.version;
    result->offers = what.offers;
    result->several_scalars = what.several_scalars;
    result->alone = what.alone;
    result->script = what.name;
    result->command = what.name + " " + equation->command();
    result->equation = equation;
    result->remarks = form.remarks;
    return result;
}

study_order order_asked(const std::string& option, const std::string& name, const std::optional<equation_words>& asked,
                        const study_words& words, int jobs) {
    const study& what = study_named(option, name);
    if (!asked) {
        if (what.needs_equation()) {
            throw input_error(option, name, "requires an equation", "add --problem P");
        }
        return order_of(what, words, jobs);
    }
    if (is_of_catalogue(what) && asked->sets.empty()) {
        study_words all = words;
        all["--problems"] = asked->problem;
        return order_of(what, all, jobs);
    }
    require_any_equation(what, *asked);
    const auto equation = sweep_problem(asked->problem, asked->sets);
    if (!equation->limits.empty() && !what.any_equation->at_infinity) {
        throw input_error("--problem", asked->problem,
                          "has conditions at infinity, which " + what.name + " does not support",
                          "leave them out, or use the study error_norm");
    }
    auto about = study_about(what, equation);
    study_order order = order_of(*about, words, jobs);
    order.made = std::move(about);
    return order;
}

study_order order_from(const std::string& command, int jobs) {
    constexpr std::string_view opening = "libration study ";
    if (!command.starts_with(opening)) {
        throw std::runtime_error("the command '" + command + "' of a journal cannot be read");
    }
    auto items = split_command(command.substr(opening.size()));
    std::optional<equation_words> asked;
    study_words words;
    for (std::size_t i = 1; i < items.size(); ++i) {
        const std::size_t between = std::min(items[i].find_first_of(" ="), items[i].size());
        const std::string name = items[i].substr(0, between);
        const std::string value = between == items[i].size() ? "" : unquoted_word(items[i].substr(between + 1));
        if (name == "--problem") {
            asked.emplace().problem = value;
        } else if (name == "--set" && asked) {
            asked->sets.push_back(value);
        } else {
            words[name] = value;
        }
    }
    return order_asked("the study of a journal", items.front(), asked, words, jobs);
}

study_order example_of(const study& what, int jobs) {
    return order_asked("study", what.name, what.any_equation->example, what.any_equation->example_words, jobs);
}

const std::vector<study_order>& example_orders() {
    static const std::vector<study_order> all = [] {
        std::vector<study_order> orders;
        for (const study* each : studies_of_equations()) {
            orders.push_back(example_of(*each, 1));
        }
        return orders;
    }();
    return all;
}

std::shared_ptr<const study> study_in(const std::string& option, const std::string& name, const std::string& folder) {
    namespace fs = std::filesystem;
    if (!is_study(name) && name.find('-') != std::string::npos) {
        std::ifstream file(fs::path(folder) / name / (name + ".json"), std::ios::binary);
        const auto description = nlohmann::json::parse(file, nullptr, false);
        const std::string command = description.is_object() ? description.value("command", "") : "";
        if (!command.empty()) {
            return order_from(command, 1).made;
        }
    }
    return {&study_named(option, name), [](const study*) {}};
}

}  // namespace libration
