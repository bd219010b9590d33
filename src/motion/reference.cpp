// libration reference: proved digits of theta, omega, E, T, T* and R of any motion, at any times.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "equation/problem_options.hpp"
#include "equation/problem_reference.hpp"
#include "equation/problem_trajectory.hpp"
#include "libration/problem/known_facts.hpp"
#include "motion/event_options.hpp"
#include "motion/motion_cells.hpp"
#include "motion/problem_events.hpp"
#include "motion/typed_times.hpp"
#include "option/options.hpp"
#include "option/subcommand.hpp"
#include "run/grid.hpp"
#include "run/parallel.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"
#include "text/point_file.hpp"

namespace libration {

using namespace pendulum;

namespace {

struct reference_options {
    motion_options motion;
    problem_options problem;
    output_options output;
    event_options events;
    std::optional<std::string> digits, times, motions, columns, jobs;
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
    const cell omega0 = chosen.by_state ? number_cell(angle_in_decimals(read_typed(chosen.value), digits)) : cell();
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

// Whether two rows are of one motion: all cells but those of the time are the same.
bool same_motion(const table_row_cells& a, const table_row_cells& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if ((i < time_at || i > omega_at) && i != time_typed_at && a[i].text() != b[i].text()) {
            return false;
        }
    }
    return true;
}

// Each motion first, a line a column, and then every time of it.
std::string lines_of(const table& data) {
    std::string text;
    const auto line = [&](std::size_t i, const table_row_cells& row) {
        if (!row[i].is_empty()) {
            text += fmt::format("{:<10}{}\n", data.columns()[i].name, row[i].text());
        }
    };
    const table_row_cells* before = nullptr;
    for (const auto& row : data.rows()) {
        if (before == nullptr || !same_motion(*before, row)) {
            text += text.empty() ? "" : "\n";
            for (std::size_t i = 0; i < time_typed_at; ++i) {
                if (i < time_at || i > omega_at) {
                    line(i, row);
                }
            }
        }
        before = &row;
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

// A motion with the times that it is asked at.
struct asked_motion {
    chosen_motion chosen;
    std::vector<exact> times;
    std::string said;  ///< what named the times, for complaints
};

std::vector<table_row_cells> rows_of(const asked_motion& asked, long digits, bool check) {
    proved_states states(asked.chosen.of, digits);
    const auto decimals = times_in_decimals(asked.chosen.of, asked.times, digits);
    table_row_cells row = shared_cells(asked.chosen, states, digits);
    std::vector<table_row_cells> rows;
    rows.reserve(asked.times.size());
    for (std::size_t i = 0; i < asked.times.size(); ++i) {
        const exact& time = asked.times[i];
        const auto state = state_at(states, time, asked.said);
        if (check) {
            require_check(states, time, state);
        }
        row[time_at] = number_cell(decimals[i]);
        row[theta_at] = cell::number(state.theta, digits);
        row[omega_at] = cell::number(state.omega, digits);
        row[time_typed_at] = time.text;
        rows.push_back(row);
    }
    return rows;
}

asked_motion motion_of_options(const reference_options& options, long digits) {
    if (!options.times) {
        throw input_error("no times are given: add --times LIST");
    }
    if (options.columns) {
        throw input_error("--columns", *options.columns, "comes without --motions", "leave it out");
    }
    chosen_motion chosen = options.motion.choose_for({scalar_kind::proved, digits});
    auto times = times_of(*options.times, chosen.of.regime());
    return {std::move(chosen), std::move(times), *options.times};
}

std::vector<known_column> columns_of_motions() {
    auto known = motion_columns::known();
    const auto of_time = time_columns::known();
    known.insert(known.end(), of_time.begin(), of_time.end());
    return known;
}

// The motions of a file, those of consecutive rows together.
std::vector<asked_motion> motions_of_file(const reference_options& options) {
    const point_file file("--motions", *options.motions, options.columns, columns_of_motions());
    const motion_columns columns(file.names());
    const time_columns time(file.names());
    if (time.there() == options.times.has_value()) {
        throw input_error("--motions", *options.motions,
                          time.there() ? "has times, and --times too" : "has no column 'time'",
                          time.there() ? "leave out --times, or the column by --columns time=-" : "add --times LIST");
    }
    std::vector<asked_motion> asked;
    std::string before;
    for (const point_file::row& row : file.rows()) {
        file.reading(row, [&](const auto& all) {
            motion_cells cells = columns.in(all);
            cells.complete_from(motion_cells::of(options.motion));
            if (asked.empty() || cells.key() != before || !time.there()) {
                asked.push_back({cells.choose(), {}, options.times.value_or("")});
                before = cells.key();
            }
            asked_motion& here = asked.back();
            if (time.there()) {
                here.said = time.in(all).text;
                here.times.push_back(time_for(time.in(all), here.chosen.of.regime()));
            } else {
                here.times = times_of(here.said, here.chosen.of.regime());
            }
            return true;
        });
    }
    return asked;
}

// When a condition holds.
partial_table events_of_problem(const reference_options& options, long digits) {
    if (options.times) {
        throw input_error("--times", *options.times, "comes with --until, which finds the times", "leave one out");
    }
    const auto system = options.problem.choose();
    const auto request = options.events.request(options.problem, system);
    auto found = naming_option("--until", [&] {
        return problem_events(system, request, digits, options.check,
                              [&](const table& data) { options.output.write(data, lines_of_states(data)); });
    });
    std::string text = lines_of_states(found.data);
    return {std::move(found.data), std::move(text), std::move(found.missing)};
}

// The limits of the unknowns, by a lemma.
table state_at_infinity(const problem_options& problem, long digits) {
    const auto system = problem.equations();
    const auto limits = [&] {
        try {
            return proved_limits(system, digits);
        } catch (const error& missing) {
            throw missing.subject() == "time" ? error(missing.kind(), "--time", missing.value(), missing.reason())
                                              : missing;
        }
    }();
    table data(columns_of_states(problem.choose()));
    table_row_cells row{cell::number("inf", digits)};
    for (const proved_decimal& each : limits) {
        row.push_back(cell::number(each.text, digits));
    }
    row.insert(row.end(), {digits, "proved", "inf"});
    data.add_row(std::move(row));
    return data;
}

// Instead of a motion, any problem.
partial_table reference_of_problem(const reference_options& options, long digits) {
    if (const auto other = options.motion.first_given()) {
        throw input_error(*other + " is of a motion of the pendulum, which --problem replaces: leave one of them out");
    }
    const auto refuse = [](const char* option, const std::optional<std::string>& value) {
        if (value) {
            throw input_error(option, *value, "has no meaning for a problem", "leave it out");
        }
    };
    refuse("--motions", options.motions);
    refuse("--columns", options.columns);
    refuse("--jobs", options.jobs);
    if (options.events.given()) {
        return events_of_problem(options, digits);
    }
    options.events.require_none();
    if (!options.times) {
        throw input_error("no times are given: add --times LIST, or --until \"x = 0\"");
    }
    if (*options.times == "inf") {
        if (options.check) {
            throw input_error("--check compares two proofs and --time inf has one, by a closed form: leave it out");
        }
        table state = state_at_infinity(options.problem, digits);
        std::string text = lines_of_states(state);
        return {std::move(state), std::move(text), {}};
    }
    const auto system = options.problem.choose();
    const auto times = times_of_problem(*options.times);
    return naming_option("--problem", [&] { return problem_reference(system, times, digits, options.check); });
}

int run_reference(const reference_options& options) {
    options.output.check();
    const long digits = digits_of(options.digits);
    if (options.problem.given()) {
        const partial_table found = reference_of_problem(options, digits);
        if (found.has_output()) {
            options.output.write(found.rows, found.text);
        }
        require_complete(found);
        return 0;
    }
    options.problem.require_problem();
    options.events.require_absent();
    if (options.check && digits > most_checked_digits) {
        throw input_error("--digits", std::to_string(digits), "with --check would take hours",
                          fmt::format("ask for {} digits or fewer", most_checked_digits));
    }
    const std::vector<asked_motion> asked =
        options.motions ? motions_of_file(options) : std::vector<asked_motion>{motion_of_options(options, digits)};
    progress shown("reference", asked.size());
    const auto parts = parallel_map(asked.size(), jobs_of(options.jobs), shown,
                                    [&](std::size_t i) { return rows_of(asked[i], digits, options.check); });
    table data(reference_columns);
    for (const auto& part : parts) {
        for (const table_row_cells& row : part) {
            data.add_row(row);
        }
    }
    options.output.write(data, lines_of(data));
    return 0;
}

}  // namespace

subcommand reference_command(CLI::App& program) {
    const auto options = std::make_shared<reference_options>();
    CLI::App* command = program.add_subcommand(
        "reference", "proved digits of theta, omega, E, T, T* and R, or of any problem, at a list of times");
    options->motion.add_to(*command);
    options->problem.add_to(*command);
    options->output.add_to(*command, output_options::columns_option::not_here);
    command->add_option("--digits", options->digits, "significant digits, each proved to one unit in the last (50)")
        ->type_name("D");
    command->add_option("--times,--time", options->times, "times: 0,1.5,T/4 or a range 0:20:401")->type_name("LIST");
    command
        ->add_option("--motions", options->motions,
                     "a file with a motion in each row: theta0 and omega0, gap or energy, and a time unless --times is "
                     "given; - for stdin")
        ->type_name("FILE");
    command->add_option("--columns", options->columns, "the names of its columns: t=time,E=energy, - for none of these")
        ->type_name("THEIRS=OURS,...");
    command->add_option("--jobs", options->jobs, "threads; all cores without it")->type_name("J");
    options->events.add_to(*command);
    command->add_flag("--check", options->check,
                      "compare with a second proof by another route, exit 1 where they disagree");
    return {command, [options] { return run_reference(*options); }};
}

}  // namespace libration
