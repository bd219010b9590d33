#include "problem_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "change_words.hpp"
#include "libration/equation/delay_system.hpp"
#include "libration/equation/renamed_unknowns.hpp"
#include "libration/equation/text/parse.hpp"
#include "libration/equation/unused_parameters.hpp"
#include "libration/hybrid/initial_mode.hpp"
#include "libration/number/grid.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/near_word.hpp"
#include "run/stream_content.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

std::string text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path)) {
        throw input_error("--problem", path, "cannot be read",
                          "give a file, a name of `libration problems` or a text with =");
    }
    std::string text = content_of(file, path, ode::longest_problem);
    if (text.size() > ode::longest_problem) {
        throw input_error("--problem", path, fmt::format("is longer than {} characters", ode::longest_problem),
                          "shorten it, with parameters for repeated parts");
    }
    return text;
}

std::string text_of_catalogue(const std::string& name) {
    std::vector<std::string> names;
    for (const catalogue_entry& each : catalogue()) {
        names.emplace_back(each.name);
    }
    if (std::ranges::find(names, name) == names.end()) {
        throw input_error("--problem", name, "is not in the catalogue" + suggestion(name, names),
                          "give a name of `libration problems`, a file with a / or .ode, or a text with =");
    }
    return std::string(problem_text(name));
}

// The text of a problem with a statement added; the statement alone if the problem is not typed, or is long.
std::string with_statement(const std::string& words, const std::string& statement) {
    const bool shown = words.find('=') != std::string::npos && words.size() <= longest_quotation &&
                       words.find('\n') == std::string::npos;
    return shown ? words + "; " + statement : statement;
}

// Throws input_error for parameters that neither the text nor --set gives.
void require_parameters(const ode::equation_system& system, const std::string& words) {
    if (!system.open.empty()) {
        const ode::open_parameter& open = system.open.front();
        throw input_error(fmt::format(
            "--problem {0} at line {1}, column {2} has no value: add --set {3}=NUMBER, or write {4} for a parameter, "
            "{3}' = ... for an unknown{5}",
            quotation(open.name), open.at.line, open.at.column, open.name,
            with_statement(words, open.name + " = NUMBER"),
            system.variable == "t" ? fmt::format(", variable {} for the independent variable", open.name) : ""));
    }
}

// The same for parameters and initial values.
void require_values(const ode::equation_system& system, const std::string& words) {
    require_parameters(system, words);
    const auto is_delayed = [&](const std::string& name) {
        return std::ranges::find(system.histories, name, &ode::history::unknown) != system.histories.end() ||
               std::ranges::any_of(system.delays, [&](const auto& each) { return each.of.name() == name; });
    };
    const auto highest = system.highest_derivatives();
    for (const std::string& name : system.unknowns()) {
        for (int order = 0; order < highest.at(name); ++order) {  // none of an algebraic unknown
            const auto of = ode::unknown(name, order);
            if (is_delayed(name) ||
                std::ranges::any_of(system.starts, [&](const ode::start& s) { return same_form(s.of, of); })) {
                continue;
            }
            const std::string value = ode::primed(name, order) + "(0) = NUMBER";
            throw input_error(fmt::format("--problem {} has no initial value: add --set \"{}\", or write {}",
                                          quotation(ode::primed(name, order)), value, with_statement(words, value)));
        }
    }
}

}  // namespace

problem_source problem_named(const std::string& words) {
    if (words.find('=') != std::string::npos) {
        return {"typed", words};
    }
    if (words.find('/') != std::string::npos || words.ends_with(".ode")) {
        return {std::filesystem::path(words).stem().string(), text_of_file(words)};
    }
    return {words, text_of_catalogue(words)};
}

void problem_options::add_to(CLI::App& command, closed_forms known, set_values sets) {
    command_ = &command;
    command
        .add_option("--problem", problem_,
                    "any equation: a name of the catalogue, a file, or \"y' = 2y; y(0) = 1\", also dy/dt = ..., y'(x) "
                    "= ..., e^t, "
                    "x^2 or x\u00b2, with the functions " +
                        function_names() + " and abs, max, mod, atan2, if(x > 0, a, b), ... (docs/equations.md)")
        ->type_name("P");
    const std::string of_families = sets == set_values::lists ? "; k=1,2,3 or k=1:3:5 for a family" : "";
    command
        .add_option("--set", changes_,
                    "set or override a parameter or an initial value: k=1/3, \"f'(0)=1\"" + of_families)
        ->type_name("X=VALUE");
    command
        .add_option("--show", shown_,
                    "also print named expressions of the problem, e.g. r for r = k*x*y; separate several by commas")
        ->delimiter(',')
        ->type_name("NAMES");
    if (known == closed_forms::used) {
        command.add_flag("--general", general_, "integrate by Taylor series even where a closed form is known");
    }
}

std::string problem_options::heading() const {
    constexpr std::size_t longest = 72;
    const std::string& words = with_limits_ ? *with_limits_ : *problem_;
    const problem_source of = problem_named(words);
    std::string line = of.text.substr(0, of.text.find('\n'));
    const bool typed = of.text == words && line == of.text;
    const bool commented = words.find('/') != std::string::npos || words.ends_with(".ode");
    if (!typed) {
        line = commented && line.starts_with('#') ? trimmed(line.substr(1)) : "";
    }
    return line.empty() || line.size() > longest ? of.name : line;
}

