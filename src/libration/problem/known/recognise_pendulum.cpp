// Which equations are those of a pendulum.
#include <cstddef>
#include <utility>

#include "libration/equation/explicit_system.hpp"
#include "libration/problem/known/pendulum_solution.hpp"
#include "libration/scalar/error.hpp"

namespace libration {

namespace {

using ode::explicit_system;
using ode::node_kind;
using pendulum::motion;

// c of c sin(x), x the unknown of this name itself.
std::optional<ode::number> factor_of_sine(const ode::expression& e, const std::string& name) {
    if (e.kind() == node_kind::product && e.left().kind() == node_kind::constant) {
        const auto rest = factor_of_sine(e.right(), name);
        return rest ? std::optional(e.left().constant() * *rest) : std::nullopt;
    }
    const bool sine = e.kind() == node_kind::function && e.function() == function_kind::sin;
    const bool of_it =
        sine && e.left().kind() == node_kind::unknown && e.left().name() == name && e.left().derivative() == 0;
    return of_it ? std::optional(ode::number(1)) : std::nullopt;
}

bool is_unknown(const ode::expression& e, const std::string& name) {
    return e.kind() == node_kind::unknown && e.name() == name && e.derivative() == 0;
}

// The index of the angle among the unknowns and c of its second derivative c sin.
struct pendulum_form {
    std::size_t angle;
    ode::number factor;
};

std::optional<pendulum_form> form_of(const explicit_system& system) {
    const auto& unknowns = system.unknowns();
    const auto& right = system.right();
    if (system.singular()) {
        return std::nullopt;
    }
    if (unknowns.size() == 1 && unknowns[0].order == 2) {
        const auto factor = factor_of_sine(right[0], unknowns[0].name);
        return factor ? std::optional(pendulum_form{0, *factor}) : std::nullopt;
    }
    if (unknowns.size() != 2 || unknowns[0].order != 1 || unknowns[1].order != 1) {
        return std::nullopt;
    }
    for (const std::size_t angle : {0U, 1U}) {
        const auto factor = factor_of_sine(right[1 - angle], unknowns[angle].name);
        if (factor && is_unknown(right[angle], unknowns[1 - angle].name)) {
            return pendulum_form{angle, *factor};
        }
    }
    return std::nullopt;
}

exact exact_number(const ode::number& value, const std::string& name) {
    const auto fraction = value.fraction();
    return fraction ? exactly(*fraction) : exactly(value, name);
}

}  // namespace

std::optional<recognised_pendulum> recognise_pendulum(const ode::equation_system& equations) {
    const auto highest = equations.highest_derivatives();
    if (highest.size() == 1 && highest.begin()->second == 1) {
        return std::nullopt;
    }
    const explicit_system system(equations);
    const auto form = form_of(system);
    if (!form) {
        return std::nullopt;
    }
    const bool second_order = system.unknowns().size() == 1;
    const auto& starts = system.starts();
    const std::string& angle = system.unknowns()[form->angle].name;
    const ode::number& omega0 = second_order ? starts[0][1] : starts[1 - form->angle][0];
    try {
        if (form->factor.sign() >= 0) {
            return std::nullopt;
        }
        motion of = motion::of_state(exact_number(starts[form->angle][0], angle + "(0)"),
                                     exact_number(omega0, angle + "'(0)"), exact_number(-form->factor, "k"));
        return recognised_pendulum{std::move(of), exact_number(system.point(), "t0"), form->angle == 1, second_order,
                                   angle};
    } catch (const error&) {
        return std::nullopt;
    }
}

}  // namespace libration
