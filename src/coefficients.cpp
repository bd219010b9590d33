// libration coefficients: the Taylor coefficients a_n of theta about a point of a motion.
#include <memory>

#include "libration/scalar/decimal.hpp"
#include "motion_series.hpp"
#include "options.hpp"
#include "subcommand.hpp"

namespace libration {

namespace {

struct coefficients_options {
    motion_options motion;
    arithmetic_options arithmetic;
    output_options output;
    std::string order;
    std::optional<std::string> at;
};

table table_of(const std::vector<proved_decimal>& coefficients) {
    table data{{{"n", ""}, {"coefficient", ""}, {"uncertainty", ""}}, {}};
    for (const auto& [text, uncertainty] : coefficients) {
        data.rows.push_back({std::to_string(data.rows.size()), text, uncertainty});
    }
    return data;
}

int run_coefficients(const coefficients_options& options) {
    options.output.check();
    const arithmetic numbers = options.arithmetic.choose();
    series_request request{options.motion.choose_for(numbers.scalar), numbers.scalar, {}, 0};
    request.order = order_of("--order", options.order);
    request.at = point_of(options.at, request.chosen);
    if (numbers.scalar.kind == scalar_kind::proved) {
        options.output.write(table_of(proved_coefficients(request)));
        return 0;
    }
    table data{{{"n", ""}, {"coefficient", ""}}, {}};
    for (const mpfr& value : coefficient_values(request)) {
        data.rows.push_back({std::to_string(data.rows.size()), to_decimal(value, numbers.digits)});
    }
    options.output.write(data);
    return 0;
}

}  // namespace

subcommand coefficients_command(CLI::App& program) {
    const auto options = std::make_shared<coefficients_options>();
    CLI::App* command = program.add_subcommand("coefficients", "the Taylor coefficients of theta about a point");
    options->motion.add_to(*command);
    options->arithmetic.add_to(*command, arithmetics::proved_too);
    options->output.add_to(*command);
    command->add_option("--order", options->order, "last power N")->type_name("N")->required();
    command->add_option("--at", options->at, "top, bottom, start or a time (T/8, 1.1)")->type_name("POINT");
    return {command, [options] { return run_coefficients(*options); }};
}

}  // namespace libration
