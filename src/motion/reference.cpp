// libration reference: proved digits of theta, omega, E, T, T* and R of any motion, at any times.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "motion/motion_options.hpp"
#include "motion/typed_times.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

struct reference_options {
    motion_options motion;
    output_options output;
    std::optional<std::string> digits;
    std::string times;
    bool check = false;
};

// The second route sums about D/3 columns of D digits: minutes at this many, hours far above.
constexpr long most_checked_digits = 10'000;

const std::vector<column> reference_columns{
    {"energy", ""},       {"gap", ""},       {"regime", ""},       {"theta0", ""},      {"omega0", ""},
    {"time", ""},         {"theta", ""},     {"omega", ""},        {"period", ""},      {"tstar", ""},
    {"radius", ""},       {"digits", ""},    {"rigour", ""},       {"direction", ""},   {"time_typed", ""},
    {"energy_typed", ""}, {"gap_typed", ""}, {"theta0_typed", ""}, {"omega0_typed", ""}};

// The cells that all times share, in the order of the columns; those of a time are empty.
table_row_cells shared_cells(const chosen_motion& chosen, proved_states& states, long digits) {
    const motion& m = chosen.of;
    std::string energy = chosen.energy.value_or("");
    std::string gap = chosen.gap.value_or("");
    if (energy.empty() || gap.empty()) {
        const auto proved = states.energies();
        energy = proved[0];
        gap = proved[1];
    }
    const auto [period, tstar, radius] = states.constants();
    const cell theta0 = m.theta0() ? number_cell(angle_in_decimals(*m.theta0(), digits)) : cell();
    const cell omega0 = chosen.by_state ? number_cell(angle_in_decimals(read_exact(chosen.value), digits)) : cell();
    const std::string direction = chosen.by_state || m.omega0_sign() == 0 ? "" : m.direction() < 0 ? "-" : "+";
    return {number_cell(energy),
            number_cell(gap),
            std::string(name_of(m.regime())),
            theta0,
            omega0,
            {},
            {},
            {},
            number_cell(period),
            number_cell(tstar),
            number_cell(radius),
            digits,
            "proved",
            direction,
            {},
            chosen.energy_typed,
            chosen.gap_typed,
            chosen.theta0_typed,
            chosen.omega0_typed};
}

constexpr std::size_t time_at = 5;
constexpr std::size_t theta_at = 6;
constexpr std::size_t omega_at = 7;
constexpr std::size_t time_typed_at = 14;

// The motion first, a line a column, and then every time.
std::string lines_of(const table& data) {
    std::string text;
    const auto line = [&](std::size_t i, const table_row_cells& row) {
        if (!row[i].is_empty()) {
            text += fmt::format("{:<10}{}\n", data.columns()[i].name, row[i].text());
        }
    };
    for (std::size_t i = 0; i < time_typed_at; ++i) {
        if (i < time_at || i > omega_at) {
            line(i, data.rows().front());
        }
    }
    for (const auto& row : data.rows()) {
        text += '\n';
        for (const std::size_t i : {time_at, theta_at, omega_at}) {
            line(i, row);
        }
    }
    return text;
}

void require_check(proved_states& states, const exact& time, const proved_states::state_text& printed) {
    if (!states.confirms(time)) {
        throw std::runtime_error(fmt::format(
            "the two proved routes disagree at time {}: theta = {}, omega = {} is not enclosed by the sum over "
            "separatrix solutions",
            time.text, printed.theta, printed.omega));
    }
}

int run_reference(const reference_options& options) {
    options.output.check();
    const long digits = digits_of(options.digits);
    if (options.check && digits > most_checked_digits) {
        throw input_error("--digits", std::to_string(digits), "with --check would take hours",
                          fmt::format("check {} digits or fewer", most_checked_digits));
    }
    const chosen_motion chosen = options.motion.choose_for({scalar_kind::proved, digits});
    const auto times = times_of(options.times, chosen.of.regime());
    proved_states states(chosen.of, digits);
    table data(reference_columns);
    const auto decimals = times_in_decimals(chosen.of, times, digits);
    table_row_cells row = shared_cells(chosen, states, digits);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const exact& time = times[i];
        const auto state = state_at(states, time, options.times);
        if (options.check) {
            require_check(states, time, state);
        }
        row[time_at] = number_cell(decimals[i]);
        row[theta_at] = cell::number(state.theta, digits);
        row[omega_at] = cell::number(state.omega, digits);
        row[time_typed_at] = time.text;
        data.add_row(row);
    }
    options.output.write(data, lines_of(data));
    return 0;
}

}  // namespace

subcommand reference_command(CLI::App& program) {
    const auto options = std::make_shared<reference_options>();
    CLI::App* command =
        program.add_subcommand("reference", "proved digits of theta, omega, E, T, T* and R at a list of times");
    options->motion.add_to(*command);
    options->output.add_to(*command);
    command->add_option("--digits", options->digits, "significant digits, each proved to one unit in the last (50)")
        ->type_name("D");
    command->add_option("--times,--time", options->times, "times: 0,1.5,T/4 or a range 0:20:401")
        ->type_name("LIST")
        ->required();
    command->add_flag("--check", options->check, "compare with a second proved route, exit 1 where they disagree");
    return {command, [options] { return run_reference(*options); }};
}

}  // namespace libration
