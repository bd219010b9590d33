// libration find: proved parameters, initial values and periodic orbits of any problem.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "first_values.hpp"
#include "found_eigenvalues.hpp"
#include "found_solutions.hpp"
#include "libration/number/grid.hpp"
#include "libration/problem/find.hpp"
#include "libration/problem/known_facts.hpp"
#include "libration/problem/limit_solution.hpp"
#include "libration/problem/limit_text.hpp"
#include "limit_options.hpp"
#include "option/options.hpp"
#include "option/output_place.hpp"
#include "option/subcommand.hpp"
#include "problem/certificate_file.hpp"
#include "problem/problem_options.hpp"
#include "problem/swept_problem.hpp"
#include "run/ending_signal.hpp"
#include "run/progress.hpp"
#include "solution_branches.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

struct find_options {
    problem_options problem;
    output_options output;
    std::optional<std::string> digits;
    std::vector<std::string> unknowns, conditions, guesses;
    std::vector<std::string> without_guess;  // at infinity, where several values are tried
    std::optional<std::string> along, certificate, eigenvalue, count;
    std::vector<std::string> shown;  // of numbers_at_infinity()
    bool periodic = false, homoclinic = false, check = false;
    orbit_options orbit;
};

// What is typed for the unknowns and the conditions.
std::string typed_unknowns(const find_options& options) {
    std::string line = fmt::format("--unknown \"{}\"", fmt::join(options.unknowns, ","));
    for (const std::string& each : options.conditions) {
        line += fmt::format(" --such-that \"{}\"", each);
    }
    return line;
}

// The form of several first guesses for each unknown.
std::string remedy_of_guesses(const find_options& options) {
    std::string line;
    for (const std::string& each : options.unknowns) {
        line += fmt::format(" --guess \"{}=0:10:11\"", each);
    }
    return line;
}

// find(); an error about the first guess proposes several.
template <class Find>
auto proposing_guesses(const find_options& options, const Find& find) {
    try {
        return find();
    } catch (const error& problem) {
        if (!problem.is_about(error_subject::first_guess)) {
            throw;
        }
        throw error(problem.kind(), error_subject::first_guess, problem.value(),
                    problem.reason() + ", or several with" + remedy_of_guesses(options));
    }
}

void require_as_many_conditions(const find_options& options) {
    const std::size_t unknowns = options.unknowns.size();
    const std::size_t conditions = options.conditions.size();
    if (unknowns == conditions) {
        return;
    }
    throw input_error(fmt::format("--unknown names {} and --such-that {}: give as many conditions as unknowns, {}",
                                  unknowns, conditions,
                                  conditions < unknowns ? typed_unknowns(options) + " --such-that \"y(1) = 0\""
                                                        : "with another name in " + typed_unknowns(options)));
}

answer found_by(const find_options& options, const problem& of, const request& how) {
    if (options.periodic) {
        return find_periodic_orbit(of, how, options.orbit);
    }
    const bool at_infinity = std::ranges::any_of(options.conditions, is_at_infinity);
    if (!at_infinity) {
        require_as_many_conditions(options);
    }
    return proposing_guesses(
        options, [&] { return find_unknowns(of, options.unknowns, options.conditions, how, options.without_guess); });
}

// NAME = VALUES of --along.
branch_values read_along(const find_options& options) {
    const std::string& written = *options.along;
    const std::string form = "write --along \"k=0:1:11\" with a parameter and its values";
    const auto equals = written.find('=');
    if (equals == std::string::npos) {
        throw input_error("--along", written, "is not NAME=VALUES", form);
    }
    branch_values along{without_blanks(written.substr(0, equals)), {}};
    const auto list =
        reading("--along", written, form, [&] { return read_grid(without_blanks(written.substr(equals + 1))); });
    if (list.size() < 2) {
        throw input_error("--along", written, "has one value",
                          fmt::format("write \"{0}={1}:LAST:11\", or --set \"{0}={1}\" for this value alone",
                                      along.parameter, list.front().text));
    }
    if (std::ranges::find(options.unknowns, along.parameter) != options.unknowns.end()) {
        throw input_error("--along", written, "is also given as --unknown",
                          "leave it out there, as the branch determines it");
    }
    for (const exact& each : list) {
        along.values.push_back(each.text);
    }
    return along;
}

