// libration coefficients: the Taylor coefficients of a solution about a point.
#include <fmt/format.h>

#include <memory>

#include "libration/scalar/whole_number.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
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
    std::optional<std::string> from;
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

int run_coefficients(const coefficients_options& options) {
    options.output.check();
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
    command->add_option("--from", options->from, "first power to print (default 0); does not affect the cost")
        ->type_name("N");
    options->point.add_to(*command);
    command->add_flag("--check", options->check,
                      "of a problem in balls: compare with a second proof by another route, exit 1 if they disagree");
    return {command, [options] { return run_coefficients(*options); },
            [options](std::string_view /*complex*/) { return options->point.is_complex(); }};
}

}  // namespace libration
