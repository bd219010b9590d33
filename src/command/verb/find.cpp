// libration find: proved parameters, initial values and periodic orbits of any problem.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "equation/problem_options.hpp"
#include "libration/problem/find.hpp"
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

// An error about the conditions, the unknowns or the comparison of proofs names the option.
[[noreturn]] void refuse(const error& problem) {
    const std::string option = problem.subject() == "conditions" || problem.subject() == "condition" ? "--such-that"
                               : problem.subject() == "unknowns"                                     ? "--unknown"
                               : problem.subject() == "check"                                        ? "--check"
                                                                                                     : "";
    if (option.empty() || problem.kind() == error_kind::range) {
        throw error(problem);
    }
    if (problem.kind() == error_kind::undecided) {
        throw error(problem.kind(), option, problem.value(), problem.reason());
    }
    const std::string value = problem.value().empty() ? "" : " '" + problem.value() + "'";
    throw input_error(option + value + " " + problem.reason() + (option == "--check" ? ": leave it out" : ""));
}

answer found_by(const find_options& options, const problem& of, const request& how) {
    if (options.periodic) {
        return find_periodic_orbit(of, how);
    }
    const bool at_infinity = std::ranges::any_of(options.conditions, is_at_infinity);
    if (!at_infinity && options.conditions.size() != options.unknowns.size()) {
        throw input_error(fmt::format("--unknown names {} and --such-that {}: give as many conditions as unknowns",
                                      options.unknowns.size(), options.conditions.size()));
    }
    try {
        return find_unknowns(of, options.unknowns, options.conditions, how);
    } catch (const error& problem) {
        refuse(problem);
    }
}

int run_find(const find_options& options) {
    options.output.check();
    const long digits = digits_of(options.digits);
    const problem of(options.problem.equations());
    if (options.periodic == !options.unknowns.empty()) {
        throw input_error(options.periodic
                              ? "--periodic is given together with --unknown: leave one of them out"
                              : "nothing to find is given: add --unknown S --such-that \"f'(5) = 1\", or --periodic");
    }
    if (options.periodic && !options.conditions.empty()) {
        throw input_error("--such-that", options.conditions.front(), "is given together with --periodic",
                          "leave one of them out");
    }
    progress shown("find", 1);
    const request how{
        .scalar = {scalar_kind::proved, digits}, .check = options.check, .reached = [&](double time, long bits) {
            shown.reached(time, bits);
            check_time();
        }};
    const answer found = naming_option("--problem", [&] { return found_by(options, of, how); });
    table data({{"name", ""}, {"value", ""}, {"digits", ""}, {"rigour", ""}});
    std::string lines;
    for (const auto& row : found.rows) {
        data.add_row({row[0].text, cell::number(row[1].text, digits), digits, found.rigour});
        lines += fmt::format("{:<10}{}\n", row[0].text, row[1].text);
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
