// libration period: T and T* of a motion, by the arithmetic-geometric mean or by a partial sum of the paper's series.
#include <fmt/format.h>

#include <memory>

#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "problem/motion_options.hpp"
#include "problem/period_table.hpp"
#include "text/input_error.hpp"

namespace libration {

using pendulum::period_method;

namespace {

struct period_options {
    motion_options motion;
    arithmetic_options arithmetic;
    output_options output;
    std::string method = "agm";
    std::optional<std::string> order;
};

period_method read_period_method(const std::string& name) {
    if (name == "agm") {
        return period_method::agm;
    }
    if (name == "series" || name == "resummed") {
        return name == "series" ? period_method::series : period_method::resummed;
    }
    throw input_error("--method", name, "is not a method for the period", "write agm, series or resummed");
}

period_request choose(const period_options& options) {
    const period_method method = read_period_method(options.method);
    std::optional<int> order;
    if (options.order) {
        order = order_of("--order", *options.order);
    }
    if (method == period_method::agm && order) {
        throw input_error("--order", *options.order, "has no meaning for --method agm",
                          "leave it out, or write --method series or resummed");
    }
    if (method != period_method::agm && !order) {
        throw input_error("--method", options.method, "is a partial sum", "add --order N for the last power k^(2N)");
    }
    const arithmetic numbers = options.arithmetic.choose();
    period_request request{options.motion.choose_for(numbers.scalar), numbers, method, order};
    if (method != period_method::agm && at_critical_energy(request.chosen.of.regime())) {
        throw input_error("--method", options.method, "has no sum at E = 2, where the period is infinite",
                          "use --method agm");
    }
    return request;
}

int run_period(const period_options& options) {
    options.output.check();
    const table data = period_table(choose(options));
    std::string text;
    for (std::size_t i = 0; i < data.columns().size(); ++i) {
        const std::string& name = data.columns()[i].name;
        if (!data.rows()[0][i].is_empty()) {
            text += fmt::format("{:<8}{}{}\n", name, name.size() < 8 ? "" : "  ", data.rows()[0][i].text());
        }
    }
    options.output.write(data, text);
    return 0;
}

}  // namespace

subcommand period_command(CLI::App& program) {
    const auto options = std::make_shared<period_options>();
    CLI::App* command = program.add_subcommand("period", "the period T and the effective period T* of a motion");
    options->motion.add_to(*command);
    options->arithmetic.add_to(*command, arithmetics::proved_too);
    options->output.add_to(*command);
    command
        ->add_option("--method", options->method,
                     "agm, or the series (Kold in the paper) or resummed (Knew), truncated at --order")
        ->capture_default_str();
    command->add_option("--order", options->order, "last power k^(2N) of a partial sum")->type_name("N");
    return {command, [options] { return run_period(*options); }};
}

}  // namespace libration