std::unique_ptr<libration::solution> problem_options::solution(bool general) const {
    const libration::problem asked(equations());
    auto found = naming([&] { return solve(asked, {.general = general || general_}); });
    if (!found->closed_form().empty() && !announced_) {
        fmt::print(stderr,
                   "libration: the equations are those of {}: its closed form is used (Taylor series with --general)\n",
                   found->closed_form());
    }
    return found;
}

std::unique_ptr<libration::solution> problem_options::general_solution() const {
    const libration::problem asked(equations());
    return naming([&] { return solve(asked, {.general = true}); });
}

namespace {

// Whether the text of --set has several values: a comma or a colon outside of parentheses and brackets, and no further
// equation.
bool is_list(std::string_view values) {
    int depth = 0;
    return values.find('=') == std::string_view::npos && std::ranges::any_of(values, [&](char c) {
               depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
               return depth == 0 && (c == ',' || c == ':');
           });
}

}  // namespace

std::vector<family_member> problem_options::family(std::size_t most) const {
    std::vector<family_member> all{{{}, *this}};
    for (std::size_t i = 0; i < changes_.size(); ++i) {
        const std::string& change = changes_[i];
        const auto equals = change.find('=');
        if (equals == std::string::npos || !is_list(std::string_view(change).substr(equals + 1))) {
            continue;
        }
        const auto values = reading("--set", change, "write NAME=1/2,1,2 or NAME=a:b:count",
                                    [&] { return read_grid(change.substr(equals + 1)); });
        if (all.size() * values.size() > most) {
            throw input_error("--set", change, fmt::format("makes more than {} solutions", most), "write fewer values");
        }
        const std::string name = trimmed(change.substr(0, equals));
        std::vector<family_member> more;
        for (const family_member& each : all) {
            for (const exact& value : values) {
                more.push_back(each);
                more.back().values.emplace_back(name, value.text);
                more.back().problem.changes_[i] = name + " = " + value.text;
            }
        }
        all = std::move(more);
    }
    for (std::size_t i = 1; i < all.size(); ++i) {
        all[i].problem.announced_ = true;
    }
    return all;
}

void warn_of_unused_parameters(const std::string& written) {
    for (const std::string& name : ode::unused_parameters(written)) {
        fmt::print(stderr, "libration: warning: --problem defines {}, which is not used: leave it out\n",
                   quotation(name));
    }
}

// Once, taking into account the conditions and names of other options.
void problem_options::warn_of_unused(const std::string& written) const {
    if (std::exchange(*warned_, true)) {
        return;
    }
    for (const auto& [name, column] : ode::renamed_unknowns(written)) {
        fmt::print(stderr, "libration: the unknown {} is in the column {}, since {} is another column of tables\n",
                   quotation(name), quotation(column), quotation(name));
    }
    std::string used = written;
    for (const std::string& each : limits_) {
        used += "\ninvariant " + each.substr(each.find('=') + 1);
    }
    for (const char* option : {"--until", "--such-that"}) {
        const CLI::Option* const conditions = command_->get_option_no_throw(option);
        for (const std::string& each : conditions == nullptr ? std::vector<std::string>() : conditions->results()) {
            used += "\n" + each;
        }
    }
    for (const std::string& each : shown_) {
        used += "\ninvariant " + each;
    }
    const CLI::Option* const period = command_->get_option_no_throw("--period");
    for (const std::string& each : period == nullptr ? std::vector<std::string>() : period->results()) {
        used += "\ninvariant " + each;
    }
    try {
        warn_of_unused_parameters(used);
    } catch (const error&) {
        // The condition cannot be read; its own option reports that.
    }
}

ode::equation_system problem_options::changed_equations(
    const std::vector<std::pair<std::string, std::string>>& by_options) const {
    const std::string written = problem_named(*problem_).text;
    auto system = naming_option("--problem", [&] { return ode::parse(written); });
    warn_of_unused(written);
    for (const auto& [option, value] : by_options) {
        system = naming_option(option, [&] { return ode::changed(system, value); });
    }
    for (const std::string& each : changes_) {
        require_changeable(system, each);
        system = naming_option("--set", [&] { return ode::changed(system, each); });
    }
    for (const std::string& each : shown_) {
        system = naming_option("--show", [&] { return ode::with_column(system, each); });
    }
    return system;
}

ode::equation_system problem_options::equations(
    const std::vector<std::pair<std::string, std::string>>& by_options) const {
    auto system = changed_equations(by_options);
    require_values(system, *problem_);
    return system;
}

ode::equation_system problem_options::equations_with_open_starts(
    const std::vector<std::pair<std::string, std::string>>& by_options) const {
    auto system = changed_equations(by_options);
    require_parameters(system, *problem_);
    return system;
}

void problem_options::state_first_branch() const {
    if (!equations().is_smooth()) {
        fmt::print(stderr,
                   "libration: the results are those of the equations as they are at the initial point, up to the "
                   "first event\n");
    }
}

ode::explicit_system problem_options::choose_first_branch() const {
    const auto system = equations();
    if (system.is_ordinary()) {
        return choose();
    }
    return naming([&] {
        if (system.has_delays()) {
            return ode::delay_system(system).first_equations();
        }
        const ode::hybrid_system hybrid(system);
        return hybrid.first_branch(ode::values_at_start(hybrid));
    });
}

ode::explicit_system problem_options::choose() const {
    const auto system = equations();
    return naming([&] { return ode::explicit_system(system); });
}

}  // namespace libration
