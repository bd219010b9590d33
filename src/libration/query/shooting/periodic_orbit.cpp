#include "libration/query/shooting/periodic_orbit.hpp"

#include <algorithm>
#include <utility>

#include "../../equation/bound_text.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/event/zero_search.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"
#include "shooting.hpp"

namespace libration::ode {

namespace {

constexpr long first_bits = 128;
constexpr int most_returns = 12;

// F(x, T) = Phi_T(x) - x, x on the section: the unknown `held` has its initial value.
class closing {
public:
    closing(const explicit_system& system, const first_order_form& form, std::size_t held, const number& guessed_period,
            const proof_route& route, const march_watch& watch)
        : system_(system), form_(form), held_(held), guessed_(guessed_period), route_(route), watch_(watch) {}

    std::optional<enclosed_map> operator()(const std::vector<ball>& x, long bits, long error_bits) const {
        const precision_scope scope(decimal_digits(bits));
        require_near_guess(x.back());
        std::vector<ball> start(x.begin(), x.end() - 1);
        start.insert(start.begin() + static_cast<std::ptrdiff_t>(held_), constant_value<ball>::of(form_.starts[held_]));
        proved_march march(system_, start, bits, error_bits, watch_, route_);
        march.keep_derivative();
        const ball time = march.reached() + x.back();
        const auto state = march.at(time);
        if (!state) {
            return std::nullopt;
        }
        enclosed_map result;
        const ball_matrix flow = march.derivative_at(time);
        const auto slope = form_.slopes_at(*state, time);
        for (std::size_t i = 0; i < start.size(); ++i) {
            result.value.push_back((*state)[i] - start[i]);
            auto& row = result.derivative.emplace_back();
            for (std::size_t j = 0; j < start.size(); ++j) {
                if (j != held_) {
                    row.push_back(i == j ? flow[i][j] - 1 : flow[i][j]);
                }
            }
            row.push_back(slope[i]);
        }
        return result;
    }

private:
    // Newton's method may leave for any period, up to which an integration would not end.
    void require_near_guess(const ball& period) const {
        const ball guess = constant_value<ball>::of(guessed_);
        if (certainly_less(period * 2, guess) || certainly_less(guess * 2, period)) {
            throw error(
                error_kind::undecided, error_subject::solution, "",
                "was not found: Newton's method left the neighbourhood of the closest return, from the period " +
                    to_decimal(midpoint_of(guess), 6) + " to " + to_decimal(midpoint_of(period), 6) +
                    ": choose an initial point nearer to a periodic orbit");
        }
    }

    const explicit_system& system_;
    const first_order_form& form_;
    std::size_t held_;
    number guessed_;
    proof_route route_;
    march_watch watch_;
};

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
std::vector<proved_decimal> orbit_or_family(const explicit_system& system, const Find& find) {
    try {
        return find();
    } catch (const error& problem) {
        if (problem.kind() != error_kind::undecided || !problem.is_about_solution() || system.invariants().empty()) {
            throw;
        }
        refuse_family(system, "was not found to be isolated: the problem declares that its invariant is conserved");
    }
}

}  // namespace

std::size_t unknown_on_section(const explicit_system& system) {
    const precision_scope scope(decimal_digits(first_bits));
    return fastest(first_order_form(system));
}

periodic_orbit proved_periodic_orbit(const explicit_system& system, long digits, const proof_route& route,
                                     const march_watch& watch) {
    const first_order_form form(system);
    for (const expression& each : form.slopes) {
        if (each.has_variable()) {
            throw error(error_kind::argument, error_subject::problem, system.variable(),
                        "occurs in the equation: periodic orbits require an autonomous system");
        }
    }
    if (is_in_potential(system)) {
        refuse_family(system, "is not isolated: the energy of a motion in a potential is conserved");
    }
    std::vector<number> guess = form.starts;
    const std::size_t held = unknown_on_section(system);
    {
        const precision_scope scope(decimal_digits(first_bits));
        guess.push_back(guessed_period(system, form, held, watch));
    }
    guess.erase(guess.begin() + static_cast<std::ptrdiff_t>(held));
    const closing closed(system, form, held, guess.back(), route, watch);
    std::vector<std::string> names = form.names;
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(held));
    names.emplace_back("period");
    auto values = orbit_or_family(system, [&] {
        return proved_root(
            [&](const std::vector<ball>& x, long bits, long error_bits) { return closed(x, bits, error_bits); },
            first_iterate(guess), digits, names);
    });
    const precision_scope scope(digits + 20);
    const auto fixed = to_proved_decimal(constant_value<ball>::of(form.starts[held]), digits);
    periodic_orbit orbit{form.names, std::move(values), {}};
    orbit.period = orbit.start.back();
    orbit.start.pop_back();
    orbit.start.insert(orbit.start.begin() + static_cast<std::ptrdiff_t>(held), fixed.value());
    return orbit;
}

}  // namespace libration::ode
