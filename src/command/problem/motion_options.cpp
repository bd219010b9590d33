#include "motion_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "libration/number/grid.hpp"
#include "libration/pendulum/dimensionless_time.hpp"
#include "libration/pendulum/energy.hpp"
#include "libration/pendulum/period.hpp"
#include "libration/problem/known/pendulum.hpp"
#include "libration/scalar/decimal.hpp"
#include "motion_cells.hpp"
#include "option/options.hpp"
#include "run/progress.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr const char* times_remedy = "write times such as 0,1.5,T/4 or a range 0:20:401";

// What to write instead of the value of an option.
std::string remedy_of(const std::string& option) {
    static const std::map<std::string, std::string> remedies{
        {"--energy", "write an energy of 0 or more, such as 1.71, 171/100 or 1e-30"},
        {"--gap", "write a gap 2 - E of at most 2, such as 1.71, 171/100 or 1e-30"},
        {"--theta0", "write an angle such as 2.5, 3pi/4 or 150deg; with an energy E, one with 1 - cos(angle) <= E"},
        {"--omega0", "write a number such as 1.71, 171/100 or 1e-30"},
        {"--direction", "write + or -"},
        {"--length", "write a positive number, and another one in --gravity"},
        {"--gravity", "write a positive number, and another one in --length"}};
    return remedies.at(option);
}

// An error about the value of an option, or with a prefix about that of the field of this name.
template <class Read>
auto reading_motion(const std::string& prefix, const Read& read) {
    try {
        return read();
    } catch (const error& problem) {
        if (problem.kind() == error_kind::undecided) {
            throw error(error_kind::undecided, prefix + problem.subject(), problem.value(), problem.reason());
        }
        throw input_error(prefix + problem.subject(), problem.value(), problem.reason(),
                          remedy_of(prefix + problem.subject()));
    }
}

// A line on stderr, once, for a number of more than three turns, which is often meant in degrees.
void note_radians(const exact& angle) {
    static std::once_flag noted;
    const rational size = angle.coefficient < 0 ? rational(-angle.coefficient) : angle.coefficient;
    if (angle.measure == unit::one && size > rational(132, 7)) {
        std::call_once(noted, [&] {
            say_line(fmt::format("--theta0 {0} is more than three turns, as it is in radians: write {0}deg for degrees",
                                 angle.text));
        });
    }
}

}  // namespace

typed_motion numbers_of_options(const given_motion& given) {
    return reading_motion("--", [&] { return typed_numbers(given); });
}

std::string usual_point_of(const chosen_motion& chosen) {
    return chosen.by_state ? "start" : at_critical_energy(chosen.of.regime()) ? "bottom" : "top";
}

std::vector<exact> times_of(const std::string& value, regime r) {
    auto times = reading("--times", value, times_remedy, [&] { return read_grid(value); });
    for (const exact& time : times) {
        if (time.measure == unit::degree) {
            throw input_error("--times", value, "has the angle '" + time.text + "'", times_remedy);
        }
        if (time.has_periods() && at_critical_energy(r)) {
            throw input_error("--times", value, "has '" + time.text + "', a multiple of an infinite period",
                              "write times without T at E = 2");
        }
    }
    return times;
}

void motion_options::add_to(CLI::App& command) {
    const char* const group = "Motion";
    command.add_option("--energy", energy_, "energy E: starts at the top, (+arccos(1-E), 0) or (pi, +-sqrt(2E-4))")
        ->group(group)
        ->type_name("E");
    command.add_option("--gap", gap_, "the energy as 2 - E, exact next to the separatrix")
        ->group(group)
        ->type_name("G");
    command.add_option("--theta0", theta0_, "angle at t = 0: 2.5, 3pi/4, 150deg")->group(group)->type_name("A");
    command.add_option("--omega0", omega0_, "angular velocity at t = 0 (with --theta0)")->group(group)->type_name("W");
    command.add_option("--direction", direction_, "sign of omega at t = 0 for motions given by energy: + or -")
        ->group(group)
        ->type_name("+|-");
    command.add_option("--length", length_, "length in metres: times are then seconds")->group(group)->type_name("L");
    command.add_option("--gravity", gravity_, "gravity in m/s^2 (with --length)")->group(group)->type_name("G");
}

chosen_motion motion_options::choose() const {
    for (const auto& [name, value] : all()) {
        if (*value && (*value)->empty()) {
            throw input_error(name, "", "is empty", remedy_of(name));
        }
    }
    chosen_motion chosen = reading_motion("", [&] { return motion_cells::of(*this).choose({}); });
    if (theta0_) {
        note_radians(read_exact(*theta0_));
    }
    return chosen;
}

chosen_motion motion_options::choose_for(const scalar_spec& scalar) const {
    chosen_motion chosen = choose();
    if (scalar.kind == scalar_kind::proved) {
        return chosen;  // no energy is outside the range of a ball
    }
    try {
        with_scalar(scalar, 0, [&]<class T>() { energies<T>(chosen.of); });
    } catch (const error& problem) {
        if (problem.kind() != error_kind::range) {
            throw;
        }
        throw input_error(chosen.option, chosen.value, "is outside the range of " + scalar.name(),
                          "use --scalar mpfr:DIGITS");
    }
    return chosen;
}

std::array<motion_options::named, 7> motion_options::all() const {
    return {named{"--energy", &energy_},       named{"--gap", &gap_},
            named{"--theta0", &theta0_},       named{"--omega0", &omega0_},
            named{"--direction", &direction_}, named{"--length", &length_},
            named{"--gravity", &gravity_}};
}

std::optional<std::string> motion_options::first_given() const {
    for (const auto& [name, value] : all()) {
        if (*value) {
            return fmt::format("{} '{}'", name, **value);
        }
    }
    return std::nullopt;
}

const std::optional<std::string>& motion_options::given(std::string_view option) const {
    const auto options = all();
    const auto* const found =
        std::find_if(options.begin(), options.end(), [&](const named& each) { return each.first == option; });
    if (found == options.end()) {
        throw std::logic_error("no option of a motion: " + std::string(option));
    }
    return *found->second;
}

std::optional<std::string> ending_decimal(const std::optional<exact>& number) {
    return number && number->is_fraction() ? to_finite_decimal(number->coefficient) : std::nullopt;
}

std::string angle_in_decimals(const exact& angle, long digits) { return decimal_of(angle, digits); }

}  // namespace libration
