// Derivatives of expressions, and replacement of their leaves.
#include <stdexcept>
#include <unordered_set>
#include <vector>

#include "libration/equation/expression.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/function/list.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

bool is_leaf(const expression& e) {
    return e.kind() == node_kind::variable || e.kind() == node_kind::unknown || e.kind() == node_kind::parameter;
}

// The derivative of f(x) with respect to x, given f(x).
expression slope_of(const expression& e) {
    return function::with_function(e.function(), [&](auto of) -> expression {
        using each = decltype(of);
        if constexpr (function::ordered<each>) {
            return each::derivative(e.order(), e.left(), e);
        } else {
            return each::derivative(e.left(), e);
        }
    });
}

// The derivative of a node from those of its operands; `by_right` is null if it has only one.
expression derived(const expression& e, const expression& by_left, const expression* by_right) {
    const expression& a = e.left();
    switch (e.kind()) {
        case node_kind::sum: return by_left + *by_right;
        case node_kind::product:
            return e.is_unfolded_zero() && !by_right->is(0) ? e : by_left * e.right() + a * *by_right;
        case node_kind::quotient: return (by_left - e * *by_right) / e.right();
        case node_kind::power: {
            const expression by_base = e.right() * pow(a, e.right() - 1) * by_left;
            return by_right->is(0) ? by_base : by_base + log(a) * e * *by_right;
        }
        case node_kind::function: return by_left.is(0) ? expression() : slope_of(e) * by_left;
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    throw std::logic_error("a leaf has no operands");
}

}  // namespace

void each_leaf(const expression& e, const std::function<void(const expression& leaf)>& seen) {
    std::unordered_set<const void*> done;
    std::vector<const expression*> open{&e};
    while (!open.empty()) {
        const expression& next = *open.back();
        open.pop_back();
        if (next.kind() == node_kind::constant || !done.insert(next.identity()).second) {
            continue;
        }
        if (is_leaf(next)) {
            seen(next);
        }
        const auto [left, right] = operands_of(next);
        for (const expression* each : {next.has_order() ? &next.right() : right, left}) {
            if (each != nullptr) {
                open.push_back(each);
            }
        }
    }
}

expression with_operands(const expression& e, const node_values<expression>& done, const replacement& by) {
    switch (e.kind()) {
        case node_kind::sum: return done.at(e.left()) + done.at(e.right());
        case node_kind::product:
            return e.is_unfolded_zero() ? unfolded_zero(done.at(e.right())) : done.at(e.left()) * done.at(e.right());
        case node_kind::quotient: return done.at(e.left()) / done.at(e.right());
        case node_kind::power: return pow(done.at(e.left()), done.at(e.right()));
        case node_kind::function:
            return e.has_order()
                       ? apply(e.function(), by ? with_nodes_replaced(e.right(), by) : e.right(), done.at(e.left()))
                       : apply(e.function(), done.at(e.left()));
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: break;
    }
    return e;
}

expression with_nodes_replaced(const expression& in, const replacement& by) {
    node_values<expression> done;
    return done.of(in, [&](const expression& e) -> expression {
        const auto other = by(e);
        return other ? *other : with_operands(e, done, by);
    });
}

expression replaced(const expression& in, const replacement& by) {
    return with_nodes_replaced(in, [&](const expression& e) { return is_leaf(e) ? by(e) : std::nullopt; });
}

expression partial(const expression& e, const expression& leaf) {
    node_values<expression> done;
    return done.of(e, [&](const expression& each) -> expression {
        if (each.kind() == node_kind::constant || is_leaf(each)) {
            return same_form(each, leaf) ? 1 : 0;
        }
        if (each.has_order() && each.right().has_parameters() && !partial(each.right(), leaf).is(0)) {
            throw error(error_kind::argument, "order", "", "of a function has no derivative here");
        }
        const auto [left, right] = operands_of(each);
        return derived(each, done.at(*left), right == nullptr ? nullptr : &done.at(*right));
    });
}

expression derivative_along(const expression& e, const std::vector<expression>& leaves,
                            const std::vector<expression>& directions) {
    expression sum;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const expression by = partial(e, leaves[k]);
        if (!by.is(0)) {
            sum = sum + by * directions[k];
        }
    }
    return sum;
}

}  // namespace libration::ode
