#include "lifted_models.hpp"

#include <string>
#include <utility>

#include "libration/expansion/step_pieces.hpp"
#include "model_tail.hpp"

namespace libration::ode {

namespace {

constexpr int order_of_paths = 16;
constexpr int most_steps_of_paths = 64;
// log2 of a step relative to the radius of theorem T: the tail of order 16 is 2^-34 of its bound.
constexpr long log2_of_step = -2;

expression direction(std::size_t i) { return unknown("direction " + std::to_string(i)); }

// The system of c + s (y - c) and w(s), and of the constant y - c.
explicit_system path_system(const polynomial_form& of) {
    const expression point(of.system.point());
    const replacement at_point = [&](const expression& leaf) -> std::optional<expression> {
        return leaf.kind() == node_kind::variable ? std::optional(point) : std::nullopt;
    };
    std::vector<expression> leaves = of.leaves;
    std::vector<expression> right;
    for (std::size_t i = 0; i < of.given; ++i) {
        right.push_back(direction(i));
    }
    for (const gradient& each : of.polynomial_gradients) {
        expression sum;
        for (const auto& [k, by] : each) {
            sum = sum + (replaced(by, at_point) * right[k]);
        }
        right.push_back(sum);
    }
    for (std::size_t i = 0; i < of.given; ++i) {
        leaves.push_back(direction(i));
        right.emplace_back();
    }
    return explicit_system::first_order(leaves, std::move(right), number(0));
}

ball constant_of(const taylor_model& model) {
    ball result;
    arf_set_d(arb_midref(result.handle()), model.coefficient(0));
    return result;
}

}  // namespace

std::optional<std::vector<taylor_model>> lifted_models(const polynomial_form& of,
                                                       const std::vector<taylor_model>& given) {
    if (of.added.empty()) {
        return given;
    }
    const monomial_set& in = given.front().in();
    std::vector<ball> centre;
    centre.reserve(given.size());
    for (const taylor_model& each : given) {
        centre.push_back(constant_of(each));
    }
    std::vector<taylor_model> state;
    for (const ball& each : lifted_values(of, constant_value<ball>::of(of.system.point()), centre)) {
        state.emplace_back(in, each);
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
        state.push_back(given[i] + (-centre[i]));
    }
    const tape steps = tape::about_points(path_system(of));
    model_expansion path(steps, order_of_paths, in);
    ball rest(1);
    for (int step = 0; step < most_steps_of_paths; ++step) {
        path.about(ball(0), state);
        const auto tail = tail_of(steps, path);
        if (!tail) {
            return std::nullopt;
        }
        const ball longest = tail->radius.shifted(log2_of_step).exact();
        const bool last = exactly_less(rest, longest);
        const ball length = last ? rest : longest;
        for (std::size_t i = 0; i < state.size(); ++i) {
            state[i] = path.at(i, length);
            state[i].add_to_rest(tail->at(i, magnitude(length)));
        }
        if (last) {
            state.erase(state.begin() + static_cast<std::ptrdiff_t>(of.leaves.size()), state.end());
            return state;
        }
        rest = exact_sum(rest, -length);
    }
    return std::nullopt;
}

}  // namespace libration::ode
