#include "libration/query/shooting/periodic_orbit.hpp"

#include <algorithm>
#include <utility>

#include "../../equation/bound_text.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "orbit_choice.hpp"
#include "orbit_proof.hpp"
#include "shooting.hpp"

namespace libration::ode {

namespace {

constexpr long first_bits = 128;
constexpr int most_returns = 12;

std::vector<ball> start_of(const first_order_form& form) {
    std::vector<ball> start;
    for (const number& each : form.starts) {
        start.push_back(constant_value<ball>::of(each));
    }
    return start;
}

std::size_t fastest(const first_order_form& form) {
    const auto start = start_of(form);
    const auto slope = form.slopes_at(start, ball(0));
    std::size_t best = 0;
    magnitude most;
    for (std::size_t i = 0; i < slope.size(); ++i) {
        const magnitude speed = magnitude(slope[i]) / (magnitude(start[i]) + magnitude::of(1, -4));
        if (most < speed) {
            most = speed;
            best = i;
        }
    }
    if (most.is_zero()) {
        throw error(error_kind::argument, error_subject::problem, "",
                    "is at rest at the initial point, where there is no periodic orbit: choose another initial point");
    }
    return best;
}

// Why a search found no return to the section through the initial point.
std::string reason_of(const zero_search& search) {
    const std::string reached = proved_reach_text(search.reached(), true);
    switch (search.end()) {
        case search_end::steps:
            return "is proved to exist up to " + reached +
                   ", where the step size falls below its minimum (probably a singularity); no return to the section "
                   "through its initial point was found before";
        case search_end::horizon:
            return "was not found to return to the section through its initial point within " +
                   std::to_string(search.steps()) + " steps, up to time " + reached +
                   ": choose an initial point near an orbit of a shorter period";
        case search_end::none:
        case search_end::time:
        case search_end::precision:
        case search_end::undecided: break;
    }
    return "was not found to return to the section through its initial point: " + std::to_string(first_bits) +
           " bits do not decide it after time " + reached;
}

// The time of the return closest to the initial point.
number guessed_period(const explicit_system& system, const first_order_form& form, std::size_t held,
                      const march_watch& watch) {
    const auto start = start_of(form);
    const auto rising = form.slopes_at(start, ball(0))[held];
    const crossing way = arb_is_positive(rising.handle()) != 0 ? crossing::up : crossing::down;
    zero_search search(system, form.given[held] - expression(form.starts[held]), first_bits, 1, {}, watch);
    std::optional<ball> period;
    magnitude nearest;
    for (int i = 0; i < most_returns; ++i) {
        const auto event = search.next(way, std::nullopt);
        if (!event) {
            break;
        }
        magnitude distance;
        for (std::size_t k = 0; k < start.size(); ++k) {
            distance += magnitude(event->state[k] - start[k]);
        }
        if (!period || distance * magnitude(2U) < nearest) {
            period = event->time;
            nearest = distance;
        }
    }
    if (!period) {
        throw error(error_kind::undecided, error_subject::solution, "", reason_of(search));
    }
    const ball gone = *period - constant_value<ball>::of(system.point());
    rational result;
    const mpfr middle = midpoint_of(gone);
    mpfr_get_q(result.backend().data(), handle(middle));
    return number(result);
}

// x_i'' = f_i(x) with a symmetric derivative of f: the motion in a potential.
bool is_in_potential(const explicit_system& system) {
    const auto& unknowns = system.unknowns();
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        for (std::size_t j = 0; j < unknowns.size(); ++j) {
            const expression& f = system.right()[i];
            const bool free = partial(f, unknown(unknowns[j].name, 1)).is(0);
            if (unknowns[j].order != 2 || !free ||
                !same_form(partial(f, unknown(unknowns[j].name)),
                           partial(system.right()[j], unknown(unknowns[i].name)))) {
                return false;
            }
        }
    }
    return true;
}

// A conserved quantity I satisfies I(x + F) = I(x): where F = 0, grad I dF/dx = 0, so that no periodic orbit is isolated.
[[noreturn]] void refuse_family(const explicit_system& system, const std::string& reason) {
    const std::string x = system.unknowns().front().name;
    throw error(error_kind::undecided, error_subject::solution, "",
                reason +
                    ", so that periodic orbits come in families, one for each energy or period; without --periodic, "
                    "one of them is determined by its half period T or its energy, if " +
                    x + "'(0) = 0 and T is a parameter: use --unknown \"" + x + "(0)\" --such-that \"" + x +
                    "'(T) = 0\", or T as a second unknown and the energy at 0 as a second condition");
}

// find(); a failure is explained for a system that declares an invariant, which is not proved to be conserved.
template <class Find>
periodic_orbit orbit_or_family(const explicit_system& system, const Find& find) {
    try {
        return find();
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided || !problem.is_about_solution() || system.invariants().empty()) {
            throw;
        }
        refuse_family(system, "was not found to be isolated: the problem declares that its invariant is conserved");
    }
}

