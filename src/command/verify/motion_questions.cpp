#include "verify/motion_questions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr std::size_t most_known_motions = 4;

}  // namespace

std::vector<known_column> motion_layout::known() {
    auto columns = time_columns::known();
    const auto of_motion = motion_columns::known();
    columns.insert(columns.end(), of_motion.begin(), of_motion.end());
    columns.push_back({"theta", {"theta", "θ", "angle"}});
    columns.push_back(
        {"omega",
         {"omega", "ω", "thetadot", "dtheta", "dthetadt", "dtheta/dt", "theta'", "angularvelocity", "velocity"}});
    return columns;
}

bool motion_layout::fits(const column_names& names) {
    return names.find("time").has_value() || names.find("theta").has_value();
}

motion_layout::motion_layout(const column_names& names, motion_cells usual)
    : time_(names), motion_(names), usual_(std::move(usual)) {
    std::vector<std::string> missing;
    if (!time_.there()) {
        missing.emplace_back("time");
    }
    const auto theta = names.find("theta");
    const auto omega = names.find("omega");
    if (!theta) {
        missing.emplace_back("theta");
    }
    if (!missing.empty()) {
        throw input_error(fmt::format("{} has no column {}: its columns are {}: {}", names.file(), listed(missing),
                                      names.listed(), mapping_remedy));
    }
    compared_.push_back({"theta", *theta});
    if (omega) {
        compared_.push_back({"omega", *omega});
    }
    if (!motion_.names_a_motion() && !usual_.names_a_motion() &&
        !(motion_.has_angle() && !usual_.omega0.text.empty()) &&
        !(motion_.has_speed() && !usual_.theta0.text.empty())) {
        throw input_error(
            fmt::format("{} has no motion: its columns are {}: {}, as 'theta0' and 'omega0', 'gap' or "
                        "'energy', or add --theta0 and --omega0, --gap or --energy",
                        names.file(), names.listed(), mapping_remedy));
    }
}

exact motion_layout::time(const std::vector<std::string>& cells, bool as_double) const {
    return reading_cell(time_.in(cells), [&](const std::string& text) {
        const exact time = time_in(text);
        return as_double && !time.has_periods() ? nearest_double(time) : time;
    });
}

motion_cells motion_layout::motion(const std::vector<std::string>& cells) const {
    motion_cells of = motion_.in(cells);
    of.complete_from(usual_);
    return of;
}

motion_truths& motion_questions::motion_for(const motion_cells& cells) {
    const std::string key = cells.key();
    const auto found =
        std::find_if(known_.begin(), known_.end(), [&](const auto& known) { return known.first == key; });
    if (found != known_.end()) {
        std::rotate(known_.begin(), found, found + 1);
        return *known_.front().second;
    }
    const typed_motion typed = cells.read({.of_programs = true, .as_doubles = rules_.inputs_are_doubles});
    known_.emplace(known_.begin(), key, std::make_unique<motion_truths>(typed, cells.motion_of(typed)));
    known_.resize(std::min(known_.size(), most_known_motions));
    return *known_.front().second;
}

row_question motion_questions::read(const std::vector<std::string>& cells) {
    const exact time = layout_.time(cells, rules_.inputs_are_doubles);
    return motion_for(layout_.motion(cells)).at(time, layout_.compared().size());
}

}  // namespace libration
