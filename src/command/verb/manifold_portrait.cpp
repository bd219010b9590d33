#include "manifold_portrait.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "libration/equation/text/parse.hpp"
#include "libration/query/connection/equilibrium_manifolds.hpp"
#include "plot/manifold_plot.hpp"
#include "text/csv_records.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr long digits_of_portrait = 10;
constexpr const char* form_of_equilibrium = "write the values of unknowns, as \"x=0,y=0\"";

// NAME=VALUE,NAME=VALUE, with commas inside of parentheses.
std::vector<std::pair<std::string, ode::expression>> values_of_equilibrium(const std::string& words) {
    std::vector<std::pair<std::string, ode::expression>> values;
    for (std::size_t begin = 0; begin <= words.size();) {
        std::size_t end = begin;
        for (int depth = 0; end < words.size() && (depth > 0 || words[end] != ','); ++end) {
            depth += words[end] == '(' ? 1 : words[end] == ')' ? -1 : 0;
        }
        const std::string item = words.substr(begin, end - begin);
        const auto equals = item.find('=');
        if (equals == std::string::npos) {
            throw input_error("--equilibrium", words, "is not NAME=VALUE", form_of_equilibrium);
        }
        values.emplace_back(trimmed(item.substr(0, equals)), reading("--equilibrium", words, form_of_equilibrium, [&] {
                                return ode::parse_constant(trimmed(item.substr(equals + 1)));
                            }));
        begin = end + 1;
    }
    return values;
}

ode::equilibrium_manifolds manifolds_by(const problem_options& problem_of, const std::string& manifold,
                                        const std::string& equilibrium) {
    const auto system = problem_of.equations_with_open_starts({});
    const auto values = values_of_equilibrium(equilibrium);
    try {
        return ode::manifolds_of(system, values, manifold != "unstable", manifold != "stable");
    } catch (const error& problem) {
        if (problem.is_about(error_subject::conditions) && problem.kind() == error_kind::argument) {
            throw input_error(
                "--equilibrium", equilibrium,
                (problem.value().empty() ? "" : "has '" + problem.value() + "', which ") + problem.reason(),
                form_of_equilibrium);
        }
        throw;
    }
}

}  // namespace

void manifold_options::add_to(CLI::App& command) {
    command
        .add_option("--manifold", manifold_,
                    "instead of a solution, those on the stable, unstable or both manifolds of an --equilibrium of an "
                    "autonomous --problem, for a phase portrait with --plot")
        ->type_name("stable|unstable|both");
    command
        .add_option("--equilibrium", equilibrium_,
                    "the equilibrium of --manifold, exactly: \"x=pi\"; derivatives are 0")
        ->type_name("NAME=VALUE,...");
}

int manifold_options::write(const problem_options& problem_of, const output_options& output, plot_axes plot) const {
    if (*manifold_ != "stable" && *manifold_ != "unstable" && *manifold_ != "both") {
        throw input_error("--manifold", *manifold_, "is not a manifold of an equilibrium",
                          "write stable, unstable or both");
    }
    const auto system = problem_of.equations_with_open_starts({});
    const auto found = manifolds_by(problem_of, *manifold_, *equilibrium_);
    plot.use_if_empty(found.names.front() + "," +
                      (found.names.size() == 3 ? found.names.back() : found.names[1 % found.names.size()]));
    const auto figure = plot.file(output);
    if (figure) {
        const auto axes = plot.names();
        if (axes.size() != 2) {
            throw input_error("--plot", fmt::format("{}", axes.size()), "quantities are not a plane",
                              "write two unknowns, as x,y");
        }
        figure->draw(manifold_plot(found, axes[0], axes[1], problem_of.heading()));
    }
    std::vector<column> columns{{"manifold", ""}, {"branch", ""}, {"time", ""}};
    for (const std::string& each : found.names) {
        columns.push_back({each, ""});
    }
    columns.insert(columns.end(), {{"digits", ""}, {"rigour", ""}});
    table rows(std::move(columns));
    const auto number = [](double x) {
        return cell::number(fmt::format("{:.{}g}", x, digits_of_portrait), digits_of_portrait);
    };
    for (const auto& branch : found.branches) {
        for (std::size_t k = 0; k < branch.states.size(); ++k) {
            table_row_cells row{branch.stable ? "stable" : "unstable", static_cast<long>(branch.number),
                                number(branch.times[k])};
            for (const double each : branch.states[k]) {
                row.push_back(number(each));
            }
            row.insert(row.end(), {digits_of_portrait, "heuristic"});
            rows.add_row(std::move(row));
        }
    }
    table_output(output, figure).write(rows);
    const auto say = [&](const char* name, std::size_t dimension) {
        if (dimension > 0) {
            say_line(fmt::format("{} manifold: dimension {}, proved to exist{}", name, dimension,
                                 dimension > 1 ? "; some of its solutions are drawn" : ""));
        }
    };
    say("stable", found.stable_dimension);
    say("unstable", found.unstable_dimension);
    return 0;
}

}  // namespace libration
