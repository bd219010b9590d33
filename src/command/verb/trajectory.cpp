// libration trajectory: theta and omega at a list of times, exactly or by one of the approximations, with the error; or
// the unknowns of any differential equation.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <tuple>

#include "libration/problem/known/pendulum_solution.hpp"
#include "limit_options.hpp"
#include "limit_states.hpp"
#include "manifold_portrait.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "plot/plot_options.hpp"
#include "plot/solution_plot.hpp"
#include "problem/family_trajectory.hpp"
#include "problem/integrator_options.hpp"
#include "problem/motion_options.hpp"
#include "problem/problem_options.hpp"
#include "problem/problem_trajectory.hpp"
#include "problem/trajectory_points.hpp"
#include "run/progress.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

struct trajectory_options {
    motion_options motion;
    problem_options problem;
    integrator_options integrator;
    arithmetic_options arithmetic;
    output_options output;
    plot_axes plot;
    std::optional<std::string> method;
    std::optional<std::string> order;
    std::optional<std::string> times;
    limit_options limits;
    manifold_options manifold;
    std::optional<std::string> via;
    std::optional<std::string> step;
    std::optional<std::string> scale;
    std::optional<std::string> jobs;
};

// A value of --method, and which options it needs.
struct method_form {
    std::string name;
    bool by_order = false;
    bool by_step = false;
    bool by_scale = false;
};

// In the order of trajectory_method.
const std::vector<method_form> methods_of_motion{{"exact"},
                                                 {.name = "series", .by_order = true},
                                                 {.name = "resummed", .by_order = true},
                                                 {.name = "uniform", .by_order = true},
                                                 {.name = "rk4", .by_step = true}};
const std::vector<method_form> methods_of_problem{{"taylor"},
                                                  {.name = "series", .by_order = true},
                                                  {.name = "pade", .by_order = true},
                                                  {.name = "endpoint", .by_order = true},
                                                  {.name = "euler", .by_order = true, .by_scale = true},
                                                  {.name = "gauge", .by_order = true, .by_scale = true},
                                                  {.name = "asymptotic", .by_order = true},
                                                  {.name = "rk4", .by_step = true}};

// The method of --method, by default the first, with the options that belong to it.
std::vector<method_form>::const_iterator method_among(const std::vector<method_form>& all,
                                                      const trajectory_options& options) {
    const std::string name = options.method.value_or(all.front().name);
    const auto found = std::ranges::find(all, name, &method_form::name);
    if (found == all.end()) {
        std::vector<std::string> names;
        std::ranges::transform(all, std::back_inserter(names), &method_form::name);
        throw input_error("--method", name, "is not a method for this trajectory",
                          fmt::format("write {}", fmt::join(names, ", ")));
    }
    if (found->by_order && !options.order) {
        throw input_error("--method", name, "is computed from coefficients", "add --order N, the last power");
    }
    for (const auto& [option, value, fits] : {std::tuple("--order", &options.order, found->by_order),
                                              {"--step", &options.step, found->by_step},
                                              {"--scale", &options.scale, found->by_scale}}) {
        if (*value && !fits) {
            throw input_error(option, **value, "has no meaning for --method " + name, "leave it out");
        }
    }
    return found;
}

trajectory_request choose(const trajectory_options& options) {
    const auto form = method_among(methods_of_motion, options);
    const auto method = static_cast<trajectory_method>(form - methods_of_motion.begin());
    const exact step = positive_number_of("--step", options.step.value_or(defaults::step));
    const arithmetic numbers = options.arithmetic.choose();
    if (method == trajectory_method::rk4 && numbers.scalar.kind == scalar_kind::proved) {
        throw input_error("--scalar", numbers.scalar.name(), "cannot prove a step-by-step integration",
                          "use another scalar, or --method exact");
    }
    chosen_motion chosen = options.motion.choose_for(numbers.scalar);
    const auto r = chosen.of.regime();
    if (form->by_order && at_critical_energy(r)) {
        throw input_error("--method", *options.method, "has no top to expand about at E = 2", "use exact or rk4");
    }
    if (method == trajectory_method::uniform && r == pendulum::regime::stable_equilibrium) {
        throw input_error("--method", *options.method, "has infinitely many columns of singularities at E = 0",
                          "use exact, series or resummed");
    }
    const int order = options.order ? order_of("--order", *options.order) : 0;
    return {std::move(chosen), numbers, method, order, step, times_of(*options.times, r), jobs_of(options.jobs)};
}