// The branches of all first guesses.
int run_along(const find_options& options, const problem& of, const branch_values& along,
              const std::vector<first_guess>& guesses, const request& how, long digits) {
    require_as_many_conditions(options);
    solution_branches found;
    for (const first_guess& guess : guesses) {
        problem changed = of;
        for (const std::string& each : guess) {
            naming_option("--guess", [&] { changed.set(each); });
        }
        found.add(guess, [&] {
            return proposing_guesses(
                options, [&] { return find_branch(changed, options.unknowns, options.conditions, along, how); });
        });
    }
    if (found.has_points()) {
        options.output.write(found.as_table(digits, !options.guesses.empty()));
    }
    for (const std::string& each : found.remarks()) {
        say_line(shortened(each));
    }
    return found.has_failures() ? 1 : 0;
}

// The solutions, then the reasons for those that are missing.
int print_solutions(const find_options& options, const found_solutions& found, long digits,
                    const std::optional<error>& ended) {
    if (!found.solutions().empty()) {
        options.output.write(found.as_table(digits, !options.guesses.empty(), options.shown),
                             found.as_text(options.shown));
    }
    for (const std::string& each : found.remarks()) {
        say_line(shortened(each));
    }
    // Of several solutions those that a solution shares with the first one once.
    for (std::size_t i = 0; i < found.solutions().size(); ++i) {
        const auto& of_first = found.solutions().front().notes;
        for (const answer_note& each : found.solutions()[i].notes) {
            const bool is_said = i > 0 && std::ranges::any_of(of_first, [&](const answer_note& said) {
                                     return said.name == each.name && said.text == each.text;
                                 });
            if (!is_said && !is_shown(each, options.shown)) {
                const std::string which = found.solutions().size() > 1 ? fmt::format("solution {}, ", i + 1) : "";
                say_line(which + each.name + ": " + each.text);
            }
        }
    }
    if (!found.solutions().empty()) {
        say_missing(options.shown, found.solutions().front().notes);
    }
    if (ended) {
        throw error(*ended);
    }
    return found.has_failures() ? 1 : 0;
}

// Adds the conditions of --homoclinic, and without --unknown the unknowns of a symmetric orbit.
problem with_homoclinic_limits(find_options& options, const problem& of, const first_guess& guess) {
    problem near = of;
    for (const std::string& each : guess) {
        naming_option("--guess", [&] { near.set(each); });
    }
    const auto limits = homoclinic_conditions(near);
    options.conditions.insert(options.conditions.end(), limits.begin(), limits.end());
    const auto symmetric = options.unknowns.empty() ? symmetric_orbit_of(of, limits) : std::nullopt;
    if (options.unknowns.empty() && !symmetric) {
        throw input_error(
            "--homoclinic is given without --unknown, and no reversal of time is known that leaves the "
            "equations unchanged: add the parameter for which there is such an orbit");
    }
    say_line(fmt::format("--homoclinic: {}", fmt::join(limits, ", ")));
    if (!symmetric) {
        return of;
    }
    options.unknowns = options.without_guess = symmetric->unknowns;
    return symmetric->of;
}

int run_find(find_options options) {
    for (const std::string& each : options.problem.take_limits(options.unknowns)) {
        options.conditions.push_back(each);
    }
    const bool has_limits = std::ranges::any_of(options.conditions, is_at_infinity);
    if (options.homoclinic && has_limits) {
        throw input_error("--homoclinic is given together with conditions at infinity: leave one of them out");
    }
    if (options.homoclinic || has_limits) {
        options.shown = options.problem.take_shown(numbers_at_infinity());
    }
    options.output.check();
    const long digits = digits_of(options.digits);
    if (options.unknowns.empty() && has_limits && !options.eigenvalue) {
        options.unknowns = numbers_left_open(options.problem);
        if (options.unknowns.empty()) {
            throw input_error(
                "--problem leaves no parameter or initial value open, and is not mapped to itself by a known reversal "
                "of time: write a parameter instead of a number and add --unknown NAME, or, if the limits determine "
                "the "
                "solution, print it with libration reference");
        }
    }
    if (options.eigenvalue) {
        const auto found = found_eigenvalues(
            {*options.eigenvalue, options.count, options.conditions, digits, options.check}, options.problem);
        return print_solutions(options, found, digits, found.solutions().front().missing);
    }
    if (options.certificate) {
        require_output_place("--certificate", *options.certificate);
    }
    auto guesses = first_guesses(options.guesses, options.unknowns);
    if (options.homoclinic || has_limits) {
        options.without_guess = add_first_values(options.problem, options.unknowns, guesses.front());
    }
    const auto along = options.along ? std::optional(read_along(options)) : std::nullopt;
    require_first_values(options.problem, options.unknowns, guesses.front(), along);
    problem of(options.problem.equations(first_values(guesses.front(), along)));
    if (!options.orbit.period.empty()) {
        reading("--period", options.orbit.period, "give a time after which the orbit returns, such as 6.3",
                [&] { return typed_period(of.equations(), options.orbit.period); });
    }
    if (options.homoclinic) {
        of = with_homoclinic_limits(options, of, guesses.front());
    }
    progress shown("find", guesses.size());
    const request how{.scalar = {scalar_kind::proved, digits},
                      .check = options.check,
                      .progress = [](double) { check_time(); },
                      .reached =
                          [&](double time, long bits) {
                              shown.reached(time, bits);
                              check_time();
                          }};
    if (along) {
        return run_along(options, of, *along, guesses, how, digits);
    }
    found_solutions found;
    std::optional<error> ended;
    for (const first_guess& guess : guesses) {
        problem changed = of;
        for (const std::string& each : guess) {
            naming_option("--guess", [&] { changed.set(each); });
        }
        try {
            found.add(guess, [&] { return found_by(options, changed, how); });
        } catch (const error& problem) {
            if (found.solutions().empty()) {
                throw;
            }
            ended = problem;
            break;
        }
        shown.step();
    }
    const int code = print_solutions(options, found, digits, ended);
    if (options.certificate && !found.solutions().empty()) {
        const answer& solution = found.solutions().front();
        if (options.periodic) {
            certify_orbit(*options.certificate, of, solution, how, notes_of(options.problem));
        } else {
            certify_root(*options.certificate, of, options.unknowns, options.conditions, solution, how,
                         notes_of(options.problem));
        }
        if (options.check) {
            check_certificate(*options.certificate);
        }
    }
    return code;
}

}  // namespace

