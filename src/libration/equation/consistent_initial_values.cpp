#include "consistent_initial_values.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "libration/scalar/error.hpp"
#include "libration/scalar/mpfr.hpp"

namespace libration::ode {

namespace {

std::string statement_of(const std::string& name) { return name + "(0) = number"; }

// The equations at the initial point that contain missing values, which are the unknowns in them.
std::vector<equation> equations_at_start(const std::vector<unknown_function>& unknowns, const number& point,
                                         const std::vector<algebraic_equation>& algebraic,
                                         const std::vector<std::vector<number>>& starts) {
    const auto places = places_of(unknowns);
    const auto value_of = [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return expression(point);
        }
        const auto& known = starts[places.at(leaf.name())];
        return known.empty() ? std::nullopt
                             : std::optional(expression(known[static_cast<std::size_t>(leaf.derivative())]));
    };
    std::vector<equation> found;
    for (const algebraic_equation& each : algebraic) {
        expression zero;
        try {
            zero = replaced(each.zero, value_of);
        } catch (const error& none) {
            std::string name;
            each_leaf(each.zero, [&](const expression& leaf) {
                const bool open = leaf.kind() == node_kind::unknown && starts[places.at(leaf.name())].empty();
                name = open && name.empty() ? leaf.name() : name;
            });
            refuse(name, each.at,
                   "has no value at the initial point, where its equation " + none.reason() +
                       ": choose another initial point, or leave it out");
        }
        if (zero.has_unknowns()) {
            found.push_back({std::move(zero), 0, each.at});
        }
    }
    return found;
}

linear_result solved(const std::vector<equation>& equations, const std::vector<expression>& missing) {
    try {
        return linear_solution(equations, missing,
                               [](const expression& c) { return c.is_constant() && c.constant().sign() != 0; });
    } catch (const error&) {
        return {};
    }
}

}  // namespace

bool complete_starts(const std::vector<unknown_function>& unknowns, const number& point,
                     const std::vector<algebraic_equation>& algebraic, std::vector<std::vector<number>>& starts) {
    std::vector<expression> missing;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        if (starts[i].empty()) {
            missing.push_back(unknown(unknowns[i].name));
            places.push_back(i);
        }
    }
    if (missing.empty()) {
        return false;
    }
    const auto found = solved(equations_at_start(unknowns, point, algebraic, starts), missing).values;
    if (found.empty()) {
        refuse(missing.front().name(), {},
               "has no initial value, and the algebraic equations at the initial point are not linear in those that "
               "are left out, or do not determine them: add " +
                   statement_of(missing.front().name()));
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
        starts[places[k]] = {found[k].constant()};
    }
    return true;
}

void require_consistent(const std::vector<algebraic_equation>& algebraic, start_values& values) {
    for (const algebraic_equation& each : algebraic) {
        std::optional<int> sign;
        std::string reason;
        try {
            sign = values.value_of(each.zero).sign();
        } catch (const error& problem) {
            reason = problem.reason();
        }
        if (!sign) {
            refuse(
                "algebraic equation", each.at,
                "is not proved to hold for the initial values (" + reason + "): give initial values that satisfy it");
        }
        if (*sign != 0) {
            refuse("algebraic equation", each.at,
                   "does not hold for the initial values, where its sides differ by " +
                       rounded_value(values.value_of(each.zero)).str(6) +
                       ": give initial values that satisfy it and its derivatives");
        }
    }
}

}  // namespace libration::ode
