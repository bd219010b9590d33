// libration reference: proved digits of a solution at any times: of a motion theta, omega, E, T, T* and R, of a problem
// its unknowns.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "asked_solution.hpp"
#include "libration/scalar/list_items.hpp"
#include "limit_options.hpp"
#include "limit_states.hpp"
#include "option/options.hpp"
#include "option/output_place.hpp"
#include "option/subcommand.hpp"
#include "plot/plot_options.hpp"
#include "plot/solution_plot.hpp"
#include "problem/certificate_file.hpp"
#include "problem/event_options.hpp"
#include "problem/integrator_options.hpp"
#include "problem/problem_events.hpp"
#include "problem/problem_options.hpp"
#include "problem/problem_trajectory.hpp"
#include "problem/set_options.hpp"
#include "problem/solution_table.hpp"
#include "run/ending_signal.hpp"
#include "run/parallel.hpp"
#include "run/progress.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

struct reference_options {
    motion_options motion;
    problem_options problem;
    integrator_options integrator;
    output_options output;
    plot_axes plot;
    event_options events;
    set_options sets;
    limit_options limits;
    std::optional<std::string> digits, times, derivatives, motions, columns, rename, jobs, trace, certificate;
    bool check = false;

    /// --columns are those of the output; with --motions without --rename, those of that file, as in versions before.
    void assign_columns() {
        if (motions && !rename) {
            rename = std::exchange(columns, std::nullopt);
        }
        if (columns) {
            output.choose_columns(*columns);
        }
    }
};

// The second route sums about D/3 columns of D digits: minutes at this many, hours for far more.
constexpr long most_checked_digits = 10'000;

void check_if_asked(const reference_options& options) {
    if (options.check) {
        check_certificate(*options.certificate);
    }
}

// The events of all solutions of a set, or how many there are.
int write_events_of_sets(const reference_options& options, long digits) {
    const bool how_many = options.events.asks_how_many();
    ode::proof_route route;
    route.integrator = options.integrator.choice();
    const auto found =
        how_many ? options.sets.event_counts(options.problem, options.events.request_for_counts(), digits, route)
                 : options.sets.events(options.problem, options.events.request_for_sets(), digits, route);
    if (found.has_output()) {
        options.output.write(found.rows, found.text);
    }
    require_complete(found);
    return 0;
}

// The times at which a condition holds.
int write_events(const reference_options& options, long digits) {
    if (set_options::has_sets(options.problem) || options.events.asks_how_many()) {
        return write_events_of_sets(options, digits);
    }
    const auto system = options.problem.choose_first_branch();
    const auto of = options.problem.general_solution();
    const auto request = options.events.request(*of, system);
    const auto figure = options.plot.file(options.output);
    if (figure) {
        options.plot.require_known(columns_of_states(system));
    }
    const auto output = table_output(options.output, figure);
    const auto write = [&](const partial_table& found) { output.write(found.rows, found.text); };
    const libration::request proved{
        .scalar = {scalar_kind::proved, digits}, .check = options.check, .integrator = options.integrator.choice()};
    const auto found = naming_option("--until", [&] { return problem_events(*of, system, request, proved, write); });
    if (found.has_output()) {
        if (figure && !found.rows.rows().empty()) {
            figure->draw(event_plot(options.problem, found.rows, options.events.condition(), options.plot));
        }
        write(found);
    }
    options.integrator.state(found.collocation);
    require_complete(found);
    if (options.certificate) {
        with_certificate_progress(digits, [&](const auto& how) {
            certify_events(*options.certificate, system, request, found.rows, how, notes_of(options.problem));
        });
        check_if_asked(options);
    }
    return 0;
}

// Enclosures of all solutions: of sets of initial values and parameters, and over spans of time.
int write_enclosures(const reference_options& options, const std::vector<family_member>& family, long digits) {
    ode::proof_route route;
    route.integrator = options.integrator.choice();
    const auto found = options.sets.enclosures(family.front().problem, options.times, digits, route);
    if (found.has_output()) {
        options.output.write(found.rows, found.text);
    }
    require_complete(found);
    return 0;
}

