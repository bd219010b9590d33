#include "motion_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "libration/pendulum/condition.hpp"
#include "libration/pendulum/energy.hpp"
#include "options.hpp"
#include "proved_states.hpp"
#include "sweep/grid.hpp"
#include "sweep/input_error.hpp"
#include "sweep/parallel.hpp"
#include "sweep/proofs.hpp"
#include "sweep/study.hpp"

namespace libration {

namespace {

constexpr const char* energies_remedy = "write energies such as 0.5,1.71,2.02 or 0.1:1.9:19";
constexpr const char* gaps_remedy = "write gaps 2 - E such as 1e-3,-1e-3 or 1e-1:1e-12:12log";
constexpr const char* angles_remedy = "write angles such as 60deg,pi/2,2.5 or 10deg:170deg:17";
constexpr const char* speeds_remedy = "write angular velocities such as 0,-0.3,1/2";
constexpr std::size_t times_a_step = 32;

using rows = std::vector<std::vector<std::string>>;

// A motion of the grid; the texts of energy and gap where they were typed.
struct grid_motion {
    typed_motion typed;
    motion of;
    std::optional<sweep_energy> texts;
};

std::vector<exact> angles_of(const std::string& words) {
    auto angles = reading("--theta0", words, angles_remedy, [&] { return read_grid(words); });
    for (const exact& angle : angles) {
        if (angle.measure == unit::period) {
            throw input_error("--theta0", words, "has the time '" + angle.text + "'", angles_remedy);
        }
    }
    return angles;
}

// The motions of one list of energies or gaps, from every angle where there are some.
void add_by_energy(std::vector<grid_motion>& motions, const said_words& said, const std::string& option,
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
        const sweep_energy texts =
            reading(option, words, remedy, [&] { return by_gap ? energy_from_gap(number) : energy_from(number); });
        for (const auto& angle : angles) {
            typed_motion typed = usual;
            (by_gap ? typed.gap : typed.energy) = number;
            typed.theta0 = angle;
            const auto of = [&] { return typed.motion(); };
            motions.push_back({typed,
                               angle ? reading("--theta0", *angle_words,
                                               "choose angles with 1 - cos(angle) <= E for every energy", of)
                                     : of(),
                               texts});
        }
    }
}

void add_by_state(std::vector<grid_motion>& motions, const said_words& said, const typed_motion& usual) {
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

void require_one_kind(const said_words& said) {
    const bool energetic = said["--energies"] || said["--gaps"];
    const auto& omega0 = said["--omega0"];
    if (energetic && omega0) {
        throw input_error("--omega0", *omega0, "comes together with --energies or --gaps",
                          "give energies, or --theta0 and --omega0, not both");
    }
    if (!energetic && !omega0) {
        throw input_error(
            "no motions are given: add --energies LIST, --gaps LIST, or --theta0 LIST with --omega0 LIST");
    }
    if (omega0 && !said["--theta0"]) {
        throw input_error("--omega0", *omega0, "is not yet a motion", "add --theta0 LIST");
    }
    if (omega0 && said["--direction"]) {
        throw input_error("--direction", *said["--direction"], "goes with --energies or --gaps",
                          "give the sign of the motion to --omega0");
    }
}

std::vector<grid_motion> motions_of(const said_words& said) {
    require_one_kind(said);
    typed_motion usual;
    usual.direction = direction_of(said["--direction"]);
    usual.stiffness = stiffness_of(said["--length"], said["--gravity"]);
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

// The times, refused where a motion among these has no period that they are multiples of.
std::vector<exact> times_for(const std::vector<grid_motion>& motions, const said_words& said) {
    const auto& words = said["--times"];
    if (!words) {
        throw input_error("no times are given: add --times LIST");
    }
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

// The condition numbers of one motion, as verify prints them.
class condition_texts {
public:
    explicit condition_texts(const grid_motion& of) : of_(of) {}

    std::string at(const exact& time) {
        const long bits = conditioned_motion::bits_for(of_.of, exponent_of(time));
        const long start = (decimal_digits(bits) + 9) / 10 * 10;
        constexpr int attempts = 5;
        for (long digits = start; digits <= attempts * start; digits += start) {
            const precision_scope scope(digits);
            try {
                const auto& here = made_.try_emplace(digits, of_.typed, of_.of).first->second;
                const auto condition = here.at(time, here.of().at(time));
                return condition ? to_decimal(*condition, 3) : "inf";
            } catch (const precision_exhausted&) {
                continue;
            }
        }
        throw std::runtime_error(
            fmt::format("the condition at time {} is not decided by {} digits", time.text, attempts * start));
    }

private:
    // An e with |t| max(1, |omega|) < 2^e: the phase that a relative step of an input is multiplied with. A multiple
    // of a period is one of ordinary size in this, however fast the motion.
    long exponent_of(const exact& time) const {
        if (time.is_zero()) {
            return 0;
        }
        const precision_scope scope(20);
        if (time.measure == unit::period) {
            return binary_exponent(from_rational<mpfr>(time.coefficient)) + 3;
        }
        const mpfr elapsed = from_exact<mpfr>(time) / time_unit<mpfr>(of_.of);
        const long of_energy = binary_exponent(energies<mpfr>(of_.of).energy);
        return binary_exponent(elapsed) + std::max(0L, of_energy / 2 + 2);
    }

    const grid_motion& of_;
    std::map<long, conditioned_motion> made_;
};

std::vector<column> columns_of(const said_words& said, input_style style) {
    const bool seconds = said["--length"].has_value();
    const std::string of_time = seconds ? "s" : "sqrt(l/g)";
    const std::string speed = seconds ? "rad/s" : "sqrt(g/l)";
    std::vector<column> columns{{"energy", "in m g l"}, {"gap", "2 - energy"}};
    if (said["--theta0"]) {
        columns.push_back({"theta0", style == input_style::typed ? "angle at time 0, as typed" : "rad, at time 0"});
    }
    if (said["--omega0"]) {
        columns.push_back({"omega0", speed + ", at time 0"});
    }
    if (said["--direction"]) {
        columns.push_back({"direction", "sign of omega at time 0 where omega is not 0"});
    }
    columns.insert(columns.end(), {{"time", of_time},
                                   {"theta", "rad"},
                                   {"omega", speed},
                                   {"period", of_time},
                                   {"tstar", of_time + ", from the top to the bottom"},
                                   {"radius", of_time + ", of convergence about the top; about the bottom at energy 2"},
                                   {"condition",
                                    "(|t omega| + sum |x dtheta/dx|)/max(1, |theta|) over the typed numbers "
                                    "x, heuristic, three digits"}});
    if (style == input_style::typed) {
        columns.insert(columns.end(), {{"digits", "significant digits"}, {"rigour", "of all but the condition"}});
    }
    return columns;
}

// What the rows of one motion share: the cells before the time, and those behind omega.
class motion_rows {
public:
    motion_rows(const grid_motion& of, const said_words& said, long digits, input_style style)
        : of_(of), said_(said), digits_(digits), style_(style), states_(of.of, digits), conditions_(of) {}

    rows at(const exact* begin, const exact* end) {
        const auto front = front_cells();
        const auto [period, tstar, radius] = states_.constants();
        rows result;
        result.reserve(static_cast<std::size_t>(end - begin));
        for (const exact* time = begin; time != end; ++time) {
            const auto state = state_at(states_, *time, *said_["--times"]);
            std::vector<std::string> row = front;
            row.insert(row.end(),
                       {time_cell(*time), state.theta, state.omega, period, tstar, radius, conditions_.at(*time)});
            if (style_ == input_style::typed) {
                row.insert(row.end(), {std::to_string(digits_), "proved"});
            }
            result.push_back(std::move(row));
        }
        return result;
    }

private:
    std::vector<std::string> front_cells() {
        std::vector<std::string> cells = energy_cells();
        for (const auto& number : {of_.typed.theta0, of_.typed.omega0}) {
            if (number) {
                cells.push_back(style_ == input_style::typed ? number->text
                                                             : decimal_text(*number, digits_ + more_input_digits));
            }
        }
        if (const auto& direction = said_["--direction"]) {
            cells.push_back(style_ == input_style::typed ? *direction : *direction + "1");
            cells.back().erase(0, cells.back() == "+1" ? 1 : 0);
        }
        return cells;
    }

    std::vector<std::string> energy_cells() {
        if (of_.texts && style_ == input_style::typed) {
            return {of_.texts->energy, of_.texts->gap};
        }
        const auto& energy = of_.of.energy();
        if (!energy) {
            return states_.energies();
        }
        const long more = digits_ + more_input_digits;
        return {decimal_text(exactly(*energy), more), decimal_text(exactly(rational(2 - *energy)), more)};
    }

    std::string time_cell(const exact& time) {
        if (style_ == input_style::typed) {
            return time.text;
        }
        const long more = digits_ + more_input_digits;
        return time.measure == unit::period && !time.is_zero() ? states_.time_text(time, more)
                                                               : decimal_text(time, more);
    }

    const grid_motion& of_;
    const said_words& said_;
    long digits_;
    input_style style_;
    proved_states states_;
    condition_texts conditions_;
};

}  // namespace

std::string decimal_text(const exact& number, long digits) {
    if (number.measure == unit::one || number.is_zero()) {
        if (const auto finite = to_finite_decimal(number.coefficient)) {
            return *finite;
        }
    }
    return proved_decimals(digits, [&] { return std::vector<ball>{from_exact<ball>(number)}; }).front().text;
}

void offer_motions(said_words& said, CLI::App& command) {
    const auto offer = [&](const char* names, const char* type_name, const char* help) {
        said.offer(command, names, type_name, help);
    };
    offer("--energies,--energy", "LIST", "energies E: LIST, a:b:count or a:b:COUNTlog");
    offer("--gaps,--gap", "LIST", "energies as gaps 2 - E, exact next to the separatrix: the same forms");
    offer("--theta0", "LIST", "angles at t = 0: 30deg,60deg or 10deg:170deg:17");
    offer("--omega0", "LIST", "angular velocities at t = 0 (with --theta0)");
    offer("--direction", "+|-", "sign of omega at t = 0 for motions given by energy");
    offer("--length", "L", "length in metres: times are then seconds");
    offer("--gravity", "G", "gravity in m/s^2 (with --length)");
    offer("--times,--time", "LIST", "times: 0,1.5,T/4 or a range 0:T:9");
}

table motion_table(const said_words& said, long digits, input_style style, int jobs) {
    const auto motions = motions_of(said);
    const auto times = times_for(motions, said);
    const std::size_t blocks = (times.size() + times_a_step - 1) / times_a_step;
    progress shown("table", motions.size() * blocks);
    const auto parts = parallel_map(motions.size() * blocks, jobs, shown, [&](std::size_t i) {
        const std::size_t begin = i % blocks * times_a_step;
        const std::size_t end = std::min(begin + times_a_step, times.size());
        motion_rows of_motion(motions[i / blocks], said, digits, style);
        return of_motion.at(times.data() + begin, times.data() + end);
    });
    table data{columns_of(said, style), {}};
    data.rows.reserve(motions.size() * times.size());
    for (const rows& part : parts) {
        data.rows.insert(data.rows.end(), part.begin(), part.end());
    }
    return data;
}

}  // namespace libration
