#include "emptying_flow.hpp"

#include <utility>

#include "branch_beginning.hpp"
#include "libration/expansion/step_pieces.hpp"
#include "libration/integration/rule_for.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int largest_root = 64;

bool is_root(const expression& e) {
    return e.kind() == node_kind::power || (e.kind() == node_kind::function && (e.function() == function_kind::sqrt ||
                                                                                e.function() == function_kind::cbrt));
}

}  // namespace

leaf_power power_of_leaf(const expression& e, const expression& leaf) {
    if (same_form(e, leaf)) {
        return {1, 1};
    }
    if (e.kind() == node_kind::product || e.kind() == node_kind::quotient) {
        const leaf_power a = power_of_leaf(e.left(), leaf);
        const leaf_power b = power_of_leaf(e.right(), leaf);
        return e.kind() == node_kind::product ? leaf_power{rational(a.exponent + b.exponent), a.rest * b.rest}
                                              : leaf_power{rational(a.exponent - b.exponent), a.rest / b.rest};
    }
    const auto r = !is_root(e)                           ? std::nullopt
                   : e.kind() == node_kind::power        ? e.right().fraction()
                   : e.function() == function_kind::sqrt ? std::optional(rational(1, 2))
                                                         : std::optional(rational(1, 3));
    if (!r) {
        return {0, e};
    }
    const leaf_power inner = power_of_leaf(e.left(), leaf);
    return inner.exponent == 0 ? leaf_power{0, e}
                               : leaf_power{rational(inner.exponent * *r), pow(inner.rest, expression(*r))};
}

ball power_of_ball(const ball& x, const rational& exponent) {
    ball result;
    const ball by = constant_value<ball>::of(number(exponent));
    arb_pow(result.handle(), x.handle(), by.handle(), ball::working_bits());
    return result;
}

emptying_flow::emptying_flow(const explicit_system& branch, const store_outflow& of, const std::vector<ball>& state,
                             const ball& time, long bits, const proof_route& route)
    : form_(branch), leaf_(of.leaf), bits_(bits) {
    const expression h = form_.leaves[leaf_];
    integer root = denominator(of.exponent);
    const auto read = [&](const expression& e) {
        with_nodes_replaced(e, [&](const expression& node) {
            root = is_root(node) ? lcm(root, denominator(power_of_leaf(node, h).exponent)) : root;
            return std::optional<expression>();
        });
    };
    for (const expression& each : form_.slopes) {
        read(each);
    }
    if (root > largest_root) {
        throw error(error_kind::argument, error_subject::problem, "", "has powers of a store with large denominators");
    }
    root_ = root.convert_to<int>();
    time_power_ = numerator(rational(root_ * (1 - of.exponent))).convert_to<int>() - 1;
    for (std::size_t j = 0; j <= form_.leaves.size(); ++j) {
        unknowns_.push_back(unknown("w" + std::to_string(j)));
    }
    const expression by_time = pow(unknowns_[leaf_], expression(time_power_));
    std::vector<expression> right;
    for (std::size_t j = 0; j < form_.slopes.size(); ++j) {
        slopes_.push_back(in_roots(form_.slopes[j]));
        right.push_back(j == leaf_ ? expression(rational(-1, root_)) * in_roots(form_.in_leaves(of.outflow))
                                   : by_time * slopes_.back());
    }
    right.push_back(by_time);
    flow_ = explicit_system::first_order(unknowns_, std::move(right), number());
    start_ = state;
    start_[leaf_] = power_of_ball(state[leaf_], rational(1, root_));
    start_.push_back(time);
    along_ = std::make_unique<integration>(flow_state{ball(0), box_around(start_, bits), {}, {}},
                                           rule_for(*flow_, {bits}, route), infinite_distance(1), bits);
}

// Of an expression in leaves, with h = v^m, v > 0.
expression emptying_flow::in_roots(const expression& e) const {
    const expression& h = form_.leaves[leaf_];
    return with_nodes_replaced(e, [&](const expression& node) -> std::optional<expression> {
        if (is_root(node)) {
            const leaf_power power = power_of_leaf(node, h);
            return power.exponent == 0
                       ? std::nullopt
                       : std::optional(in_roots(power.rest) *
                                       pow(unknowns_[leaf_], expression(rational(power.exponent * root_))));
        }
        if (node.kind() == node_kind::variable) {
            return unknowns_.back();
        }
        for (std::size_t j = 0; j < form_.leaves.size(); ++j) {
            if (same_form(node, form_.leaves[j])) {
                return j == leaf_ ? pow(unknowns_[j], expression(root_)) : unknowns_[j];
            }
        }
        return std::nullopt;
    });
}

ball emptying_flow::value(const expression& e, const std::vector<ball>& at) const {
    expression_values<ball> values(unknowns_, ball(0));
    for (const ball& each : at) {
        values.push_back(each);
    }
    return values.of(e);
}

bool emptying_flow::reach(long most_steps) {
    zero_search search(*flow_, unknowns_[leaf_], *along_, search_start{}, bits_);
    const auto event = search.next(crossing::down, std::nullopt, most_steps);
    if (!event) {
        return false;
    }
    end_ = event->time;
    time_ = event->state.back();
    state_ = event->state;
    state_.pop_back();
    state_[leaf_] = ball(0);
    return is_finite(time_);
}

bool emptying_flow::excludes_zero(const expression& g) {
    const expression in_flow = in_roots(form_.in_leaves(g));
    const int sign = known_sign(value(in_flow, start_));
    if (sign == 0) {
        return false;
    }
    zero_search search(*flow_, in_flow, *along_, search_start{.sign = sign}, bits_);
    return !search.next(crossing::any, number_of(upper_bound(end_))) && search.end() == search_end::time;
}

// From a value of s at which t is less than all of the ball.
std::vector<ball> emptying_flow::states_before() {
    ball unbounded;
    arb_zero_pm_inf(unbounded.handle());
    std::vector<ball> states(state_.size(), unbounded);
    const ball width = upper_bound(time_) - lower_bound(time_);
    ball back = upper_bound(end_) - lower_bound(end_) + ldexp(ball(1), static_cast<int>(-bits_));
    for (; certainly_less(back, lower_bound(end_)); back = back * 2) {
        const ball first = lower_bound(lower_bound(end_) - back);
        std::size_t k = 0;
        const auto then = steps_about(*along_, k, first);
        if (!then || !certainly_less(values_at(*then).back(), lower_bound(time_))) {
            continue;
        }
        k = 0;
        const auto all = steps_about(*along_, k, hull(first, upper_bound(end_)));
        if (!all) {
            return states;
        }
        const auto box = values_at(*all);
        for (std::size_t j = 0; j < states.size(); ++j) {
            states[j] = widened(state_[j], magnitude(value(slopes_[j], box)) * magnitude(width));
        }
        return states;
    }
    return states;
}

}  // namespace libration::ode