asked_solution problem_of_options(const reference_options& options, const problem_options& problem, bool general) {
    auto of = problem.solution(general);
    if (options.trace && !of->closed_form().empty()) {
        throw input_error("--trace", *options.trace, "has no steps to record, since a closed form is used",
                          "add --general, or leave it out");
    }
    if (*options.times != infinite_time) {
        return {std::move(of), times_of_problem(*options.times), *options.times};
    }
    return {std::move(of), {}, infinite_time};
}

std::vector<asked_solution> asked_by(const reference_options& options, const std::vector<family_member>& family,
                                     long digits) {
    std::vector<asked_solution> asked;
    if (options.problem.is_chosen()) {
        const bool general = options.integrator.integrates() || options.derivatives;
        for (const family_member& each : family) {
            asked.push_back(problem_of_options(options, each.problem, general));
        }
    } else if (options.motions) {
        asked = asked_motions(options.motion, *options.motions, options.rename, options.times);
    } else {
        asked.push_back(asked_motion(options.motion, *options.times, digits));
    }
    return asked;
}

// The numbers by which the solution is differentiated: "x(0), x'(0), r".
std::vector<std::string> derivatives_of(const reference_options& options) {
    std::vector<std::string> numbers;
    if (!options.derivatives) {
        return numbers;
    }
    for (const std::string_view each : list_items(*options.derivatives)) {
        std::string number(each);
        std::erase(number, ' ');
        if (number == "initial") {
            const ode::explicit_system system = options.problem.choose();
            const auto fraction = system.point().fraction();
            if (!fraction) {
                throw input_error("--derivatives", "initial", "is for an initial point that is a fraction",
                                  "name the initial values");
            }
            const std::string point = fraction->str();
            for (const std::string& name : ode::names_of_state(system)) {
                numbers.push_back(name + "(" + point + ")");
            }
            continue;
        }
        if (number.empty()) {
            throw input_error("--derivatives", *options.derivatives, "has an empty item",
                              "write initial values and parameters of the problem, as \"x(0), r\"");
        }
        numbers.push_back(std::move(number));
    }
    return numbers;
}

// On all cores if there are several solutions.
std::vector<partial_table> answered(const std::vector<asked_solution>& asked, const reference_options& options,
                                    long digits) {
    progress shown("reference", asked.size() * progress_of_part::steps);
    const auto trace = options.trace ? std::make_unique<step_trace>(*options.trace) : nullptr;
    ode::step_observer observer;
    if (trace) {
        observer = [&](const ode::step_report& step) { trace->add(step); };
    }
    std::vector<partial_table> parts(asked.size());
    on_threads(asked.size(), jobs_of(options.jobs), [&](std::size_t i) {
        progress_of_part to(shown);
        parts[i] = states_of(asked[i], {.scalar = {scalar_kind::proved, digits},
                                        .derivatives = derivatives_of(options),
                                        .check = options.check,
                                        .progress = [&](double part) { to(part); },
                                        .reached = [&](double time, long bits) { to.reached(time, bits); },
                                        .integrator = options.integrator.choice(),
                                        .observer = observer});
        if (!is_ending()) {
            to(1);
        }
    });
    if (trace) {
        trace->finish();
    }
    return parts;
}

// The properties of a problem that the table of options names.
bool has(const reference_options& options, std::string_view property) {
    if (!options.problem.is_chosen()) {
        return false;
    }
    const auto family = options.problem.family();
    if (property == "list") {
        return family.size() > 1;
    }
    if (property == "limits" || options.problem.has_limits()) {
        return property == "limits" && options.problem.has_limits();
    }
    if (property == "family") {
        return family.size() > 1;
    }
    const ode::equation_system equations = family.front().problem.equations();
    return property == "sets"     ? !equations.sets.empty()
           : property == "delays" ? equations.has_delays()
                                  : !equations.is_smooth();
}

