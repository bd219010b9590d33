#include <algorithm>
#include <array>
#include <memory>

#include "answers.hpp"
#include "guarded.hpp"
#include "libration/number/given_number.hpp"
#include "libration/problem/known/pendulum_solution.hpp"

namespace libration::c {

namespace {

using pendulum::given_motion;

given_motion read_motion(const std::string& text) {
    static const std::array<std::pair<const char*, std::string given_motion::*>, 7> fields{
        {{"theta0", &given_motion::theta0},
         {"omega0", &given_motion::omega0},
         {"energy", &given_motion::energy},
         {"gap", &given_motion::gap},
         {"direction", &given_motion::direction},
         {"length", &given_motion::length},
         {"gravity", &given_motion::gravity}}};
    given_motion read;
    for (const auto& setting : settings_of(text, "motion")) {
        const std::string& name = setting.first;
        const std::string& value = setting.second;
        const auto* const field =
            std::find_if(fields.begin(), fields.end(), [&](const auto& each) { return each.first == name; });
        if (field == fields.end()) {
            throw error(error_kind::argument, "motion", name,
                        "is not one of theta0, omega0, energy, gap, direction, length and gravity");
        }
        if (value.empty() || !(read.*field->second).empty()) {
            throw error(error_kind::argument, "motion", name, value.empty() ? "has no value" : "has two values");
        }
        read.*field->second = value;
    }
    return read;
}

// A separate solution for each call: one in which memory ran out is not used again.
std::unique_ptr<solution> solution_of(const libration_motion* m) {
    return libration::solution_of(given(m, "motion").of);
}

libration_number number_of(const answer_value& value, int rigour) {
    return asks_proof(rigour) ? proved_number({value.text, value.bound}) : rounded_number(value.text);
}

// The default point of a motion is the top.
std::string point_of(const libration_motion& m, const char* point) {
    return is_given(point) ? point : at_critical_energy(m.of.regime()) ? "bottom" : "top";
}

int write_state(const libration_motion* motion, std::size_t quantity, const char* time, long digits, int rigour,
                libration_number** value) {
    return made(value, [&] {
        const answer found =
            solution_of(motion)->states({given_time("time", text_of(time, "time"))}, digits_by(digits, rigour));
        if (found.missing) {
            throw error(*found.missing);
        }
        return number_of(found.rows[0][quantity], rigour);
    });
}

int write_constant(const libration_motion* motion, const char* name, long digits, int rigour, libration_number** value,
                   const char* point = nullptr) {
    return made(value, [&] {
        const answer found = *solution_of(motion)->constants(digits_by(digits, rigour),
                                                             {.names = {name}, .about = is_given(point) ? point : ""});
        return number_of(found.rows[0][0], rigour);
    });
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_motion_new(const char* given, libration_motion** motion) {
    return made(motion, [&] {
        const pendulum::given_motion read = read_motion(text_of(given, "motion"));
        return libration_motion{read, exact_motion(read)};
    });
}

const char* libration_motion_regime(const libration_motion* motion) {
    return motion == nullptr ? "" : name_of(motion->of.regime()).data();
}

int libration_motion_theta(const libration_motion* motion, const char* time, long digits, int rigour,
                           libration_number** theta) {
    return write_state(motion, 0, time, digits, rigour, theta);
}

int libration_motion_omega(const libration_motion* motion, const char* time, long digits, int rigour,
                           libration_number** omega) {
    return write_state(motion, 1, time, digits, rigour, omega);
}

int libration_motion_states(const libration_motion* motion, const char* times, long digits, int rigour,
                            libration_watch watch, void* context, libration_table** states) {
    return made(states, [&] {
        return states_of(*solution_of(motion), text_of(times, "times"), digits_by(digits, rigour),
                         watcher(watch, context))
            .complete();
    });
}

int libration_motion_period(const libration_motion* motion, long digits, int rigour, libration_number** period) {
    return write_constant(motion, "period", digits, rigour, period);
}

int libration_motion_effective_period(const libration_motion* motion, long digits, int rigour,
                                      libration_number** period) {
    return write_constant(motion, "tstar", digits, rigour, period);
}

int libration_motion_energy(const libration_motion* motion, long digits, int rigour, libration_number** energy) {
    return write_constant(motion, "energy", digits, rigour, energy);
}

int libration_motion_gap(const libration_motion* motion, long digits, int rigour, libration_number** gap) {
    return write_constant(motion, "gap", digits, rigour, gap);
}

int libration_motion_radius(const libration_motion* motion, const char* point, long digits, int rigour,
                            libration_number** radius) {
    return write_constant(motion, "radius", digits, rigour, radius, point);
}

int libration_motion_coefficients(const libration_motion* motion, const char* point, long first, long last, long digits,
                                  int rigour, libration_table** coefficients) {
    return made(coefficients, [&] {
        require_powers(first, last);
        if (last > largest_power_of_series) {
            throw error(error_kind::argument, "power", std::to_string(last),
                        "is not between 0 and " + std::to_string(largest_power_of_series));
        }
        const auto of = solution_of(motion);
        libration_table table = table_of_numbers(
            of->series({.first = first, .order = last, .about = point_of(*motion, point)}, digits_by(digits, rigour)));
        table.names.back() = "coefficient";
        return table;
    });
}

void libration_motion_free(libration_motion* motion) { delete motion; }

int libration_sampler_new(const libration_motion* motion, libration_sampler** sampler) {
    return made(sampler, [&] { return libration_sampler{solution_of(motion)->sampler()}; });
}

int libration_sampler_at(const libration_sampler* sampler, size_t count, const double* times, double* theta,
                         double* omega) {
    const auto sample = [&] {
        given(sampler, "sampler");
        if (count > 0) {
            given(theta, "theta");
            given(omega, "omega");
            sampler->of->at({&given(times, "times"), count}, std::array{theta, omega});
        }
    };
    // A round trip to another thread would cost a hundred times as much as one time.
    const bool in_double = sampler == nullptr || times == nullptr || sampler->of->reaches({times, count});
    return in_double ? guarded_here(sample) : guarded(sample);
}

void libration_sampler_free(libration_sampler* sampler) { delete sampler; }
