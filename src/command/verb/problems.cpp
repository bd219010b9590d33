// libration problems: the catalogue of differential equations, and one of them as text.
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/problem/catalogue.hpp"
#include "libration/scalar/near_word.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "problem/problem_options.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct problems_options {
    std::optional<std::string> name;
    output_options output;
};

// x y z, or y1 .. y51 if there are more than eight.
std::string joined_by_blanks(const std::vector<std::string>& words) {
    constexpr std::size_t most = 8;
    if (words.size() > most) {
        return words.front() + " .. " + words.back();
    }
    std::string line;
    for (const std::string& each : words) {
        line += (line.empty() ? "" : " ") + each;
    }
    return line;
}

table_row_cells catalogue_row(const catalogue_entry& entry) {
    const auto system = ode::parse(entry.text);
    std::vector<std::string> parameters;
    for (const auto& each : system.parameters) {
        parameters.push_back(each.name);
    }
    return {entry.name, title_of(entry), joined_by_blanks(system.unknowns()), joined_by_blanks(parameters)};
}

// A problem that is typed or in a file, in standard notation.
int write_problem(const problems_options& options) {
    const problem_source of = problem_named(*options.name);
    const auto system = naming_option("problems", [&] { return ode::parse(of.text); });
    table list({{"name", ""}, {"title", ""}, {"unknowns", ""}, {"parameters", ""}});
    std::vector<std::string> parameters;
    std::ranges::transform(system.parameters, std::back_inserter(parameters), &ode::definition::name);
    std::ranges::transform(system.open, std::back_inserter(parameters), &ode::open_parameter::name);
    list.add_row({of.name, cell(), joined_by_blanks(system.unknowns()), joined_by_blanks(parameters)});
    options.output.write(list, ode::canonical_text(of.text));
    return 0;
}

int list_problems(const problems_options& options) {
    options.output.check();
    if (options.name && (options.name->find_first_of("=/") != std::string::npos || options.name->ends_with(".ode"))) {
        return write_problem(options);
    }
    std::vector<std::string> names;
    table list({{"name", ""}, {"title", ""}, {"unknowns", ""}, {"parameters", ""}});
    for (const catalogue_entry& each : catalogue()) {
        names.emplace_back(each.name);
        if (!options.name || each.name == *options.name) {
            list.add_row(catalogue_row(each));
        }
    }
    if (list.rows().empty()) {
        throw input_error("problems", *options.name, "is not in the catalogue" + suggestion(*options.name, names),
                          "see libration problems");
    }
    if (options.name) {
        options.output.write(list, std::string(problem_text(*options.name)));
    } else {
        options.output.write(list);
    }
    return 0;
}

}  // namespace

subcommand problems_command(CLI::App& program) {
    const auto options = std::make_shared<problems_options>();
    CLI::App* command = program.add_subcommand("problems", "the catalogue of differential equations for --problem");
    command->add_option("NAME", options->name,
                        "this problem: equations, initial values, parameters, sources; of a text with = or a file, the "
                        "same in standard notation");
    options->output.add_to(*command);
    return {command, [options] { return list_problems(*options); }};
}

}  // namespace libration
