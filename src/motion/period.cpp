// libration period: T and T* of a motion, by the arithmetic-geometric mean or by a partial sum of the paper's series.
#include "libration/pendulum/energy/period.hpp"

#include <fmt/format.h>

#include <memory>

#include "libration/scalar/text/decimal.hpp"
#include "motion/motion_options.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "run/agreement.hpp"
#include "run/proofs.hpp"
#include "text/input_error.hpp"

namespace libration {

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

// The text format leaves out what was typed.
constexpr std::size_t untyped_columns = 8;

period_method read_method(const std::string& name) {
    if (name == "agm") {
        return period_method::agm;
    }
    if (name == "series" || name == "resummed") {
        return name == "series" ? period_method::series : period_method::resummed;
    }
    throw input_error("--method", name, "is no method for the period", "write agm, series or resummed");
}

period_request choose(const period_options& options) {
    const period_method method = read_method(options.method);
    std::optional<int> order;
    if (options.order) {
        order = order_of("--order", *options.order);
    }
    if (method == period_method::agm && order) {
        throw input_error("--order", *options.order, "has no meaning for --method agm",
                          "leave it out, or write --method series or resummed");
    }
    if (method != period_method::agm && !order) {
        throw input_error("--method", options.method, "is a partial sum", "add --order N, its last power being k^(2N)");
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
    const T tstar = effective_period_by({request.method, request.order.value_or(0)}, orbit_of<T>(m)) * seconds;
    return {widen(T(tstar * quarters_per_period(m.regime()))), widen(tstar)};
}

std::vector<mpfr> period_values(const period_request& request) {
    const scalar_spec& scalar = request.numbers.scalar;
    const auto compute = [&](long guard) {
        return with_scalar(scalar, guard, [&]<class T>() { return period_values<T>(request); });
    };
    if (scalar.kind != scalar_kind::arbitrary) {
        return compute(0);
    }
    return agreed_values(scalar.digits, compute);
}

struct period_texts {
    std::string period = "inf";
    std::string tstar = "inf";
    std::string error = "0";
};

// |T* as printed - truth|, the truth by the mean with more digits.
std::string error_of(const std::string& tstar, const period_request& request) {
    const precision_scope more(request.numbers.scalar.digits + 30);
    const mpfr truth = effective_period(orbit_of<mpfr>(request.chosen.of)) * time_unit<mpfr>(request.chosen.of);
    return to_decimal(mpfr(abs(from_exact<mpfr>(read_exact(tstar)) - truth)), error_digits);
}

period_texts proved_texts(const period_request& request) {
    const auto values = proved_decimals(request.numbers.digits, [&] { return period_values<ball>(request); });
    const motion& m = request.chosen.of;
    // What the printed T* misses is not 0: it is rational, and T* at an algebraic energy is not [Schneider].
    const auto error = proved_decimals(error_digits, [&] {
        const precision_scope more(request.numbers.digits + working_digits());
        const ball truth = effective_period(orbit_of<ball>(m)) * time_unit<ball>(m);
        return std::vector<ball>{abs(from_exact<ball>(read_exact(values[1].text)) - truth)};
    });
    return {values[0].text, values[1].text, error[0].text};
}

// Energy and gap as they were typed, or with every digit proved.
energy_texts proved_energy_texts(const chosen_motion& chosen, long digits) {
    if (chosen.energy && chosen.gap) {
        return {*chosen.energy, *chosen.gap};
    }
    const auto pair = proved_decimals(digits, [&] {
        auto [energy, gap] = energies<ball>(chosen.of);
        return std::vector<ball>{std::move(energy), std::move(gap)};
    });
    return {pair[0].text, pair[1].text};
}

period_texts rounded_texts(const period_request& request) {
    const auto values = period_values(request);
    const std::string tstar = to_decimal(values[1], request.numbers.digits);
    return {to_decimal(values[0], request.numbers.digits), tstar, error_of(tstar, request)};
}

int run_period(const period_options& options) {
    options.output.check();
    const period_request request = choose(options);
    const motion& m = request.chosen.of;
    const long digits = request.numbers.digits;
    const bool proved = request.numbers.scalar.kind == scalar_kind::proved;
    const energy_texts texts =
        proved ? proved_energy_texts(request.chosen, digits) : energy_texts_of(request.chosen, digits);
    period_texts printed;
    if (!at_critical_energy(m.regime())) {
        printed = proved ? proved_texts(request) : rounded_texts(request);
    }
    const std::string regime(name_of(m.regime()));
    const std::string order = request.order ? std::to_string(*request.order) : "";
    const chosen_motion& chosen = request.chosen;
    const table data(period_columns,
                     {{number_cell(texts.energy), number_cell(texts.gap), options.method, read_cell(order),
                       number_cell(printed.period), number_cell(printed.tstar), number_cell(printed.error), regime,
                       chosen.energy_typed, chosen.gap_typed, chosen.theta0_typed, chosen.omega0_typed}});
    std::string text;
    for (std::size_t i = 0; i < untyped_columns; ++i) {
        if (!data.rows()[0][i].is_empty()) {
            text += fmt::format("{:<8}{}\n", data.columns()[i].name, data.rows()[0][i].text());
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