// A time without digits is an empty row.
partial_table trajectory_of_motion(const trajectory_options& options) {
    const trajectory_request request = choose(options);
    partial_table found{
        table({{"time", ""}, {"theta", ""}, {"omega", ""}, {"error", ""}, {"time_typed", ""}}), {}, {}, {}};
    const long digits = request.numbers.digits;
    const auto times = solution_of(request.chosen.of)->times_in_decimals(request.times, digits);
    const auto points = trajectory_points(request);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [theta, omega, error_text, undecided] = points[i];
        const std::string& typed = request.times[i].text;
        if (undecided.empty()) {
            found.rows.add_row({number_cell(times[i]), cell::number(theta, digits), cell::number(omega, digits),
                                number_cell(error_text), typed});
            continue;
        }
        found.rows.add_row({number_cell(times[i]), cell(), cell(), cell(), typed});
        if (found.missing) {
            say_line(shortened(found.missing->what()));
        }
        found.missing = error(error_kind::undecided, "no state at", typed, "since " + undecided);
    }
    return found;
}

// Instead of a motion, any problem.
partial_table trajectory_of_problem(const trajectory_options& options) {
    const auto& [method, approximated, by_step, by_scale] = *method_among(methods_of_problem, options);
    const arithmetic numbers = options.arithmetic.choose();
    options.integrator.choice();
    if (approximated || by_step) {
        const int order = approximated ? order_of("--order", *options.order) : 0;
        const exact step = positive_number_of("--step", options.step.value_or(defaults::step));
        const auto scale =
            by_scale && options.scale ? std::optional(positive_number_of("--scale", *options.scale)) : std::nullopt;
        return {problem_approximation(options.problem, {method, order, step, scale}, times_of_problem(*options.times),
                                      numbers),
                {},
                {},
                {}};
    }
    if (options.via || has_imaginary_unit(*options.times)) {
        const auto of = options.problem.general_solution();
        const auto corners = corners_of(options.via);
        const auto points = complex_points("--times", *options.times);
        return {problem_trajectory_along(*of, corners, points, numbers), {}, {}, {}};
    }
    const auto times = times_of_problem(*options.times);
    const bool fixed = numbers.scalar.kind != scalar_kind::proved && numbers.scalar.kind != scalar_kind::arbitrary;
    const auto of = options.problem.solution(fixed || options.method == "taylor" || options.integrator.integrates());
    progress shown("trajectory", progress_of_part::steps);
    progress_of_part to(shown);
    return problem_trajectory(
        *of, times, numbers, [&](double part) { to(part); }, options.integrator.choice());
}

// Whether solutions of a problem are integrated in double, without a path or an approximation.
bool is_integrated_in_double(const trajectory_options& options) {
    return options.problem.is_chosen() && options.arithmetic.choose().scalar.kind == scalar_kind::binary64 &&
           !options.via && !has_imaginary_unit(*options.times) && options.method.value_or("taylor") == "taylor";
}

// The motion, or each member of a family of problems, those in double in lock step where that is possible.
std::vector<partial_table> parts_of(const trajectory_options& options, const std::vector<family_member>& family) {
    const auto alone = [&](const family_member& member) {
        trajectory_options own = options;
        own.problem = member.problem;
        return own.problem.is_chosen() ? trajectory_of_problem(own) : trajectory_of_motion(own);
    };
    std::vector<partial_table> parts{alone(family.front())};  // which checks the options, and warns
    std::vector<std::optional<partial_table>> together(family.size());
    const bool by_taylor =
        parts.front().collocation.empty() && options.integrator.choice() != ode::integrator_choice::collocation;
    if (family.size() > 1 && by_taylor && is_integrated_in_double(options)) {
        together = family_in_lock_step(family, times_of_problem(*options.times), options.arithmetic.choose().digits,
                                       jobs_of(options.jobs));
    }
    for (std::size_t i = 1; i < family.size(); ++i) {
        parts.push_back(together[i] ? *std::move(together[i]) : alone(family[i]));
    }
    return parts;
}

