// libration studies: each study with its question, its parameters and its cost; one of them in detail.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "sweep/named_order.hpp"
#include "sweep/study_files.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

std::string text_of(const std::vector<study_parameter>& parameters) {
    std::string text;
    for (const study_parameter& parameter : parameters) {
        text += fmt::format("    {:<12} {}\n    {:<12}   {}\n", parameter.option, parameter.usual_text(), "",
                            parameter.meaning);
    }
    return text;
}

std::string cost_text(double seconds) { return fmt::format("    {:<12} {:.1f} s on two cores\n", "cost", seconds); }

// The description of a study with its own problem.
std::string own_text_of(const study& each) {
    return each.needs_equation() ? "" : text_of(each.parameters) + cost_text(each.seconds);
}

// Its description with --problem.
std::string equation_text_of(const study& each) {
    const equation_form& form = *each.any_equation;
    const std::string command = example_of(each, 1).command;
    return fmt::format("  with --problem P\n{}{}    {:<12} {}\n",
                       form.question.empty() ? "" : fmt::format("    {}\n", form.question), text_of(form.parameters),
                       "example", command) +
           cost_text(form.seconds);
}

std::string text_of(const study& each) {
    return fmt::format("{}{}\n    {}\n", each.name, each.label.empty() ? "" : "  [paper " + each.label + "]",
                       each.question) +
           own_text_of(each) + (each.any_equation ? equation_text_of(each) : "");
}

// The further description of a single study.
std::string more_text_of(const study& each) {
    if (each.needs_equation()) {
        return "";
    }
    std::string text;
    for (const without_answer& left : each.excluded) {
        text += fmt::format("    {:<12} {}: {}\n", "undefined", left.coordinate, left.reason);
    }
    std::string quick;
    for (const study_parameter& parameter : each.quick) {
        quick += fmt::format(" {} {}", parameter.option, parameter.usual);
    }
    return text +
           fmt::format(
               "    {0:<12} {1}\n    {2:<12} libration study {3} --out out\n    {4:<12} libration study {3}{5}\n",
               "title", each.title, "run it", each.name, "quickly", quick);
}

nlohmann::ordered_json or_null(const std::string& text) {
    return text.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(text);
}

nlohmann::ordered_json json_of(const std::vector<study_parameter>& parameters) {
    auto list = nlohmann::ordered_json::array();
    for (const study_parameter& each : parameters) {
        list.push_back({{"option", each.option}, {"usual", or_null(each.usual)}, {"meaning", each.meaning}});
    }
    return list;
}

// The description of a study with --problem; null for one that supports only its own problem.
nlohmann::ordered_json equation_json_of(const study& each) {
    if (!each.any_equation) {
        return nullptr;
    }
    const equation_form& form = *each.any_equation;
    return {{"question", form.question.empty() ? each.question : form.question},
            {"seconds", form.seconds},
            {"example", example_of(each, 1).command},
            {"parameters", json_of(form.parameters)}};
}

nlohmann::ordered_json json_of(const study& each) {
    return {{"name", each.name},
            {"title", each.title},
            {"figure", or_null(each.label)},
            {"question", each.question},
            {"seconds", each.needs_equation() ? each.any_equation->seconds : each.seconds},
            {"proved", each.offers == arithmetics::proved_too},
            {"parameters", json_of(each.parameters)},
            {"with problem", equation_json_of(each)}};
}

struct studies_options {
    std::optional<std::string> name;
    std::string format = "text";
};

int list_studies(const studies_options& options) {
    const auto chosen =
        options.name ? std::vector<const study*>{&study_named("studies", *options.name)} : all_studies();
    if (options.format == "json") {
        auto list = nlohmann::ordered_json::array();
        for (const study* each : chosen) {
            list.push_back(json_of(*each));
        }
        write_to_stdout(list.dump(2) + '\n');
        return 0;
    }
    if (options.format != "text") {
        throw input_error("--format", options.format, "is not a format", "write text or json");
    }
    std::string text;
    for (const study* each : chosen) {
        text += text_of(*each) + (options.name ? more_text_of(*each) : "");
    }
    write_to_stdout(text);
    return 0;
}

}  // namespace

subcommand studies_command(CLI::App& program) {
    const auto options = std::make_shared<studies_options>();
    CLI::App* command = program.add_subcommand("studies", "list the studies: question, parameters, cost");
    command->add_option("NAME", options->name, "this study alone, in detail");
    command->add_option("--format", options->format, "text or json")->type_name("FORMAT")->capture_default_str();
    return {command, [options] { return list_studies(*options); }};
}

}  // namespace libration
