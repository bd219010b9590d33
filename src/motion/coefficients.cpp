// libration coefficients: the Taylor coefficients a_n of theta about a point of a motion, or of the unknowns of any
// differential equation.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "equation/problem_options.hpp"
#include "equation/problem_series.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "libration/scalar/text/whole_number.hpp"
#include "motion/motion_options.hpp"
#include "motion/motion_series.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace series;
using namespace pendulum;

namespace {

struct coefficients_options {
    motion_options motion;
    problem_options problem;
    arithmetic_options arithmetic;
    output_options output;
    std::string order;
    std::optional<std::string> from;
    std::optional<std::string> at;
    std::optional<std::string> via;
    bool check = false;
};

constexpr long most_rows = 1'000'001;

// --from and --order: the powers to be printed.
template <class Request>
void read_powers(const coefficients_options& options, Request& request) {
    const auto power = [](const char* option, const std::string& value) {
        return reading(option, value, "write a power of the series, 0 or more",
                       [&] { return read_whole_number(value, largest_power, "power"); });
    };
    request.order = power("--order", options.order);
    request.first = options.from ? power("--from", *options.from) : 0;
    if (request.first > request.order) {
        throw input_error("--from", *options.from, "is beyond --order '" + options.order + "'",
                          "write a power up to that");
    }
    if (request.order - request.first >= most_rows) {
        throw input_error("--order", options.order, fmt::format("makes more than {} rows", most_rows),
                          "write a lower power, or the first power to print as --from");
    }
}

// A proof has an additional column for its uncertainty.
table table_of(long first, const std::vector<printed_number>& coefficients, bool proved) {
    std::vector<column> columns{{"n", ""}, {"coefficient", ""}};
    if (proved) {
        columns.push_back({"uncertainty", ""});
    }
    table data(std::move(columns));
    for (const auto& [text, uncertainty] : coefficients) {
        table_row_cells row{first++, number_cell(text)};
        if (proved) {
            row.push_back(number_cell(uncertainty));
        }
        data.add_row(std::move(row));
    }
    return data;
}

void refuse_check(const coefficients_options& options) {
    if (options.check) {
        throw input_error("--check compares two proofs of the coefficients of a --problem: add --scalar ball:DIGITS");
    }
}

// Instead of a motion, any problem.
table coefficients_of_problem(const coefficients_options& options) {
    if (const auto other = options.motion.first_given()) {
        throw input_error(*other + " applies to motions of the pendulum, not to a --problem: leave one of them out");
    }
    problem_series_request request{options.problem.choose(), 0, 0, options.at, options.via};
    read_powers(options, request);
    return naming_option("--problem", [&] {
        if (options.arithmetic.scalar() == "rational") {
            refuse_check(options);
            return problem_fractions(request);
        }
        const arithmetic numbers = options.arithmetic.choose();
        if (numbers.scalar.kind != scalar_kind::proved) {
            refuse_check(options);
        }
        return problem_coefficients(request, numbers, options.check);
    });
}

int run_coefficients(const coefficients_options& options) {
    const whole_exponent_range exponents;  // of a_n ~ R^-n
    options.output.check();
    if (options.problem.given()) {
        options.output.write(coefficients_of_problem(options));
        return 0;
    }
    options.problem.require_problem();
    if (options.check) {
        throw input_error("--check requires --problem: add one, or leave it out");
    }
    if (options.via) {
        throw input_error("--via", *options.via, "is a path in the complex t-plane of a --problem", "leave it out");
    }
    const arithmetic numbers = options.arithmetic.choose();
    series_request request{options.motion.choose_for(numbers.scalar), numbers.scalar, {}, 0};
    read_powers(options, request);
    request.at = point_of(options.at, request.chosen);
    const bool proved = numbers.scalar.kind == scalar_kind::proved;
    options.output.write(table_of(request.first, printed_coefficients(request, numbers.digits), proved));
    return 0;
}

}  // namespace

subcommand coefficients_command(CLI::App& program) {
    const auto options = std::make_shared<coefficients_options>();
    CLI::App* command =
        program.add_subcommand("coefficients", "the Taylor coefficients of theta, or of any problem, about a point");
    options->motion.add_to(*command);
    options->problem.add_to(*command);
    options->arithmetic.add_to(*command, arithmetics::proved_too);
    options->output.add_to(*command);
    command->add_option("--order", options->order, "last power N")->type_name("N")->required();
    command->add_option("--from", options->from, "first power to print (default 0); does not affect the cost")
        ->type_name("N");
    command
        ->add_option("--at", options->at,
                     "top, bottom, start or a time (T/8, 1.1); of a problem a time, also complex: 1+2i")
        ->type_name("POINT");
    command->add_option("--via", options->via, "corners of the path to --at of a problem in the complex plane: 1+i,2+i")
        ->type_name("LIST");
    command->add_flag("--check", options->check,
                      "of a problem in balls: compare with a second proof by another route, exit 1 if they disagree");
    return {command, [options] { return run_coefficients(*options); }};
}

}  // namespace libration
