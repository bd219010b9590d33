// MOTION on the command line: an energy or a gap, or a state, with length and gravity.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libration/pendulum/given_motion.hpp"
#include "libration/pendulum/motion.hpp"
#include "libration/pendulum/typed_motion.hpp"
#include "libration/scalar/dispatch.hpp"

namespace libration {

/// A motion with the texts that represent it in the output.
struct chosen_motion {
    pendulum::motion of;
    bool by_state;       ///< given by theta0 and omega0
    std::string option;  ///< the option that gave the energy, and its value
    std::string value;
    std::optional<std::string> energy;
    std::optional<std::string> gap;
    std::string energy_typed, gap_typed, theta0_typed, omega0_typed;  ///< empty if they were not typed
};

/// The numbers of options that are named like the fields; throws input_error.
pendulum::typed_motion numbers_of_options(const pendulum::given_motion& given);

/// --energy E | --gap G [--theta0 A] [--direction +|-], or --theta0 A --omega0 W; --length L --gravity G.
class motion_options {
public:
    void add_to(CLI::App& command);
    /// Throws input_error, also if the scalar cannot represent E or 2 - E.
    chosen_motion choose_for(const scalar_spec& scalar) const;
    /// The first option that was given, as "--energy '1.71'"; std::nullopt if none was.
    std::optional<std::string> first_given() const;
    /// The argument of the option with this name, for example "--energy".
    const std::optional<std::string>& given(std::string_view option) const;

private:
    chosen_motion choose() const;

    using named = std::pair<const char*, const std::optional<std::string>*>;
    std::array<named, 7> all() const;

    std::optional<std::string> energy_, gap_, theta0_, omega0_, direction_, length_, gravity_;
};

/// The expansion point of a motion if none is given: start for a state, for an energy the top, at E = 2 the bottom.
std::string usual_point_of(const chosen_motion& chosen);

/// The times of a motion in this regime: a list or a range, also multiples of T if it has a period.
std::vector<exact> times_of(const std::string& value, pendulum::regime r);

/// A number as a decimal if that is exact; std::nullopt otherwise, and for std::nullopt.
std::optional<std::string> ending_decimal(const std::optional<exact>& number);

/// An angle or a velocity as a decimal, exact if it terminates, else to `digits` digits.
std::string angle_in_decimals(const exact& angle, long digits);

}  // namespace libration
