#include "decay_coordinates.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/ball/predicates.hpp"

namespace libration::ode {

namespace {

using replacements = std::map<std::string, expression>;

expression with(const expression& in, const replacements& by) {
    return replaced(in, [&](const expression& leaf) {
        const auto found = leaf.kind() == node_kind::unknown ? by.find(leaf.name()) : by.end();
        return found == by.end() ? std::nullopt : std::optional(found->second);
    });
}

// The right-hand sides of the given unknowns in terms of these alone.
std::vector<expression> right_sides_of_given(const polynomial_form& form) {
    replacements definitions;
    for (std::size_t k = 0; k < form.added.size(); ++k) {
        definitions.emplace(form.leaves[form.given + k].name(), with(form.added[k], definitions));
    }
    std::vector<expression> right;
    for (std::size_t k = 0; k < form.given; ++k) {
        right.push_back(with(form.system.right()[k], definitions));
    }
    return right;
}

bool contains_one_of(const expression& e, const replacements& leaves) {
    bool found = false;
    each_leaf(e, [&](const expression& leaf) {
        found = found || (leaf.kind() == node_kind::unknown && leaves.contains(leaf.name()));
    });
    return found;
}

// m_kl, by rows and columns of S; std::nullopt if the equations are not of this form.
std::optional<std::vector<std::vector<expression>>> linear_part(const std::vector<expression>& right,
                                                                const std::vector<expression>& leaves,
                                                                const std::vector<std::size_t>& decaying) {
    replacements zero;
    for (const std::size_t k : decaying) {
        zero.emplace(leaves[k].name(), expression(0));
    }
    std::vector<std::vector<expression>> result;
    for (const std::size_t k : decaying) {
        if (!with(right[k], zero).is(0)) {
            return std::nullopt;
        }
        auto& row = result.emplace_back();
        for (const std::size_t l : decaying) {
            row.push_back(partial(right[k], leaves[l]));
            if (contains_one_of(row.back(), zero)) {
                return std::nullopt;
            }
        }
    }
    return result;
}

// The index in S of the unknown that is distinguished from 0 best.
std::optional<std::size_t> leader_of(const std::vector<std::size_t>& decaying, const std::vector<ball>& hull) {
    std::optional<std::size_t> best;
    magnitude most;
    for (std::size_t a = 0; a < decaying.size(); ++a) {
        if (const magnitude least = magnitude::below(hull[decaying[a]]); most < least) {
            most = least;
            best = a;
        }
    }
    return best;
}

}  // namespace

coordinate_map::coordinate_map(std::vector<expression> leaves, std::vector<expression> values)
    : leaves_(std::move(leaves)), values_(std::move(values)) {
    for (const expression& each : values_) {
        auto& row = derivatives_.emplace_back();
        for (const expression& leaf : leaves_) {
            row.push_back(partial(each, leaf));
        }
    }
}

std::vector<ball> coordinate_map::at(const ball& time, const std::vector<ball>& state) const {
    expression_values<ball> values(leaves_, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    std::vector<ball> result;
    for (const expression& each : values_) {
        result.push_back(values.of(each));
    }
    return result;
}

ball_matrix coordinate_map::derivative(const ball& time, const std::vector<ball>& state) const {
    expression_values<ball> values(leaves_, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    ball_matrix result;
    for (const auto& row : derivatives_) {
        auto& all = result.emplace_back();
        for (const expression& each : row) {
            all.push_back(values.of(each));
        }
    }
    return result;
}

std::optional<state_set> coordinate_map::image(const ball& time, const state_set& of) const {
    const auto at_centre = at(time, of.centre);
    const auto by = derivative(time, of.hull());
    const auto finite = [](const std::vector<ball>& all) {
        return std::ranges::all_of(all, [](const ball& each) { return is_finite(each); });
    };
    if (!finite(at_centre) || !std::ranges::all_of(by, finite)) {
        return std::nullopt;
    }
    std::vector<ball> centre;
    std::vector<magnitude> rounding;
    for (const ball& each : at_centre) {
        centre.push_back(midpoint_alone(each));
        rounding.emplace_back(each - centre.back());
    }
    return state_set{std::move(centre), of.errors.image(by, rounding)};
}

std::optional<decay_coordinates> decay_coordinates::of(const polynomial_form& form,
                                                       const std::vector<std::size_t>& decaying, const state_set& at) {
    const std::vector<expression> leaves(form.leaves.begin(),
                                         form.leaves.begin() + static_cast<std::ptrdiff_t>(form.given));
    const std::vector<ball> hull = at.hull();
    std::vector<expression> right = right_sides_of_given(form);
    const auto linear = linear_part(right, leaves, decaying);
    const auto leader = leader_of(decaying, hull);
    if (!linear || !leader) {
        return std::nullopt;
    }
    const std::size_t i = decaying[*leader];
    const expression sign(known_sign(hull[i]));
    const expression size = exp(leaves[i]);
    replacements given_unknowns{{leaves[i].name(), sign * size}};
    std::vector<expression> to = leaves;
    to[i] = log(sign * leaves[i]);
    for (const std::size_t k : decaying) {
        if (k != i) {
            given_unknowns.emplace(leaves[k].name(), sign * size * leaves[k]);
            to[k] = leaves[k] / leaves[i];
        }
    }
    const auto sum = [&](std::size_t row) {
        expression result;
        for (std::size_t l = 0; l < decaying.size(); ++l) {
            result = result + (l == *leader ? (*linear)[row][l] : (*linear)[row][l] * leaves[decaying[l]]);
        }
        return result;
    };
    std::vector<expression> from;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        from.push_back(with(leaves[k], given_unknowns));
        right[k] = with(right[k], given_unknowns);
    }
    right[i] = sum(*leader);
    for (std::size_t a = 0; a < decaying.size(); ++a) {
        if (a != *leader) {
            right[decaying[a]] = sum(a) - leaves[decaying[a]] * right[i];
        }
    }
    return decay_coordinates(lifted_about_points(explicit_system::first_order(leaves, right, form.system.point())),
                             coordinate_map(leaves, std::move(to)), coordinate_map(leaves, std::move(from)));
}

}  // namespace libration::ode
