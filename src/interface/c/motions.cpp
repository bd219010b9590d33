#include <array>
#include <memory>

#include "guarded.hpp"
#include "libration/digits/proved/printed_values.hpp"
#include "libration/pendulum/digits.hpp"
#include "libration/pendulum/given_question.hpp"
#include "libration/pendulum/proved/digits.hpp"
#include "libration/pendulum/proved/proved_states.hpp"
#include "libration/pendulum/solution/exact_solution.hpp"
#include "libration/pendulum/taylor/point_coefficients.hpp"
#include "libration/scalar/exponent_range.hpp"
#include "libration/scalar/text/given_number.hpp"

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

libration_motion make_motion(const std::string& text) {
    const given_motion read = read_motion(text);
    const pendulum::typed_motion typed = exact_numbers(read);
    return {read, typed, typed.motion()};
}

// f(given motion) of the rounded or of the proved half.
template <class Rounded, class Proved>
libration_number number_by(int rigour, const Rounded& rounded, const Proved& proved) {
    return asks_proof(rigour) ? proved_number(proved()) : rounded_number(rounded());
}

libration_table states_of(const libration_motion& m, const std::string& times, long digits, bool proved,
                          const watcher& watch) {
    libration_table table{{"time", "theta", "omega"}, {}};
    const auto items = items_of(times, "times");
    pendulum::proved_states states(m.of, given_digits(digits));
    for (std::size_t i = 0; i < items.size(); ++i) {
        watch(i, items.size());
        table.add(items[i]);
        if (proved) {
            const exact time = exact_time(m.of, items[i]);
            table.add(proved_number(states.theta_at(time)));
            table.add(proved_number(states.omega_at(time)));
        } else {
            table.add(rounded_number(rounded::theta(m.given, items[i], digits)));
            table.add(rounded_number(rounded::omega(m.given, items[i], digits)));
        }
    }
    return table;
}

// NULL is the default point of a motion.
std::string point_of(const char* point) { return point == nullptr ? "" : point; }

libration_table coefficients_of(const libration_motion& m, const std::string& point, long first, long last, long digits,
                                bool proved) {
    require_powers(first, last);
    const whole_exponent_range exponents;  // of a_n ~ R^-n
    const pendulum::expansion_point at = pendulum::exact_point(m.of, point, last);
    const scalar_spec scalar{proved ? scalar_kind::proved : scalar_kind::arbitrary, given_digits(digits)};
    const auto values = printed(
        scalar, digits,
        [&]<class T>() {
            const precision_scope wider(working_digits() + (rounding_scalar<T> ? 20 : 0));
            return pendulum::point_coefficients<T>(m.of, at, first, last);
        },
        [&] { return pendulum::vanishing_at(m.of, at, first, last); });
    libration_table table{{"n", "coefficient"}, {}};
    for (const printed_number& each : values) {
        table.add(count_number(first++));
        table.add(proved ? proved_number(each) : rounded_number(each.text));
    }
    return table;
}

}  // namespace

}  // namespace libration::c

using namespace libration;
using namespace libration::c;

int libration_motion_new(const char* given, libration_motion** motion) {
    return made(motion, [&] { return make_motion(text_of(given, "motion")); });
}

const char* libration_motion_regime(const libration_motion* motion) {
    return motion == nullptr ? "" : name_of(motion->of.regime()).data();
}

int libration_motion_theta(const libration_motion* motion, const char* time, long digits, int rigour,
                           libration_number** theta) {
    return made(theta, [&] {
        const auto& m = given(motion, "motion").given;
        const std::string at = text_of(time, "time");
        return number_by(
            rigour, [&] { return rounded::theta(m, at, digits); }, [&] { return proved::theta(m, at, digits); });
    });
}

int libration_motion_omega(const libration_motion* motion, const char* time, long digits, int rigour,
                           libration_number** omega) {
    return made(omega, [&] {
        const auto& m = given(motion, "motion").given;
        const std::string at = text_of(time, "time");
        return number_by(
            rigour, [&] { return rounded::omega(m, at, digits); }, [&] { return proved::omega(m, at, digits); });
    });
}

int libration_motion_states(const libration_motion* motion, const char* times, long digits, int rigour,
                            libration_watch watch, void* context, libration_table** states) {
    return made(states, [&] {
        return states_of(given(motion, "motion"), text_of(times, "times"), digits, asks_proof(rigour),
                         watcher(watch, context));
    });
}

int libration_motion_period(const libration_motion* motion, long digits, int rigour, libration_number** period) {
    return made(period, [&] {
        const auto& m = given(motion, "motion").given;
        return number_by(
            rigour, [&] { return rounded::period(m, digits); }, [&] { return proved::period(m, digits); });
    });
}

int libration_motion_effective_period(const libration_motion* motion, long digits, int rigour,
                                      libration_number** period) {
    return made(period, [&] {
        const auto& m = given(motion, "motion").given;
        return number_by(
            rigour, [&] { return rounded::effective_period(m, digits); },
            [&] { return proved::effective_period(m, digits); });
    });
}

int libration_motion_energy(const libration_motion* motion, long digits, int rigour, libration_number** energy) {
    return made(energy, [&] {
        const auto& m = given(motion, "motion").given;
        return number_by(
            rigour, [&] { return rounded::energy(m, digits); }, [&] { return proved::energy(m, digits); });
    });
}

int libration_motion_gap(const libration_motion* motion, long digits, int rigour, libration_number** gap) {
    return made(gap, [&] {
        const auto& m = given(motion, "motion").given;
        return number_by(
            rigour, [&] { return rounded::gap(m, digits); }, [&] { return proved::gap(m, digits); });
    });
}

int libration_motion_radius(const libration_motion* motion, const char* point, long digits, int rigour,
                            libration_number** radius) {
    return made(radius, [&] {
        const auto& m = given(motion, "motion").given;
        const std::string at = point_of(point);
        return number_by(
            rigour, [&] { return rounded::radius(m, at, digits); }, [&] { return proved::radius(m, at, digits); });
    });
}

int libration_motion_coefficients(const libration_motion* motion, const char* point, long first, long last, long digits,
                                  int rigour, libration_table** coefficients) {
    return made(coefficients, [&] {
        return coefficients_of(given(motion, "motion"), point_of(point), first, last, digits, asks_proof(rigour));
    });
}

void libration_motion_free(libration_motion* motion) { delete motion; }

int libration_sampler_new(const libration_motion* motion, libration_sampler** sampler) {
    return made(sampler, [&] { return libration_sampler{pendulum::sampler<double>(given(motion, "motion").of)}; });
}

int libration_sampler_at(const libration_sampler* sampler, size_t count, const double* times, double* theta,
                         double* omega) {
    const auto sample = [&] {
        given(sampler, "sampler");
        if (count > 0) {
            given(theta, "theta");
            given(omega, "omega");
            sampler->of({&given(times, "times"), count}, {theta, count}, {omega, count});
        }
    };
    // A round trip to another thread would cost a hundred times as much as one time.
    const bool in_double = sampler == nullptr || times == nullptr || sampler->of.reaches({times, count});
    return in_double ? guarded_here(sample) : guarded(sample);
}

void libration_sampler_free(libration_sampler* sampler) { delete sampler; }
