// libration find: proved parameters, initial values and periodic orbits of any problem.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "equation/problem_options.hpp"
#include "libration/digits/proved/proved_decimals.hpp"
#include "libration/digits/proved/two_proofs.hpp"
#include "libration/ode/parse.hpp"
#include "libration/ode/proved/proved_root.hpp"
#include "libration/problem/known_facts.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct find_options {
    problem_options problem;
    output_options output;
    std::optional<std::string> digits;
    std::vector<std::string> unknowns, conditions;
    bool periodic = false, check = false;
};

struct found_value {
    std::string name;
    proved_decimal value;
};

std::vector<proved_decimal> found_for_infinity(const find_options& options, const ode::equation_system& system,
                                               long digits) {
    const std::string condition = options.conditions.size() == 1 ? options.conditions.front() : "several";
    try {
        return naming_option("--such-that",
                             [&] { return proved_for_infinity(system, options.unknowns, condition, digits); });
    } catch (const error& problem) {
        if (problem.subject() != "condition") {
            throw;
        }
        throw error(problem.kind(), "--such-that", problem.value(), problem.reason());
    }
}

// Of each integration; it ends the search at --timeout and at a signal.
ode::march_watch watch_of(progress& shown) {
    return [&shown](const ball& reached, long bits) {
        shown.reached(midpoint_of(reached).convert_to<double>(), bits);
        check_time();
    };
}

std::vector<found_value> found_unknowns(const find_options& options, long digits, const ode::proof_route& route,
                                        progress& shown) {
    const auto system = options.problem.equations();
    const auto named = [&](const std::vector<proved_decimal>& values) {
        std::vector<found_value> found;
        for (std::size_t i = 0; i < values.size(); ++i) {
            found.push_back({options.unknowns[i], values[i]});
        }
        return found;
    };
    if (std::ranges::any_of(options.conditions, is_at_infinity)) {
        if (options.check) {
            throw input_error(
                "--check compares two proofs, and a condition at infinity has only one, by a lemma: leave it out");
        }
        return named(found_for_infinity(options, system, digits));
    }
    if (options.conditions.size() != options.unknowns.size()) {
        throw input_error(fmt::format("--unknown names {} and --such-that {}: give as many conditions as unknowns",
                                      options.unknowns.size(), options.conditions.size()));
    }
    std::vector<ode::point_condition> conditions;
    for (const std::string& each : options.conditions) {
        const ode::start read = naming_option("--such-that", [&] { return ode::parse_point_condition(system, each); });
        conditions.push_back({read.of.name(), read.of.derivative(), read.point.constant(), read.value.constant()});
    }
    return named(naming_option("--unknown", [&] {
        return proved_unknowns(system, options.unknowns, conditions, digits, route, watch_of(shown));
    }));
}

std::vector<found_value> found_orbit(const find_options& options, long digits, const ode::proof_route& route,
                                     progress& shown) {
    const auto system = options.problem.choose();
    const auto orbit =
        naming_option("--problem", [&] { return ode::proved_periodic_orbit(system, digits, route, watch_of(shown)); });
    std::vector<found_value> found;
    for (std::size_t i = 0; i < orbit.names.size(); ++i) {
        found.push_back({orbit.names[i], orbit.start[i]});
    }
    found.push_back({"period", orbit.period});
    return found;
}

std::vector<found_value> found_values(const find_options& options, long digits, const ode::proof_route& route) {
    progress shown("find", 1);
    return options.periodic ? found_orbit(options, digits, route, shown)
                            : found_unknowns(options, digits, route, shown);
}

void check_values(const find_options& options, long digits, const std::vector<found_value>& first) {
    const auto second = found_values(options, digits + ode::more_digits_of_second_proof, ode::proof_route::second());
    for (std::size_t i = 0; i < first.size(); ++i) {
        require_agreement(first[i].value, second[i].value, first[i].name);
    }
}

int run_find(const find_options& options) {
    options.output.check();
    const long digits = digits_of(options.digits);
    if (!options.problem.given()) {
        options.problem.require_problem();
        throw input_error("no problem is given: add --problem P");
    }
    if (options.periodic == !options.unknowns.empty()) {
        throw input_error(options.periodic
                              ? "--periodic is given together with --unknown: leave one of them out"
                              : "nothing to find is given: add --unknown S --such-that \"f'(5) = 1\", or --periodic");
    }
    table data({{"name", ""}, {"value", ""}, {"digits", ""}, {"rigour", ""}});
    std::string lines;
    const auto checked = checked_products(options.check);
    const auto found = found_values(options, digits, {});
    if (options.check) {
        check_values(options, digits, found);
    }
    for (const found_value& each : found) {
        data.add_row({each.name, cell::number(each.value.text, digits), digits, "proved"});
        lines += fmt::format("{:<10}{}\n", each.name, each.value.text);
    }
    options.output.write(data, lines);
    return 0;
}

}  // namespace

subcommand find_command(CLI::App& program) {
    const auto options = std::make_shared<find_options>();
    CLI::App* command = program.add_subcommand(
        "find",
        "parameters, initial values and periodic orbits of any problem, proved to exist, to any number of digits");
    options->problem.add_to(*command);
    options->output.add_to(*command);
    command->add_option("--digits", options->digits, "significant digits, each proved to one unit in the last (50)")
        ->type_name("D");
    command
        ->add_option(
            "--unknown", options->unknowns,
            "the unknown parameters or initial values, k or \"f''(0)\"; the problem's values are the first guess")
        ->delimiter(',')
        ->type_name("NAMES");
    command->add_option("--such-that", options->conditions, "a condition for each: \"f'(5) = 1\"")
        ->type_name("CONDITION");
    command->add_flag("--periodic", options->periodic, "the periodic orbit near the initial values, and its period");
    command->add_flag("--check", options->check,
                      "compare with a second proof by another route, exit 1 if they disagree");
    return {command, [options] { return run_find(*options); }};
}

}  // namespace libration