// Of a problem with conditions at infinity.
int write_limit_approximation(const trajectory_options& options, const limit_problem& of) {
    const method_form& form = *method_among(methods_of_problem, options);
    if (form.name != "asymptotic") {
        throw input_error("--method", form.name, "is not available with conditions at infinity",
                          "write asymptotic, or leave --method out");
    }
    if (!options.times || options.plot.file(options.output)) {
        throw input_error("--method", form.name, "with conditions at infinity is a table at given times",
                          "add --times 1,2,5, and leave --plot out");
    }
    const table rows = limit_approximation(of, order_of("--order", *options.order), times_of_problem(*options.times),
                                           options.arithmetic.choose());
    table_output(options.output, std::nullopt).write(rows);
    return 0;
}

// A motion, or the solutions of a problem, one or a family.
int run_trajectory(trajectory_options options) {
    constexpr std::size_t most_in_double = 100'000;
    constexpr std::size_t most_otherwise = 1000;
    options.output.check();
    if (options.manifold.given()) {
        return options.manifold.write(options.problem, options.output, options.plot);
    }
    if (const auto of = options.limits.take(options.problem)) {
        if (options.method.value_or("taylor") != "taylor") {
            return write_limit_approximation(options, of->problem);
        }
        return write_limit_states(*of, {options.times, options.arithmetic.choose().digits, false}, options.problem,
                                  options.output, options.plot);
    }
    const auto figure = options.plot.file(options.output);
    const bool of_problem = options.problem.is_chosen();
    const auto family = of_problem
                            ? options.problem.family(is_integrated_in_double(options) ? most_in_double : most_otherwise)
                            : std::vector<family_member>(1);
    if (figure && of_problem) {
        options.plot.require_known(columns_of_states(family.front().problem.choose_first_branch()));
    }
    const std::vector<partial_table> parts = parts_of(options, family);
    const partial_table found = parts.size() == 1 ? parts.front() : family_table(family, parts);
    if (found.has_output()) {
        if (figure) {
            figure->draw(family_plot(family, parts, options.plot, of_problem ? options.problem.heading() : "pendulum"));
        }
        table_output(options.output, figure).write(found.rows);
    }
    options.integrator.state(found.collocation, options.arithmetic.choose().scalar.kind == scalar_kind::proved);
    require_complete(found);
    return 0;
}

}  // namespace

subcommand trajectory_command(CLI::App& program) {
    const auto options = std::make_shared<trajectory_options>();
    CLI::App* command =
        program.add_subcommand("trajectory", "theta and omega, or the unknowns of any problem, at a list of times");
    options->motion.add_to(*command);
    options->problem.add_to(*command, problem_options::closed_forms::used, problem_options::set_values::lists);
    options->integrator.add_to(*command);
    options->arithmetic.add_to(*command, arithmetics::proved_too);
    options->output.add_to(*command);
    options->plot.add_to(*command);
    options->limits.add_to(*command);
    options->manifold.add_to(*command);
    command
        ->add_option("--method", options->method,
                     "exact (the default); series, resummed or uniform, with --order; rk4; of a problem taylor (the "
                     "default); series, pade, endpoint, euler, gauge or asymptotic, with --order; rk4")
        ->type_name("METHOD");
    command->add_option("--order", options->order, "last power N of series or uniform, last index of the resummation")
        ->type_name("N");
    command
        ->add_option("--times,--time", options->times,
                     "times: 0,1.5,T/4 or a range 0:20:401; of a problem also 1+2i; with conditions at infinity also "
                     "inf and -inf (default: as far as the solution moves visibly)")
        ->type_name("LIST");
    command
        ->add_option("--via", options->via,
                     "corners of the path to the times of a problem in the complex plane: 1+i,2+i")
        ->type_name("LIST");
    command
        ->add_option("--step", options->step,
                     fmt::format("step of rk4 in dimensionless time, or in the variable of a problem (default: {})",
                                 defaults::step))
        ->type_name("H");
    command
        ->add_option("--scale", options->scale,
                     "C of the variables t/(t + C) of euler and 1 - exp(-t/C) of gauge (default: the radius of "
                     "convergence that the coefficients show)")
        ->type_name("C");
    command->add_option("--jobs", options->jobs, "number of threads (default: all cores)")->type_name("J");
    return {command, [options] { return run_trajectory(*options); },
            [options](std::string_view property) {
                return property == "limits" ? options->problem.has_limits()
                       : property == "list" ? options->problem.family().size() > 1
                                            : options->times && has_imaginary_unit(*options->times);
            }};
}

}  // namespace libration
