#include "libration/query/limit.hpp"

#include <algorithm>
#include <string>

#include "../equation/bound_text.hpp"
#include "../expansion/set_values.hpp"
#include "../integration/closed_form/constant_solution.hpp"
#include "../manifold/algebraic_decay.hpp"
#include "../manifold/stable_equilibrium.hpp"
#include "libration/digits/precision_loop.hpp"
#include "libration/equation/dependency.hpp"

namespace libration::ode {

namespace {

// Powers of 2 that are tried as times, and the number of steps after which no further one is.
constexpr int last_power_of_time = 64;
constexpr long most_steps_to_limit = 20'000;
constexpr long first_bits_of_states = 128;
// Solutions that approach an equilibrium do not lose bits for long.
constexpr long most_bits_of_states = 256;

error no_limit(const std::string& what) { return {error_kind::undecided, error_subject::time, "inf", what}; }

// Throws error unless the proof ended for lack of precision.
void require_precision_alone(const proved_march& march) {
    if (march.end() != stop::precision) {
        throw no_limit("is not reached: the solution is proved to exist up to " +
                       proved_reach_text(march.reached(), true) + ", and no further step is proved");
    }
}

class limit_search {
public:
    limit_search(const explicit_system& of, long digits, const march_watch& watch, const proof_route& route)
        : system_(of), digits_(digits), watch_(watch), route_(route), field_(of) {
        if (field_.depends_on_time()) {
            throw no_limit("is not supported for right-hand sides that contain the variable");
        }
    }

    std::vector<known_value> values() {
        auto found = with_doubled_bits(first_bits_of_states, most_bits_of_states,
                                       [this](long bits) { return along_the_solution(bits); });
        if (!found) {
            throw no_limit(not_approached(std::to_string(most_bits_of_states) + " bits are too few beyond it"));
        }
        return *std::move(found);
    }

private:
    // std::nullopt if more bits are needed.
    std::optional<std::vector<known_value>> along_the_solution(long bits) {
        decay_ = {};
        proved_march march(system_, bits, watch_, proved_march::usual_error_bits, route_);
        rational distance = 1;
        for (int k = 0; k <= last_power_of_time; ++k, distance *= 2) {
            if (march.steps() > most_steps_to_limit) {
                throw no_limit(
                    not_approached("more than " + std::to_string(most_steps_to_limit) + " steps were needed"));
            }
            const auto state = march.at(system_.point() + number(distance));
            if (!state) {
                require_precision_alone(march);
                return std::nullopt;
            }
            reached_ = proved_reach_text(march.reached(), true);
            if (auto found = limit_from(*state)) {
                return found;
            }
            decay_.add(*state);
        }
        throw no_limit(not_approached("later times were not tried"));
    }

    std::optional<std::vector<known_value>> limit_from(const std::vector<ball>& state) const {
        std::vector<known_value> best;
        prove_digits(digits_, error_subject::time, [&](const run_bits& run, run_demand& demand) {
            const precision_scope scope(decimal_digits(run.bits));
            const auto kept = field_.kept_of(state);
            const auto zero = enclosed_zero(field_, kept);
            if (zero && is_approached(field_, *zero, kept)) {
                demand.improve(best, state_at_zero(field_, *zero), "inf", names_of_state(system_));
                demand.cost(most_steps_to_limit);
            }
        });
        return best.empty() ? std::nullopt : std::optional(best);
    }

    std::string not_approached(const std::string& reason) const {
        return "is not reached: no stable equilibrium is proved to be approached from the state at " + reached_ +
               ", and " + reason + decay_.text();
    }

    const explicit_system& system_;
    long digits_;
    const march_watch& watch_;
    const proof_route& route_;
    reduced_field field_;
    std::string reached_ = "the initial point";
    algebraic_decay decay_;
};

// Of a constant solution.
std::vector<known_value> values_at_start(const explicit_system& system, long digits) {
    std::vector<known_value> values;
    for (const ball& each : enclosed_start(system, bits_of_first_run(digits))) {
        improve(values.emplace_back(), each, digits);
    }
    return values;
}

}  // namespace

partial_trajectory limit_at_equilibrium(const explicit_system& system, long digits, const march_watch& watch,
                                        const proof_route& route) {
    if (system.singular()) {
        throw no_limit("is not supported for a singular initial point, except by the lemmas of the catalogue");
    }
    partial_trajectory whole{.states = {{}}, .missing = {}};
    auto& state = whole.states.front();
    for (const closed_subsystem& each : independent_subsystems(system)) {
        const auto part = constancy_of(each.system) == constancy::everywhere
                              ? values_at_start(each.system, digits)
                              : limit_search(each.system, digits, watch, route).values();
        state.resize(each.leaves_of_whole);
        for (std::size_t k = 0; k < part.size(); ++k) {
            state[each.leaves[k]] = part[k];
        }
    }
    const auto zero = std::ranges::find_if(state, [](const known_value& each) { return !each.decimal; });
    if (zero != state.end()) {
        const std::string name = names_of_state(system)[static_cast<std::size_t>(zero - state.begin())];
        whole.missing =
            no_limit("has a value of " + name + " that is not distinguished from 0: |" + name + "| < " + zero->bound);
    }
    return whole;
}

}  // namespace libration::ode
