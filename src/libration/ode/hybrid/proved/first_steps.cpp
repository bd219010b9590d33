#include "libration/ode/hybrid/proved/first_steps.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "libration/ode/ball/start_sign.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_open_steps = 8;

error refused(const step_function& of, const std::string& reason) {
    return {error_kind::undecided, "start", of.text, reason + ": choose another initial point"};
}

expression at_start(const hybrid_system& system, const expression& e) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return expression(system.point());
        }
        for (std::size_t k = 0; k < system.leaves().size(); ++k) {
            if (same_form(leaf, system.leaves()[k])) {
                return expression(system.starts()[k]);
            }
        }
        return std::nullopt;
    });
}

// The values with those of the arguments that are 0 at the initial point from the bits of `choice`; the indices of
// these are added to `open`.
step_values chosen_steps(const hybrid_system& system, std::size_t choice, std::vector<std::size_t>& open) {
    open.clear();
    step_values values(system.steps().size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (const auto constant = system.constant_step(i, values)) {
            values[i] = *constant;
            continue;
        }
        if (system.steps()[i].kind == step_kind::floor) {
            values[i] = system.floor_after(i, values, system.point());
            continue;
        }
        int sign = at_start(system, system.argument(i, values)).constant().sign();
        if (sign == 0) {
            sign = ((choice >> open.size()) & 1U) != 0 ? 1 : -1;
            open.push_back(i);
        }
        values[i] = number(rational(sign));
    }
    return values;
}

// Whether each open argument has the sign of its step function after the initial point.
bool is_consistent(const hybrid_system& system, const step_values& values, const std::vector<std::size_t>& open) {
    const explicit_system branch = system.first_branch(values);
    const first_order_form form(branch);
    return std::ranges::all_of(open, [&](std::size_t i) {
        const expression u = form.in_leaves(system.argument(i, values));
        try {
            return sign_at_start(form, u, form.slope_of(u), branch.point()).beside(1) == values[i].sign();
        } catch (const error& problem) {
            if (problem.kind() != error_kind::undecided) {
                throw;
            }
            throw refused(system.steps()[i],
                          "begins on a switching surface, and it is not decided whether the solution "
                          "leaves it");
        }
    });
}

}  // namespace

step_values steps_after_start(const hybrid_system& system) {
    std::vector<std::size_t> open;
    step_values first = chosen_steps(system, 0, open);
    if (open.empty()) {
        return first;
    }
    const step_function& first_open = system.steps()[open.front()];
    if (open.size() > most_open_steps) {
        throw refused(first_open, "begins at more than " + std::to_string(most_open_steps) + " switching surfaces");
    }
    std::optional<step_values> found;
    for (std::size_t choice = 0; choice < (std::size_t{1} << open.size()); ++choice) {
        std::vector<std::size_t> of_choice;
        step_values values = chosen_steps(system, choice, of_choice);
        if (of_choice.size() != open.size() || !is_consistent(system, values, of_choice)) {
            continue;
        }
        if (found) {
            throw refused(first_open,
                          "changes its branch at the initial point, and the solution can continue on more than one");
        }
        found = std::move(values);
    }
    if (!found) {
        throw refused(first_open,
                      "changes its branch at the initial point, and no branch leads away from it, so that the "
                      "solution slides along the surface between them");
    }
    return *found;
}

}  // namespace libration::ode
