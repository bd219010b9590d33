#include "sweep/equation_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "libration/scalar/text/near_word.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

const equation_study* equation_study_named(const std::string& name) {
    const auto all = all_equation_studies();
    const auto found = std::ranges::find_if(all, [&](const equation_study* each) { return each->name == name; });
    return found == all.end() ? nullptr : *found;
}

bool is_study(const std::string& name) {
    const auto all = all_studies();
    return std::ranges::any_of(all, [&](const study* each) { return each->name == name; });
}

// A study whose own axis are problems of the catalogue, to which --problem is one of them.
const study* study_of_catalogue(const std::string& name) {
    for (const study* each : all_studies()) {
        const bool takes_names =
            std::ranges::any_of(each->parameters, [](const study_parameter& p) { return p.option == "--problems"; });
        if (each->name == name && takes_names) {
            return each;
        }
    }
    return nullptr;
}

std::string names_for_equations() {
    std::string names;
    for (const equation_study* each : all_equation_studies()) {
        names += (names.empty() ? "" : ", ") + each->name;
    }
    return names;
}

const equation_study& for_equation(const std::string& option, const std::string& name, const equation_words& asked) {
    if (const auto* const found = equation_study_named(name)) {
        return *found;
    }
    if (!is_study(name)) {
        study_named(option, name);  // refuses
    }
    throw input_error("--problem", asked.problem, "is nothing for the study " + name,
                      "leave it out, or choose one of " + names_for_equations());
}

// The words of a command between the blanks, blanks within double quotes left.
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

std::shared_ptr<const study> study_about(const equation_study& what, const shared_problem& equation) {
    auto result = std::make_shared<study>();
    result->name = what.name + "-" + equation->name;
    result->title = what.title + ": " + equation->name;
    result->question = what.question;
    result->reading = what.reading;
    result->of = &equation->axes;
    for (const set_axis& each : equation->sets) {
        result->parameters.push_back({each.option(), each.words, each.name + " of the problem"});
    }
    result->parameters.insert(result->parameters.end(), what.parameters.begin(), what.parameters.end());
    result->parameters.push_back({"--unknowns", "", "unknowns of the problem; all where nothing is said"});
    result->seconds = what.seconds;
    result->plan = [plan = what.plan, equation](const study_request& request) { return plan(equation, request); };
    result->version = what.version;
    result->offers = what.offers;
    result->alone = what.alone;
    result->script = "equation/" + what.name;
    result->command = what.name + " " + equation->command();
    result->equation = equation;
    return result;
}

study_order order_asked(const std::string& option, const std::string& name, const std::optional<equation_words>& asked,
                        const study_words& words, int jobs) {
    if (!asked) {
        if (!is_study(name) && equation_study_named(name) != nullptr) {
            throw input_error(option, name, "is a study of equations and there is none", "add --problem P");
        }
        return order_of(study_named(option, name), words, jobs);
    }
    if (const study* const of_catalogue = study_of_catalogue(name); of_catalogue != nullptr && asked->sets.empty()) {
        study_words all = words;
        all["--problems"] = asked->problem;
        return order_of(*of_catalogue, all, jobs);
    }
    const equation_study& what = for_equation(option, name, *asked);
    auto about = study_about(what, sweep_problem(asked->problem, asked->sets));
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

study_order example_of(const equation_study& what, int jobs) {
    return order_asked("study", what.name, what.example, what.example_words, jobs);
}

const std::vector<study_order>& example_orders() {
    static const std::vector<study_order> all = [] {
        std::vector<study_order> orders;
        for (const equation_study* each : all_equation_studies()) {
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
