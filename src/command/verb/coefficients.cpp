// libration coefficients: the Taylor coefficients of a solution about a point.
#include <fmt/format.h>

#include <memory>

#include "libration/scalar/whole_number.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "problem/motion_coefficients.hpp"
#include "problem/point_options.hpp"
#include "problem/solution_options.hpp"
#include "text/input_error.hpp"

namespace libration {

namespace {

struct coefficients_options {
    solution_options of;
    arithmetic_options arithmetic;
    output_options output;
    point_options point;
    std::string order;
    std::optional<std::string> from, recurrence, method;
    bool check = false;
};

constexpr long most_rows = 1'000'001;

long power_of(const char* option, const std::string& value) {
    return reading(option, value, "write a power of the series, 0 or more",
                   [&] { return read_whole_number(value, largest_power_of_series, "power"); });
}

// --from and --order: the powers to be printed.
series_request powers_of(const coefficients_options& options) {
    series_request request{.first = options.from ? power_of("--from", *options.from) : 0,
                           .order = power_of("--order", options.order)};
    if (request.first > request.order) {
        throw input_error("--from", *options.from, "is beyond --order '" + options.order + "'",
                          "write a power up to that");
    }
    if (request.order - request.first >= most_rows) {
        throw input_error("--order", options.order, fmt::format("makes more than {} rows", most_rows),
                          "write a lower power, or the first power to print as --from");
    }
    return request;
}

// The coefficients as fractions, with --scalar rational, if the solution has them.
std::optional<answer> fractions_of(const coefficients_options& options, const solution& of,
                                   const series_request& powers) {
    if (options.arithmetic.scalar() != "rational") {
        return std::nullopt;
    }
    return of.fractions(powers);
}

constexpr long most_orders_of_recurrences = 100'000;
constexpr long most_orders_of_resummation = 5'000;

// The request about the series of a motion, up to an order whose quadratic cost is affordable.
series_request quadratic_request(const coefficients_options& options, const char* option, const std::string& value,
                                 const chosen_motion& of, long most) {
    series_request request = powers_of(options);
    if (request.order > most) {
        throw input_error("--order", options.order, fmt::format("is above {} with {} '{}'", most, option, value),
                          "write a lower power");
    }
    request.about = options.point.at().value_or(usual_point_of(of));
    return request;
}

pendulum::resummation_formulas formulas_of(const std::string& method) {
    if (method == "resummed") {
        return pendulum::resummation_formulas::corrected;
    }
    if (method == "resummed-as-printed") {
        return pendulum::resummation_formulas::printed;
    }
    throw input_error("--method", method, "is not a method", "write resummed or resummed-as-printed");
}

table resummation_table(const coefficients_options& options, const chosen_motion& of) {
    const auto formulas = formulas_of(*options.method);
    const arithmetic numbers = options.arithmetic.choose();
    if (numbers.scalar.kind != scalar_kind::arbitrary) {
        throw input_error("--scalar", numbers.scalar.name(), "is not supported with --method " + *options.method,
                          "write --digits D");
    }
    const auto& energy = of.of.energy();
    if ((energy && *energy == 0) || pendulum::at_critical_energy(of.of.regime())) {
        throw input_error("--method", *options.method, "is not defined at E = 0 and at E = 2",
                          "write another energy, or leave it out");
    }
    const auto request = quadratic_request(options, "--method", *options.method, of, most_orders_of_resummation);
    return coefficients_of_resummation(of, request, formulas, numbers.digits);
}

table recurrence_table(const coefficients_options& options, const chosen_motion& of) {
    const auto route = reading("--recurrence", *options.recurrence, "write printed, squares, omega or lattice",
                               [&] { return pendulum::coefficient_route_named(*options.recurrence); });
    const arithmetic numbers = options.arithmetic.choose();
    if (numbers.scalar.kind == scalar_kind::proved) {
        throw input_error("--recurrence", *options.recurrence,
                          "compares arithmetics that round, and --scalar " + numbers.scalar.name() + " does not",
                          "write double, long-double, quad or mpfr:DIGITS");
    }
    const auto request =
        quadratic_request(options, "--recurrence", *options.recurrence, of, most_orders_of_recurrences);
    return options.point.asking_about([&] { return coefficients_by_recurrence(of, request, route, numbers.scalar); });
}

int run_coefficients(const coefficients_options& options) {
    options.output.check();
    if (options.recurrence || options.method) {
        const chosen_motion of = *options.of.motion(options.arithmetic);  // not with --problem, by the exclusions
        options.output.write(options.method ? resummation_table(options, of) : recurrence_table(options, of));
        return 0;
    }
    const chosen_solution chosen = options.of.choose(options.arithmetic);
    series_request request = powers_of(options);
    if (const auto found = fractions_of(options, *chosen.of, request)) {
        options.output.write(table_of(*found));
        return 0;
    }
    const arithmetic numbers = options.arithmetic.choose();
    options.point.complete(request, chosen);
    const auto found = options.point.asking_about([&] {
        return chosen.of->series(request, {.scalar = numbers.scalar, .digits = numbers.digits, .check = options.check});
    });
    options.output.write(table_of(found, chosen.labels));
    return 0;
}

}  // namespace

subcommand coefficients_command(CLI::App& program) {
    const auto options = std::make_shared<coefficients_options>();
    CLI::App* command =
        program.add_subcommand("coefficients", "the Taylor coefficients of theta, or of any problem, about a point");
    options->of.add_to(*command);
    options->arithmetic.add_to(*command, arithmetics::proved_too);
    options->output.add_to(*command);
    command->add_option("--order", options->order, "last power N")->type_name("N")->required();
    command->add_option("--from", options->from, "first power to print (default: 0); does not affect the cost")
        ->type_name("N");
    command
        ->add_option(
            "--method", options->method,
            "resummed: a_n, s_n, c_n, b_n, ahat_n, sigma_n, alpha and beta of the resummation, by the corrected "
            "formulas; resummed-as-printed: by those of the paper letter by letter")
        ->type_name("M");
    command
        ->add_option("--recurrence", options->recurrence,
                     "how the coefficients of a motion are computed, and their rounding: printed (the paper's), "
                     "squares, omega or lattice")
        ->type_name("R");
    options->point.add_to(*command);
    command->add_flag("--check", options->check,
                      "of a problem in balls: compare with a second proof by another route, exit 1 if they disagree");
    return {command, [options] { return run_coefficients(*options); },
            [options](std::string_view /*complex*/) { return options->point.is_complex(); }};
}

}  // namespace libration
