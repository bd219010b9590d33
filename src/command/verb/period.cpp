// libration period: T and T* of a motion, by the arithmetic-geometric mean or by a partial sum of the paper's series.
#include "libration/pendulum/energy/period.hpp"

#include <fmt/format.h>

#include <memory>

#include "libration/digits/proved/printed_values.hpp"
#include "libration/scalar/text/decimal.hpp"
#include "motion/motion_options.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace elliptic;
using namespace pendulum;

namespace {

struct period_options {
    motion_options motion;
    arithmetic_options arithmetic;
    output_options output;
    std::string method = "agm";
    std::optional<std::string> order;
};

struct period_request {
    chosen_motion chosen;
    arithmetic numbers;
    period_method method;
    std::optional<int> order;
};

const std::vector<column> period_columns{{"energy", ""},    {"gap", ""},          {"method", ""},
                                         {"order", ""},     {"period", ""},       {"tstar", ""},
                                         {"error", ""},     {"regime", ""},       {"energy_typed", ""},
                                         {"gap_typed", ""}, {"theta0_typed", ""}, {"omega0_typed", ""}};

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

// T and T* in the motion's units.
template <class T>
std::vector<wide_t<T>> period_values(const period_request& request) {
    const motion& m = request.chosen.of;
    const T seconds = time_unit<T>(m);
    const T tstar = effective_period_by({request.method, request.order.value_or(0)}, energy_level_of<T>(m)) * seconds;
    return {widen(T(tstar * quarters_per_period(m.regime()))), widen(tstar)};
}

struct energy_texts {
    std::string energy;
    std::string gap;
};

struct period_texts {
    std::string period = "inf";
    std::string tstar = "inf";
    std::string error = "0";
};

// |T* as printed - true value|, the true value by the mean with more digits. It is nonzero: what is printed is
// rational, and T* at an algebraic energy is not [Schneider].
std::string error_of(const std::string& tstar, const period_request& request) {
    const motion& m = request.chosen.of;
    const auto difference = [&]<class T>() {
        const precision_scope more(request.numbers.digits + working_digits());
        const T truth = effective_period(energy_level_of<T>(m)) * time_unit<T>(m);
        return std::vector<T>{abs(from_exact<T>(read_exact(tstar)) - truth)};
    };
    return printed_right(request.numbers.scalar, error_digits, difference).front().text;
}

period_texts texts_of(const period_request& request) {
    const auto values =
        printed(request.numbers.scalar, request.numbers.digits, [&]<class T>() { return period_values<T>(request); });
    return {values[0].text, values[1].text, error_of(values[1].text, request)};
}

// Energy and gap as they were typed, or to this number of digits.
energy_texts printed_energies(const chosen_motion& chosen, const arithmetic& numbers) {
    if (chosen.energy && chosen.gap) {
        return {*chosen.energy, *chosen.gap};
    }
    const auto pair = printed_right(numbers.scalar, numbers.digits, [&]<class T>() {
        auto [energy, gap] = energies<T>(chosen.of);
        return std::vector<T>{std::move(energy), std::move(gap)};
    });
    return {pair[0].text, pair[1].text};
}

int run_period(const period_options& options) {
    options.output.check();
    const period_request request = choose(options);
    const motion& m = request.chosen.of;
    const energy_texts texts = printed_energies(request.chosen, request.numbers);
    period_texts found;
    if (!at_critical_energy(m.regime())) {
        found = texts_of(request);
    }
    const std::string regime(name_of(m.regime()));
    const std::string order = request.order ? std::to_string(*request.order) : "";
    const chosen_motion& chosen = request.chosen;
    const table data(period_columns,
                     {{number_cell(texts.energy), number_cell(texts.gap), options.method, read_cell(order),
                       number_cell(found.period), number_cell(found.tstar), number_cell(found.error), regime,
                       chosen.energy_typed, chosen.gap_typed, chosen.theta0_typed, chosen.omega0_typed}});
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
    command->add_option("--method", options->method, "agm; series (Kold) or resummed (Knew), with --order")
        ->capture_default_str();
    command->add_option("--order", options->order, "last power k^(2N) of a partial sum")->type_name("N");
    return {command, [options] { return run_period(*options); }};
}

}  // namespace libration
