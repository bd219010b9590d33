#include "amplitude_connection.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "connection_orbit.hpp"
#include "enclosed_decimal.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/constant_value.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/functions.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "marched_states.hpp"
#include "orbit_symmetry.hpp"

namespace libration::ode {

namespace {

constexpr double parts_of_joining_time = 64;
constexpr long most_times_the_bits = 4;
constexpr double least_theta = 1e-3;
constexpr long digits_of_values = 10;

bool gives_amplitude(const limit_condition& each) { return each.amplitude.has_value(); }

class amplitude_search {
public:
    amplitude_search(const connection_question& question, const proof_route& route, const march_watch& watch)
        : question_(question),
          limit_(*std::ranges::find_if(question.limits, gives_amplitude)),
          watch_(watch),
          map_(with_idle_starts(question.system), question.unknowns, question.limits, route, watch),
          amplitude_(parameter_values(question.system).number_of(*limit_.amplitude)) {
        if (map_.has_two_ends() || std::ranges::count_if(question.limits, gives_amplitude) > 1) {
            refuse_limit("is one of several amplitudes, or has limits at both ends: give one amplitude, at one end");
        }
        if (amplitude_.sign() == 0) {
            refuse_limit("has the amplitude 0: give another");
        }
        if (map_.coordinates() > 0 || !map_.choose(std::vector<double>(map_.numbers(), 1), 1)) {
            throw error(
                error_kind::undecided, error_subject::condition, limit_.text,
                "has an amplitude at an equilibrium without an invariant manifold that is proved: leave it out");
        }
        const manifold_end& end = map_.right();
        if (end.variables() != 1) {
            refuse_limit("has an amplitude, and " + std::to_string(end.variables()) +
                         " directions of exponential decay lead there instead of one: leave it out, and give the "
                         "initial values that are known");
        }
        const std::string name = primed(limit_.of.name(), limit_.of.derivative());
        for (const std::size_t k : end.moving()) {
            row_ = map_.form().names[k] == name ? names_.size() : row_;
            names_.push_back(name_of_start(map_.form().given[k], map_.open().system.point()));
        }
        if (!std::ranges::is_permutation(names_, question.unknowns)) {
            std::string all;
            for (const std::string& each : names_) {
                all += (all.empty() ? "" : ",") + each;
            }
            throw error(error_kind::argument, error_subject::unknowns, "",
                        "are not the initial values, which the amplitude determines: give --unknown \"" + all + "\"");
        }
    }

    connection result() {
        std::vector<known_value> kept(names_.size());
        const auto missing = prove_digits(
            question_.digits + digits_of_values, error_subject::solution, [&](const run_bits& run, run_demand& demand) {
                const precision_scope scope(decimal_digits(run.bits));
                if (const auto state = state_at_start(run.bits)) {
                    demand.improve(kept, *state, "", names_);
                } else {
                    demand.undecided(
                        "", "is not proved to exist from the end back to the initial point: choose another amplitude",
                        most_times_the_bits * bits_of_first_run(question_.digits));
                }
            });
        if (missing && !all_have_digits(kept)) {
            throw error(*missing);
        }
        return described(kept);
    }

private:
    [[noreturn]] void refuse_limit(const std::string& reason) const {
        throw error(error_kind::argument, error_subject::condition, limit_.text, reason);
    }

    // At the time T after the initial point theta is small enough for the series.
    std::optional<std::vector<ball>> state_at_start(long bits) {
        const std::vector<ball> numbers(map_.numbers(), ball(1));  // the field does not depend on initial values
        const auto decay = map_.right().decay_at(numbers);
        if (!decay || !decay->alone.front()) {
            return std::nullopt;
        }
        const ball rate = -decay->rates.front().re;
        const ball entry = decay->columns[row_].front().re;
        if (contains_zero(entry)) {
            return std::nullopt;
        }
        const int direction = map_.direction();
        const ball point = constant_value<ball>::of(map_.open().system.point());
        const ball at_start = constant_value<ball>::of(amplitude_) / entry * exp(-rate * point * direction);
        const double beyond = std::log(std::fabs(as_double(at_start)) / map_.right().good_radius()) / as_double(rate);
        map_.time = std::ceil(std::max(0., beyond) * parts_of_joining_time) / parts_of_joining_time;
        theta_ = at_start * exp(-rate * exactly(map_.time));
        map_.radius = std::max(least_theta, std::fabs(as_double(theta_)));
        const auto end = map_.right().along(numbers, {theta_}, {ball(0)}, map_.degree_for(bits));
        if (!end) {
            return std::nullopt;
        }
        const auto& moving = map_.right().moving();
        std::vector<ball> state(map_.form().leaves.size(), ball(0));
        for (std::size_t i = 0; i < moving.size(); ++i) {
            state[moving[i]] = end->front()[i];
        }
        if (map_.time > 0) {
            const auto before = marched_states(map_.open().system, state, {point - exactly(map_.time) * direction},
                                               bits, map_.route(), watch_);
            if (!before) {
                return std::nullopt;
            }
            state = before->front();
        }
        std::vector<ball> result;
        result.reserve(moving.size());
        for (const std::size_t k : moving) {
            result.push_back(state[k]);
        }
        return result;
    }

    connection described(const std::vector<known_value>& kept) const {
        const precision_scope scope(question_.digits + 2 * digits_of_values);
        connection result;
        std::vector<ball> x;
        for (const std::string& name : question_.unknowns) {
            const auto& value = kept[static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin())];
            if (!value.decimal) {
                throw error(error_kind::undecided, error_subject::solution, "",
                            "has " + name + " between -" + value.bound + " and " + value.bound +
                                ", which is not distinguished from 0");
            }
            x.push_back(enclosed(*value.decimal));
            result.values.push_back(*to_proved_decimal(
                x.back(), std::max(1L, std::min(question_.digits, proved_digits(x.back(), question_.digits)))));
        }
        x.push_back(theta_);
        result.orbit = std::make_shared<connection_orbit>(map_, question_.unknowns, question_.limits, x);
        result.time = as_double(result.orbit->joining_time());
        result.proved = "one solution on the 1-dimensional stable manifold has " + limit_.text +
                        ", and tends to the limits exponentially";
        result.not_claimed = "that solutions that tend to the limits in another way are excluded";
        return result;
    }

    const connection_question& question_;
    const limit_condition& limit_;
    march_watch watch_;
    connection_map map_;
    number amplitude_;
    std::vector<std::string> names_;
    std::size_t row_ = 0;  // of the unknown with the amplitude, in moving()
    ball theta_;           // at the time of the map
};

}  // namespace

bool has_amplitude(const connection_question& question) {
    return std::ranges::any_of(question.limits, gives_amplitude);
}

connection proved_by_amplitude(const connection_question& question, const proof_route& route,
                               const march_watch& watch) {
    return amplitude_search(question, route, watch).result();
}

}  // namespace libration::ode
