// Branches on which a solution slides along the surface of a sign: theorem H, "Sliding".
#include <utility>
#include <vector>

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
               : with_means(given_.equations[place].right, values);
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

// L_- u/(L_- u - L_+ u), where both sides are defined.
expression hybrid_system::share_above(std::size_t step, const step_values& values) const {
    const expression up = slope_beside(step, 1, values);
    const expression down = slope_beside(step, -1, values);
    if (without_zeros(down).is(0)) {
        return down;
    }
    return without_zeros(up).is(0) ? written_sum(1, up) : written_quotient(down, written_sum(down, -up));
}

std::vector<std::size_t> hybrid_system::sliding_steps(const step_values& values) const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_sliding(i, values)) {
            all.push_back(i);
        }
    }
    return all;
}

// f_- + sum_i share_i (f_i+ - f_-): f_- has the value -1 of all sliding steps, f_i+ the value 1 of one of them. In the
// shares one step less slides.
expression hybrid_system::with_means(const expression& e, const step_values& values) const {
    const auto sliding = sliding_steps(values);
    step_values below = values;
    for (const std::size_t i : sliding) {
        below[i] = number(rational(-1));
    }
    const expression under = on_branch(e, below);
    expression sum = under;
    for (const std::size_t i : sliding) {
        step_values above = below;
        above[i] = number(rational(1));
        if (const expression over = on_branch(e, above); !same_form(over, under)) {
            sum = written_sum(sum, written_product(share_above(i, values), written_sum(over, -under)));
        }
    }
    return sum;
}

void hybrid_system::slide(const step_values& values, equation_system& of) const {
    const auto sliding = sliding_steps(values);
    if (sliding.empty()) {
        return;
    }
    require_explicit(sliding.front());
    for (std::size_t i = 0; i < given_.equations.size(); ++i) {
        of.equations[i].right = with_means(given_.equations[i].right, values);
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
