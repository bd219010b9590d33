#include "table/motion_grid.hpp"

#include <fmt/format.h>

#include "libration/number/grid.hpp"
#include "problem/motion_options.hpp"
#include "text/input_error.hpp"

namespace libration {

using namespace pendulum;

namespace {

constexpr const char* energies_remedy = "write energies such as 0.5,1.71,2.02 or 0.1:1.9:19";
constexpr const char* gaps_remedy = "write gaps 2 - E such as 1e-3,-1e-3 or 1e-1:1e-12:12log";
constexpr const char* angles_remedy = "write angles such as 60deg,pi/2,2.5 or 10deg:170deg:17";
constexpr const char* speeds_remedy = "write angular velocities such as 0,-0.3,1/2";

std::vector<exact> angles_of(const std::string& words) {
    auto angles = reading("--theta0", words, angles_remedy, [&] { return read_grid(words); });
    for (const exact& angle : angles) {
        if (angle.has_periods()) {
            throw input_error("--theta0", words, "has the time '" + angle.text + "'", angles_remedy);
        }
    }
    return angles;
}

// The motions of one list of energies or gaps, from every angle where there are some.
void add_by_energy(std::vector<grid_motion>& motions, const option_words& said, const std::string& option,
                   const typed_motion& usual) {
    const bool by_gap = option == "--gaps";
    const std::string& words = *said[option];
    const char* const remedy = by_gap ? gaps_remedy : energies_remedy;
    const auto& angle_words = said["--theta0"];
    std::vector<std::optional<exact>> angles{std::nullopt};
    if (angle_words) {
        const auto given = angles_of(*angle_words);
        angles.assign(given.begin(), given.end());
    }
    for (const exact& number : reading(option, words, remedy, [&] { return read_grid(words); })) {
        std::optional<sweep_energy> texts;  // of a formula, the requested digits
        if (number.is_fraction() || !number.is_number()) {
            texts =
                reading(option, words, remedy, [&] { return by_gap ? energy_from_gap(number) : energy_from(number); });
        }
        for (const auto& angle : angles) {
            typed_motion typed = usual;
            (by_gap ? typed.gap : typed.energy) = number;
            typed.theta0 = angle;
            const auto of = [&] { return typed.motion(); };
            motions.push_back({typed,
                               angle ? reading("--theta0", *angle_words,
                                               "choose angles with 1 - cos(angle) <= E for every energy", of)
                                     : reading(option, words, remedy, of),
                               texts});
        }
    }
}

void add_by_state(std::vector<grid_motion>& motions, const option_words& said, const typed_motion& usual) {
    const std::string& speed_words = *said["--omega0"];
    const auto speeds = reading("--omega0", speed_words, speeds_remedy, [&] { return read_grid(speed_words); });
    for (const exact& angle : angles_of(*said["--theta0"])) {
        for (const exact& speed : speeds) {
            typed_motion typed = usual;
            typed.theta0 = angle;
            typed.omega0 = speed;
            motions.push_back(
                {typed, reading("--omega0", speed_words, speeds_remedy, [&] { return typed.motion(); }), std::nullopt});
        }
    }
}

}  // namespace

void offer_motions(option_words& said, CLI::App& command) {
    said.offer(command,
               {{"--energies,--energy", "LIST", "energies E: LIST, a:b:count or a:b:COUNTlog"},
                {"--gaps,--gap", "LIST", "energies as gaps 2 - E, exact next to the separatrix: the same forms"},
                {"--theta0", "LIST", "angles at t = 0: 30deg,60deg or 10deg:170deg:17"},
                {"--omega0", "LIST", "angular velocities at t = 0 (with --theta0)"},
                {"--direction", "+|-", "sign of omega at t = 0 for motions given by energy"},
                {"--length", "L", "length in metres: times are then seconds"},
                {"--gravity", "G", "gravity in m/s^2 (with --length)"},
                {"--times,--time", "LIST", "times: 0,1.5,T/4 or a range 0:T:9"}});
}

std::vector<grid_motion> motions_of(const option_words& said) {
    const typed_motion usual = numbers_of_options({.direction = said["--direction"].value_or(""),
                                                   .length = said["--length"].value_or(""),
                                                   .gravity = said["--gravity"].value_or("")});
    std::vector<grid_motion> motions;
    if (said["--omega0"]) {
        add_by_state(motions, said, usual);
    }
    for (const std::string option : {"--energies", "--gaps"}) {
        if (said[option]) {
            add_by_energy(motions, said, option, usual);
        }
    }
    return motions;
}

std::vector<exact> times_for(const std::vector<grid_motion>& motions, const option_words& said) {
    const auto& words = said["--times"];
    auto times = times_of(*words, regime::libration);
    for (const grid_motion& each : motions) {
        if (at_critical_energy(each.of.regime())) {
            times = times_of(*words, each.of.regime());
        }
    }
    if (times.size() * motions.size() > static_cast<std::size_t>(most_grid_values)) {
        throw input_error("--times", *words, fmt::format("makes more than {} rows", most_grid_values),
                          "choose fewer times or motions");
    }
    return times;
}

}  // namespace libration
