// Branches on which a solution slides along the surface of a sign: theorem H, "Sliding".
#include <algorithm>
#include <utility>

#include "libration/equation/defined_zero.hpp"
#include "libration/equation/hybrid_system.hpp"
#include "libration/equation/identities.hpp"

namespace libration::ode {

number sliding_value() { return number(rational(1, 2)); }

bool hybrid_system::is_sliding(std::size_t step, const step_values& values) const {
    return given_.steps[step].kind == step_kind::sign && same_form(values[step], sliding_value());
}

expression hybrid_system::right_side_of(const expression& leaf, const step_values& values) const {
    const std::size_t place = equation_places_.at(leaf.name());
    return leaf.derivative() + 1 < given_.equations[place].left.derivative()
               ? unknown(leaf.name(), leaf.derivative() + 1)
               : on_branch(given_.equations[place].right, values);
}

expression hybrid_system::slope_beside(std::size_t step, int side, step_values values) const {
    const expression u = argument(step, values);
    values[step] = number(rational(side));
    expression sum = partial(u, ode::variable());
    for (const expression& leaf : leaves_) {
        if (const expression by = partial(u, leaf); !by.is(0)) {
            sum = written_sum(sum, written_product(by, right_side_of(leaf, values)));
        }
    }
    return sum;
}

// y' = f_- + L_- u/(L_- u - L_+ u) (f_+ - f_-), where both sides are defined.
void hybrid_system::slide(std::size_t step, const step_values& values, equation_system& of) const {
    require_explicit(step);
    step_values above = values;
    step_values below = values;
    above[step] = number(rational(1));
    below[step] = number(rational(-1));
    const expression up = slope_beside(step, 1, values);
    const expression down = slope_beside(step, -1, values);
    const expression share = written_quotient(down, written_sum(down, -up));
    for (std::size_t i = 0; i < given_.equations.size(); ++i) {
        const expression over = on_branch(given_.equations[i].right, above);
        const expression under = on_branch(given_.equations[i].right, below);
        if (!same_form(over, under)) {
            of.equations[i].right = written_sum(under, written_product(share, written_sum(over, -under)));
        }
    }
    // The order of the unknowns is that of their first occurrence.
    expression all;
    for (const expression& leaf : leaves_) {
        all = all + unknown(leaf.name());
    }
    of.equations.front().left = unfolded_zero(all) + of.equations.front().left;
}

void hybrid_system::add_ends_of_sliding(std::size_t step, const step_values& values, std::vector<surface>& to) const {
    const expression u = argument(step, values);
    for (const int side : {1, -1}) {
        const expression slope = without_zeros(slope_beside(step, side, values));
        if (slope.kind() == node_kind::constant || vanishes_with(slope, u)) {
            continue;
        }
        surface& at = add_surface(to, slope, given_.steps[step].text);
        const auto linear = linear_in_variable::of(slope);
        const int orientation = linear ? linear->slope.sign() : relative_sign(at.g, slope);
        at.steps.push_back({step, -side * orientation});
    }
}

}  // namespace libration::ode