int run_reference(reference_options options) {
    options.output.check();
    if (const auto of = options.limits.take(options.problem)) {
        return write_limit_states(*of, {options.times, digits_of(options.digits), options.check, true}, options.problem,
                                  options.output, options.plot);
    }
    if (options.certificate) {
        require_output_place("--certificate", *options.certificate);
    }
    const long digits = digits_of(options.digits);
    options.integrator.choice();
    if (options.events.given()) {
        return write_events(options, digits);
    }
    const auto family = options.problem.is_chosen() ? options.problem.family() : std::vector<family_member>(1);
    if (options.sets.given(family.front().problem)) {
        return write_enclosures(options, family, digits);
    }
    const auto figure = options.plot.file(options.output);
    if (figure && options.problem.is_chosen()) {
        options.plot.require_known(columns_of_states(family.front().problem.choose_first_branch()));
    }
    const auto asked = asked_by(options, family, digits);
    const bool closed = std::ranges::any_of(asked, [](const auto& each) { return !each.of->closed_form().empty(); });
    if (options.check && closed && digits > most_checked_digits) {
        throw input_error("--digits", std::to_string(digits), "would take hours with --check",
                          fmt::format("write {} or fewer", most_checked_digits));
    }
    const auto parts = answered(asked, options, digits);
    const auto found = family.size() == 1 ? stacked_states(parts) : family_table(family, parts);
    if (found.has_output()) {
        if (figure) {
            figure->draw(family_plot(family, parts, options.plot,
                                     options.problem.is_chosen() ? options.problem.heading() : "pendulum"));
        }
        table_output(options.output, figure).write(found.rows, found.text);
    }
    options.integrator.state(found.collocation);
    require_complete(found);
    if (options.certificate) {
        with_certificate_progress(digits, [&](const request& how) {
            certify_states(*options.certificate, options.problem.choose(), asked.front().times, found.rows, how,
                           notes_of(options.problem));
        });
        check_if_asked(options);
    }
    return 0;
}

}  // namespace

subcommand reference_command(CLI::App& program) {
    const auto options = std::make_shared<reference_options>();
    CLI::App* command = program.add_subcommand(
        "reference", "proved digits of theta, omega, E, T, T* and R, or of any problem, at a list of times");
    options->motion.add_to(*command);
    options->problem.add_to(*command, problem_options::closed_forms::used, problem_options::set_values::lists);
    options->integrator.add_to(*command);
    command
        ->add_option("--derivatives", options->derivatives,
                     "with --problem: also the derivatives of every value by these initial values and parameters, each "
                     "digit proved: \"x(0), x'(0), r\"; initial: by all initial values, the state transition matrix")
        ->type_name("LIST");
    options->output.add_to(*command, output_options::columns_option::not_here);
    options->plot.add_to(*command);
    add_digits(*command, options->digits);
    command->add_option("--times,--time", options->times, "times: 0,1.5,T/4 or a range 0:20:401")->type_name("LIST");
    command
        ->add_option("--motions", options->motions,
                     "a file with a motion in each row: theta0 and omega0, gap or energy, and a time unless --times is "
                     "given; - for stdin")
        ->type_name("FILE");
    command->add_option("--rename", options->rename, "the names of its columns: t=time,E=energy, NAME=- to ignore one")
        ->type_name("THEIRS=OURS,...");
    command
        ->add_option("--columns", options->columns,
                     "print only these columns, in this order; with --motions also THEIRS=OURS, as --rename")
        ->type_name("NAMES");
    command
        ->add_option("--trace", options->trace,
                     "with --problem: a CSV file with the steps of the integration, written also if it fails")
        ->type_name("FILE");
    command
        ->add_option(
            "--certificate", options->certificate,
            "with --problem: write a certificate that check/libration_check.py verifies independently in integer "
            "arithmetic")
        ->type_name("FILE");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    options->events.add_to(*command);
    options->sets.add_to(*command);
    options->limits.add_to(*command);
    command->add_flag(
        "--check", options->check,
        "compare with a second proof by another route, exit 1 if they disagree; with --certificate also run "
        "its checker");
    return {command,
            [options] {
                options->assign_columns();
                return run_reference(*options);
            },
            [options](std::string_view property) { return has(*options, property); }};
}

}  // namespace libration