class periodic_search {
public:
    periodic_search(const explicit_system& system, const first_order_form& form, const orbit_question& question,
                    const proof_route& route, const march_watch& watch)
        : system_(system),
          form_(form),
          question_(question),
          route_(route),
          watch_(watch),
          integrals_(first_integrals_of(form, system.invariants())) {}

    periodic_orbit result() { return integrals_.empty() ? isolated() : in_family(); }

private:
    periodic_orbit isolated() {
        if (is_in_potential(system_)) {
            refuse_family(system_, "is not isolated: the energy of a motion in a potential is conserved");
        }
        orbit_conditions conditions;
        const std::size_t held = unknown_on_section(system_);
        std::vector<number> guess = form_.starts;
        for (std::size_t i = 0; i < form_.starts.size(); ++i) {
            conditions.rows.push_back(i);
            if (i != held) {
                conditions.free.push_back(i);
            }
        }
        {
            const precision_scope scope(decimal_digits(first_bits));
            guess.push_back(question_.period ? number_of(return_near(*question_.period))
                                             : guessed_period(system_, form_, held, watch_));
        }
        guess.erase(guess.begin() + static_cast<std::ptrdiff_t>(held));
        const orbit_map map(system_, form_, std::move(conditions), guess.back(), route_, watch_);
        return orbit_or_family(
            system_, [&] { return orbit_proof(form_, question_, integrals_).orbit(map, first_iterate(guess), 0); });
    }

    periodic_orbit in_family() {
        const orbit_proof proof(form_, question_, integrals_);
        const orbit_guess near = guessed_orbit(system_, form_, integrals_, question_.period,
                                               bits_of_first_run(proof.digits_of_root(true)) + 8);
        const bool free_period = near.conditions.is_period_free;
        const orbit_map map(system_, form_, near.conditions,
                            free_period ? number_of(near.period) : question_.period.value_or(number_of(near.period)),
                            route_, watch_);
        periodic_orbit orbit = proof.orbit(map, near.unknowns, near.settled_bits);
        for (std::size_t i = 0; i < form_.names.size(); ++i) {
            if (std::ranges::find(near.conditions.free, i) == near.conditions.free.end()) {
                orbit.held.push_back(form_.names[i]);
            }
        }
        if (!free_period) {
            orbit.held.emplace_back("period");
        }
        for (const first_integral& each : near.conditions.integrals) {
            orbit.integrals.push_back(each.text);
        }
        orbit.by_reversal = !near.conditions.reversal.empty();
        return orbit;
    }

    double return_near(const number& period) const {
        rounded_flow flow(system_);
        return guessed_return(flow, period).time;
    }

    static number number_of(double x) { return number(rational(x)); }

    const explicit_system& system_;
    const first_order_form& form_;
    const orbit_question& question_;
    proof_route route_;
    const march_watch& watch_;
    std::vector<first_integral> integrals_;
};

}  // namespace

std::size_t unknown_on_section(const explicit_system& system) {
    const precision_scope scope(decimal_digits(first_bits));
    return fastest(first_order_form(system));
}

bool has_families_of_orbits(const explicit_system& system) {
    return !first_integrals_of(first_order_form(system), system.invariants()).empty();
}

periodic_orbit proved_periodic_orbit(const explicit_system& system, long digits, const proof_route& route,
                                     const march_watch& watch) {
    return proved_periodic_orbit(system, orbit_question{digits, {}, false}, route, watch);
}

periodic_orbit proved_periodic_orbit(const explicit_system& system, const orbit_question& question,
                                     const proof_route& route, const march_watch& watch) {
    const first_order_form form(system);
    for (const expression& each : form.slopes) {
        if (each.has_variable()) {
            throw error(error_kind::argument, error_subject::problem, system.variable(),
                        "occurs in the equation: periodic orbits require an autonomous system");
        }
    }
    return periodic_search(system, form, question, route, watch).result();
}

}  // namespace libration::ode
