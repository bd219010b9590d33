// libration coefficients: the Taylor coefficients a_n of theta about a point of a motion.
#include "libration/pendulum/coefficients.hpp"

#include <fmt/format.h>

#include <memory>

#include "agreement.hpp"
#include "libration/pendulum/expansion.hpp"
#include "libration/scalar/decimal.hpp"
#include "options.hpp"
#include "subcommand.hpp"
#include "sweep/input_error.hpp"

namespace libration {

namespace {

struct coefficients_options {
    motion_options motion;
    arithmetic_options arithmetic;
    output_options output;
    std::string order;
    std::optional<std::string> at;
};

struct coefficients_request {
    chosen_motion chosen;
    arithmetic numbers;
    expansion_point at;
    int order;
};

expansion_point point_of(const coefficients_options& options, const chosen_motion& chosen) {
    const bool critical = at_critical_energy(chosen.of.regime());
    const char* const remedy = "write top, bottom, start or a time such as 1.1 or T/8";
    if (!options.at) {
        return read_expansion_point(chosen.by_state ? "start" : critical ? "bottom" : "top");
    }
    expansion_point point = reading("--at", *options.at, remedy, [&] { return read_expansion_point(*options.at); });
    if (critical && point.where == expansion_point::place::top) {
        throw input_error("--at", *options.at, "is not a point of a motion with E = 2",
                          "write bottom, start or a time");
    }
    if (critical && point.time.measure == unit::period) {
        throw input_error("--at", *options.at, "is a multiple of an infinite period", "write a time without T");
    }
    return point;
}

// a_n in the motion's unit of time. The scaled coefficients are rounded in T, and leave its range only here, in mpfr.
template <class T>
std::vector<mpfr> coefficient_values(const coefficients_request& request) {
    const exact_solution<T> solution(request.chosen.of);
    const expansion<T> series = expand(solution, request.at, request.order);
    const mpfr scale = widen(series.scale) * time_unit<mpfr>(request.chosen.of);
    std::vector<mpfr> values;
    mpfr power(1);
    for (int n = 0; n <= request.order; ++n) {
        values.push_back(widen(series.scaled[n]) / power);
        power *= scale;
    }
    return values;
}

std::vector<mpfr> coefficient_values(const coefficients_request& request) {
    const scalar_spec& scalar = request.numbers.scalar;
    const auto compute = [&](long guard) {
        return with_scalar(scalar, guard, [&]<class T>() {
            const precision_scope scope(scalar.digits + guard + 20);
            return coefficient_values<T>(request);
        });
    };
    return scalar.kind == scalar_kind::arbitrary ? agreed_values(scalar.digits, compute) : compute(20);
}

int run_coefficients(const coefficients_options& options) {
    options.output.check();
    const arithmetic numbers = options.arithmetic.choose();
    coefficients_request request{options.motion.choose_for(numbers.scalar), numbers, {}, 0};
    request.order = order_of("--order", options.order);
    request.at = point_of(options, request.chosen);
    table data{{{"n", ""}, {"coefficient", ""}}, {}};
    for (const mpfr& value : coefficient_values(request)) {
        data.rows.push_back({std::to_string(data.rows.size()), to_decimal(value, request.numbers.digits)});
    }
    options.output.write(data);
    return 0;
}

}  // namespace

subcommand coefficients_command(CLI::App& program) {
    const auto options = std::make_shared<coefficients_options>();
    CLI::App* command = program.add_subcommand("coefficients", "the Taylor coefficients of theta about a point");
    options->motion.add_to(*command);
    options->arithmetic.add_to(*command);
    options->output.add_to(*command);
    command->add_option("--order", options->order, "last power N")->type_name("N")->required();
    command->add_option("--at", options->at, "top, bottom, start or a time (T/8, 1.1)")->type_name("POINT");
    return {command, [options] { return run_coefficients(*options); }};
}

}  // namespace libration
