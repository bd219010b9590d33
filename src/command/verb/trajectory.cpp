// libration trajectory: theta and omega at a list of times, exactly or by one of the approximations, with the error; or
// the unknowns of any differential equation.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "equation/integrator_options.hpp"
#include "equation/problem_options.hpp"
#include "equation/problem_trajectory.hpp"
#include "libration/problem/known/pendulum_solution.hpp"
#include "motion/motion_options.hpp"
#include "motion/trajectory_points.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "plot/plot_options.hpp"
#include "plot/solution_plot.hpp"
#include "run/progress.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"
#include "text/quotation.hpp"

namespace libration {

namespace {

constexpr const char* usual_step = "1e-5";

struct trajectory_options {
    motion_options motion;
    problem_options problem;
    integrator_options integrator;
    arithmetic_options arithmetic;
    output_options output;
    plot_axes plot;
    std::optional<std::string> method;
    std::optional<std::string> order;
    std::string times;
    std::optional<std::string> via;
    std::optional<std::string> step;
    std::optional<std::string> jobs;
};

trajectory_method read_trajectory_method(const std::string& name) {
    if (name == "exact" || name == "rk4") {
        return name == "exact" ? trajectory_method::exact : trajectory_method::rk4;
    }
    if (name == "series" || name == "resummed") {
        return name == "series" ? trajectory_method::series : trajectory_method::resummed;
    }
    if (name == "uniform") {
        return trajectory_method::uniform;
    }
    throw input_error("--method", name, "is not a method for a trajectory",
                      "write exact, series, resummed, uniform or rk4");
}

bool is_partial_sum(trajectory_method method) {
    return method == trajectory_method::series || method == trajectory_method::resummed ||
           method == trajectory_method::uniform;
}

// --order applies to partial sums, --step to rk4.
void require_fitting(const trajectory_options& options, trajectory_method method) {
    const bool sums = is_partial_sum(method);
    if (sums && !options.order) {
        throw input_error("--method", *options.method, "is a partial sum", "add --order N, its last power");
    }
    const auto refuse = [&](const char* option, const std::string& value) {
        throw input_error(option, value, "has no meaning for --method " + options.method.value_or("exact"),
                          "leave it out");
    };
    if (!sums && options.order) {
        refuse("--order", *options.order);
    }
    if (method != trajectory_method::rk4 && options.step) {
        refuse("--step", *options.step);
    }
}

trajectory_request choose(const trajectory_options& options) {
    const trajectory_method method = read_trajectory_method(options.method.value_or("exact"));
    require_fitting(options, method);
    const exact step = positive_number_of("--step", options.step.value_or(usual_step));
    const arithmetic numbers = options.arithmetic.choose();
    if (method == trajectory_method::rk4 && numbers.scalar.kind == scalar_kind::proved) {
        throw input_error("--scalar", numbers.scalar.name(), "cannot prove a step-by-step integration",
                          "use another scalar, or --method exact");
    }
    chosen_motion chosen = options.motion.choose_for(numbers.scalar);
    const auto r = chosen.of.regime();
    if (is_partial_sum(method) && at_critical_energy(r)) {
        throw input_error("--method", *options.method, "has no top to expand about at E = 2", "use exact or rk4");
    }
    if (method == trajectory_method::uniform && r == pendulum::regime::stable_equilibrium) {
        throw input_error("--method", *options.method, "has infinitely many columns of singularities at E = 0",
                          "use exact, series or resummed");
    }
    const int order = options.order ? order_of("--order", *options.order) : 0;
    return {std::move(chosen), numbers, method, order, step, times_of(options.times, r), jobs_of(options.jobs)};
}

// Instead of a motion, any problem.
partial_table trajectory_of_problem(const trajectory_options& options) {
    if (const auto other = options.motion.first_given()) {
        throw input_error(*other + " applies to motions of the pendulum, not to a --problem: leave one of them out");
    }
    const auto refuse = [](const char* option, const std::optional<std::string>& value) {
        if (value) {
            throw input_error(option, *value, "has no meaning for Taylor series in steps", "leave it out");
        }
    };
    const std::string method = options.method.value_or("taylor");
    static const std::vector<std::string> approximations{"series", "pade", "endpoint", "asymptotic"};
    const bool approximated = std::ranges::find(approximations, method) != approximations.end();
    if (!approximated && method != "taylor") {
        throw input_error("--method", method, "is not a method for a problem",
                          "write taylor, series, pade, endpoint or asymptotic");
    }
    refuse("--step", options.step);
    if (!approximated) {
        refuse("--order", options.order);
    }
    const arithmetic numbers = options.arithmetic.choose();
    options.integrator.choice();
    if (numbers.scalar.kind != scalar_kind::proved) {
        options.integrator.require_absent("chooses the method of proofs, which need --scalar ball:D");
    }
    if (approximated) {
        options.integrator.require_absent("has no meaning for --method " + method);
        if (!options.order) {
            throw input_error("--method", method, "is computed from coefficients", "add --order N, the last power");
        }
        if (options.via || has_imaginary_unit(options.times)) {
            throw input_error("--method", method, "is limited to real times", "leave --method out for complex ones");
        }
        return naming_option("--problem", [&] {
            return partial_table{problem_approximation(options.problem, {method, order_of("--order", *options.order)},
                                                       times_of_problem(options.times), numbers),
                                 {},
                                 {},
                                 {}};
        });
    }
    if (options.via || has_imaginary_unit(options.times)) {
        const auto of = options.problem.general_solution();
        const auto corners = corners_of(options.via);
        const auto points = complex_points("--times", options.times);
        return naming_option("--problem", [&] {
            return partial_table{problem_trajectory_along(*of, corners, points, numbers), {}, {}, {}};
        });
    }
    const auto times = times_of_problem(options.times);
    const bool fixed = numbers.scalar.kind != scalar_kind::proved && numbers.scalar.kind != scalar_kind::arbitrary;
    const auto of = options.problem.solution(fixed || options.method == "taylor" || options.integrator.integrates());
    progress shown("trajectory", progress_of_part::steps);
    progress_of_part to(shown);
    return naming_option("--problem", [&] {
        return integrator_options::naming([&] {
            return problem_trajectory(
                *of, times, numbers, [&](double part) { to(part); }, options.integrator.choice());
        });
    });
}

// The solutions of a problem, one or a family.
int run_problem(const trajectory_options& options, const std::optional<figure_file>& figure) {
    const auto family = options.problem.family();
    if (figure) {
        options.plot.require_known(columns_of_states(family.front().problem.choose()));
    }
    std::vector<partial_table> parts;
    for (const family_member& member : family) {
        trajectory_options own = options;
        own.problem = member.problem;
        parts.push_back(trajectory_of_problem(own));
    }
    const partial_table found = parts.size() == 1 ? parts.front() : family_table(family, parts);
    if (found.has_output()) {
        if (figure) {
            figure->draw(family_plot(family, parts, options.plot, options.problem.name()));
        }
        table_output(options.output, figure).write(found.rows);
    }
    options.integrator.state(found.collocation);
    require_complete(found);
    return 0;
}

int run_trajectory(const trajectory_options& options) {
    options.output.check();
    const auto figure = options.plot.file(options.output);
    if (options.problem.is_chosen()) {
        return run_problem(options, figure);
    }
    options.integrator.require_absent("has no meaning without --problem");
    if (options.via) {
        throw input_error("--via", *options.via, "is a path in the complex t-plane of a --problem",
                          "leave it out, or give the motion as --problem \"x'' = -sin(x); x(0) = 2; x'(0) = 0\"");
    }
    const trajectory_request request = choose(options);
    table data({{"time", ""}, {"theta", ""}, {"omega", ""}, {"error", ""}, {"time_typed", ""}});
    const long digits = request.numbers.digits;
    const auto times = solution_of(request.chosen.of)->times_in_decimals(request.times, digits);
    const auto points = trajectory_points(request);
    bool decided = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [theta, omega, error, undecided] = points[i];
        const std::string& typed = request.times[i].text;
        if (undecided.empty()) {
            data.add_row({number_cell(times[i]), cell::number(theta, digits), cell::number(omega, digits),
                          number_cell(error), typed});
            continue;
        }
        decided = false;
        data.add_row({number_cell(times[i]), cell(), cell(), cell(), typed});
        fmt::print(stderr, "libration: {}\n", shortened(fmt::format("no state at '{}': {}", typed, undecided)));
    }
    if (figure) {
        figure->draw(solution_plot({{"", data}}, options.plot, {}, "pendulum"));
    }
    table_output(options.output, figure).write(data);
    return decided ? 0 : 1;
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
    command
        ->add_option("--method", options->method,
                     "exact (the default); series, resummed or uniform, with --order; rk4; of a problem taylor (the "
                     "default); series, pade, endpoint or asymptotic, with --order")
        ->type_name("METHOD");
    command->add_option("--order", options->order, "last power N of series or uniform, last index of the resummation")
        ->type_name("N");
    command
        ->add_option("--times,--time", options->times, "times: 0,1.5,T/4 or a range 0:20:401; of a problem also 1+2i")
        ->type_name("LIST")
        ->required();
    command
        ->add_option("--via", options->via,
                     "corners of the path to the times of a problem in the complex plane: 1+i,2+i")
        ->type_name("LIST");
    command->add_option("--step", options->step, fmt::format("step of rk4 in dimensionless time, else {}", usual_step))
        ->type_name("H");
    command->add_option("--jobs", options->jobs, "threads; all cores without it")->type_name("J");
    return {command, [options] { return run_trajectory(*options); }};
}

}  // namespace libration