subcommand find_command(CLI::App& program) {
    const auto options = std::make_shared<find_options>();
    CLI::App* command = program.add_subcommand(
        "find",
        "parameters, initial values and periodic orbits of any problem, proved to exist, to any number of digits");
    options->problem.add_to(*command);
    options->output.add_to(*command);
    add_digits(*command, options->digits);
    command
        ->add_option(
            "--unknown", options->unknowns,
            "the unknown parameters or initial values, k or \"f''(0)\"; the problem's values are the first guess")
        ->delimiter(',')
        ->type_name("NAMES");
    command
        ->add_option("--such-that", options->conditions,
                     "a condition for each: \"f'(5) = 1\", \"y(0) + y'(1)^2 = k\", \"y(0) = y(T)\"")
        ->type_name("CONDITION");
    command
        ->add_option("--guess", options->guesses,
                     "first guesses of an unknown, each of which may lead to another solution: \"y'(0)=0.5,10\"")
        ->type_name("NAME=VALUES");
    command
        ->add_option("--along", options->along,
                     "follow the branch of solutions in a parameter, past turning points: \"k=0:3.5:36\"")
        ->type_name("NAME=VALUES");
    command
        ->add_option(
            "--certificate", options->certificate,
            "of conditions y(1) = 2 at one time, or of --periodic: write a certificate that check/libration_check.py "
            "verifies independently in integer arithmetic")
        ->type_name("FILE");
    command
        ->add_option("--eigenvalue", options->eigenvalue,
                     "the first eigenvalues E of psi'' = (V(x) - E)*psi with a condition at each end, as psi(-inf)=0; "
                     "psi(inf)=0 or psi(0)=0; psi(inf)=0, all of them in increasing order")
        ->type_name("E");
    command->add_option("--count", options->count, "number of eigenvalues to find (default: 1)")->type_name("K");
    command->add_flag("--periodic", options->periodic, "the periodic orbit near the initial values, and its period");
    command
        ->add_option(
            "--period", options->orbit.period,
            "of --periodic: the period of an orbit of a family; of an isolated orbit, the time near which it is sought")
        ->type_name("T");
    command->add_flag("--multipliers", options->orbit.multipliers,
                      "of --periodic: also the Floquet multipliers, and what they prove about stability");
    command->add_flag(
        "--homoclinic", options->homoclinic,
        "the orbit from the equilibrium near the initial values to itself, and the --unknown for which there is one; "
        "without --unknown, one that a reversal of time leaves unchanged");
    command->add_flag(
        "--check", options->check,
        "compare with a second proof by another route, exit 1 if they disagree; with --certificate also run "
        "its checker");
    return {command, [options] { return run_find(*options); },
            [options](std::string_view /*limits*/) {
                const auto& typed = options->problem.problem();
                return options->homoclinic || std::ranges::any_of(options->conditions, is_at_infinity) ||
                       (typed && is_at_infinity(*typed));
            }};
}

}  // namespace libration
