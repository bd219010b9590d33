#include "libration/expansion/start_sign.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include "libration/expansion/step_pieces.hpp"
#include "libration/scalar/error.hpp"
#include "libration/scalar/proved.hpp"

namespace libration::ode {

namespace {

ball enclosed(const expression& e, const first_order_form& form, const number& point) {
    expression_values<ball> values(form.leaves, constant_value<ball>::of(point));
    for (const number& each : form.starts) {
        values.push_back(constant_value<ball>::of(each));
    }
    return values.of(e);
}

expression at_start(const expression& e, const first_order_form& form, const number& point) {
    return replaced(e, [&](const expression& leaf) -> std::optional<expression> {
        if (leaf.kind() == node_kind::variable) {
            return expression(point);
        }
        for (std::size_t k = 0; k < form.leaves.size(); ++k) {
            if (same_form(leaf, form.leaves[k])) {
                return expression(form.starts[k]);
            }
        }
        return std::nullopt;
    });
}

// -1, 0 or 1, proved.
int exact_sign(const expression& e, const first_order_form& form, const number& point, int order) {
    if (const int sign = known_sign(enclosed(e, form, point)); sign != 0) {
        return sign;
    }
    try {
        const expression value = at_start(e, form, point);
        if (value.kind() != node_kind::constant) {
            throw std::logic_error("an expression in leaves with others in it");
        }
        return value.constant().sign();
    } catch (const error& problem) {
        const std::string what =
            order == 0 ? "the condition holds there" : "its derivative number " + std::to_string(order) + " is 0 there";
        throw error(
            error_kind::undecided, error_subject::start, "",
            "cannot be distinguished from an event: whether " + what + " is not decided (" + problem.what() +
                "); write the initial value and the condition in the same form, or choose another initial point");
    }
}

}  // namespace

start_sign sign_at_start(const first_order_form& form, const expression& g, const expression& slope,
                         const number& point) {
    start_sign result{0, 1, g};
    for (;;) {
        result.sign = exact_sign(result.leading, form, point, result.order);
        if (result.sign != 0) {
            return result;
        }
        if (result.order == most_orders_at_start) {
            throw error(error_kind::undecided, error_subject::start, "",
                        "is an event of too high an order: the condition and its first " +
                            std::to_string(most_orders_at_start) + " derivatives hold there");
        }
        result.leading = result.order == 0 ? slope : form.slope_of(result.leading);
        ++result.order;
    }
}

}  // namespace libration::ode
