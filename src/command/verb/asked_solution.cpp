#include "asked_solution.hpp"

#include <utility>

#include "option/options.hpp"
#include "problem/motion_cells.hpp"
#include "problem/problem_trajectory.hpp"
#include "sweep/study_order.hpp"
#include "text/input_error.hpp"
#include "text/point_file.hpp"

namespace libration {

using namespace pendulum;

namespace {

// The cells that all times of a motion share.
shared_cells cells_of_motion(const asked_solution& asked, const request& how) {
    const chosen_motion& chosen = *asked.motion;
    const answer constants = *asked.of->constants(how);
    const auto constant = [&](const char* name) { return number_cell(constants.at(0, name)); };
    const long digits = how.printed_digits();
    const motion& m = chosen.of;
    const cell theta0 = m.theta0() ? number_cell(angle_in_decimals(*m.theta0(), digits)) : cell();
    const cell omega0 = chosen.by_state ? number_cell(angle_in_decimals(read_typed(chosen.value), digits)) : cell();
    const std::string direction = chosen.by_state || m.omega0_sign() == 0 ? "" : m.direction() < 0 ? "-" : "+";
    const auto energy = [&](const char* name, const std::optional<std::string>& exactly) {
        return exactly ? number_cell(*exactly) : constant(name);
    };
    return {{{"energy", energy("energy", chosen.energy)},
             {"gap", energy("gap", chosen.gap)},
             {"regime", std::string(name_of(m.regime()))},
             {"theta0", theta0},
             {"omega0", omega0}},
            {{"period", constant("period")}, {"tstar", constant("tstar")}, {"radius", constant("radius")}},
            {{"direction", direction}},
            {{"energy_typed", chosen.energy_typed},
             {"gap_typed", chosen.gap_typed},
             {"theta0_typed", chosen.theta0_typed},
             {"omega0_typed", chosen.omega0_typed}}};
}

asked_solution asked_of(chosen_motion chosen, std::vector<exact> times, std::string typed) {
    auto of = solution_of(chosen.of);
    return {std::move(of), std::move(times), std::move(typed), std::move(chosen)};
}

std::vector<known_column> columns_of_motions() {
    auto known = motion_columns::known();
    const auto of_time = time_columns::known();
    known.insert(known.end(), of_time.begin(), of_time.end());
    return known;
}

}  // namespace

partial_table states_of(const asked_solution& asked, const request& how) {
    if (asked.typed == infinite_time) {
        const exact inf{0, unit::one, infinite_time};
        return states_table(asked.of->limits(how), {inf}, {infinite_time}, how.printed_digits());
    }
    try {
        return states_table(*asked.of, asked.times, how, asked.motion ? cells_of_motion(asked, how) : shared_cells{});
    } catch (const error& problem) {
        if (problem.kind() != error_kind::range || !problem.is_about(error_subject::time)) {
            throw;
        }
        throw input_error("--times", asked.typed,
                          "has '" + problem.value() + "', where the angular velocity is too small to be printed",
                          "choose times closer to 0");
    }
}

asked_solution asked_motion(const motion_options& motion, const std::string& typed, long digits) {
    chosen_motion chosen = motion.choose_for({scalar_kind::proved, digits});
    auto times = times_of(typed, chosen.of.regime());
    return asked_of(std::move(chosen), std::move(times), typed);
}

std::vector<asked_solution> asked_motions(const motion_options& motion, const std::string& path,
                                          const std::optional<std::string>& renamed,
                                          const std::optional<std::string>& times) {
    const point_file file("--motions", path, renamed, columns_of_motions());
    const motion_columns columns(file.names());
    const time_columns time(file.names());
    if (time.there() == times.has_value()) {
        throw input_error("--motions", path, time.there() ? "has times, and --times too" : "has no column 'time'",
                          time.there() ? "leave out --times, or the column by --columns time=-" : "add --times LIST");
    }
    std::vector<asked_solution> motions;
    std::string before;
    for (const point_file::row& row : file.rows()) {
        file.reading(row, [&](const auto& all) {
            motion_cells cells = columns.in(all);
            cells.complete_from(motion_cells::of(motion));
            if (motions.empty() || cells.key() != before || !time.there()) {
                motions.push_back(asked_of(cells.choose(), {}, times.value_or("")));
                before = cells.key();
            }
            asked_solution& here = motions.back();
            if (time.there()) {
                here.typed = time.in(all).text;
                here.times.push_back(time_for(time.in(all), here.motion->of.regime()));
            } else {
                here.times = times_of(here.typed, here.motion->of.regime());
            }
            return true;
        });
    }
    return motions;
}

}  // namespace libration
