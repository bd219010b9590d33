#include "piecewise.hpp"

#include <ranges>
#include <stdexcept>
#include <utility>

#include "libration/equation/choice.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/equation/hybrid_system.hpp"

namespace libration::ode {

expression step_collector::chosen(const condition& holds, const expression& a, const expression& b) {
    expression value;
    switch (holds.kind) {
        case condition_kind::constant: return holds.holds ? a : b;
        case condition_kind::positive:
            return holds.or_equal ? if_not_negative(holds.difference, a, b) : if_positive(holds.difference, a, b);
        case condition_kind::equal: return if_not_negative(holds.difference, if_positive(holds.difference, b, a), b);
        case condition_kind::negation: return chosen(holds.parts.front(), b, a);
        case condition_kind::all:
            value = a;
            for (const condition& part : std::views::reverse(holds.parts)) {
                value = chosen(part, value, b);
            }
            return value;
        case condition_kind::any:
            value = b;
            for (const condition& part : std::views::reverse(holds.parts)) {
                value = chosen(part, a, value);
            }
            return value;
    }
    throw std::logic_error("a condition of no kind");
}

namespace {

// The bases of the even powers among the factors of an expression, and what has the sign of the rest: u > 0 where the
// rest is positive and no base is 0; of an odd power it is the base. A base of which the sign changes is crossed where its square touches 0.
struct signed_factors {
    std::vector<expression> squared;
    expression rest = 1;

    explicit signed_factors(const expression& u) {
        add(u, 0);
        rest = has_powers_ ? rest : u;
    }

private:
    void add(const expression& e, int depth) {
        constexpr int deepest = 16;
        const auto n = e.kind() == node_kind::power ? e.right().fraction() : std::nullopt;
        if (e.kind() == node_kind::product && depth < deepest) {
            add(e.left(), depth + 1);
            add(e.right(), depth + 1);
        } else if (n && denominator(*n) == 1 && *n > 1 && !e.left().is_constant()) {
            has_powers_ = true;
            numerator(*n) % 2 == 0 ? squared.push_back(e.left()) : add(e.left(), depth + 1);
        } else {
            rest = written_product(rest, e);
        }
    }

    bool has_powers_ = false;
};

}  // namespace

expression step_collector::if_nonzero(const std::vector<expression>& all, const expression& a, const expression& b) {
    expression value = a;
    for (const expression& each : all) {
        value = if_not_negative(each, if_positive(each, value, b), value);
    }
    return value;
}

expression step_collector::if_positive(const expression& u, const expression& a, const expression& b) {
    const signed_factors factors(u);
    if (!factors.squared.empty()) {
        return if_nonzero(factors.squared, if_positive(factors.rest, a, b), b);
    }
    const oriented_sign found = step_of(factors.rest);
    // [-u > 0] = 1 - [u >= 0].
    const expression holds = found.orientation > 0 ? parameter(name_of_positive(found.parameter))
                                                   : 1 - parameter(name_of_nonnegative(found.parameter));
    return choice_between(holds, a, b);
}

expression step_collector::if_not_negative(const expression& u, const expression& a, const expression& b) {
    const signed_factors factors(u);
    if (!factors.squared.empty()) {
        return if_nonzero(factors.squared, if_not_negative(factors.rest, a, b), a);
    }
    const oriented_sign found = step_of(factors.rest);
    const expression holds = found.orientation > 0 ? parameter(name_of_nonnegative(found.parameter))
                                                   : 1 - parameter(name_of_positive(found.parameter));
    return choice_between(holds, a, b);
}

expression step_collector::sign(const expression& u) {
    const signed_factors factors(u);
    if (!factors.squared.empty()) {
        return if_nonzero(factors.squared, sign(factors.rest), 0);
    }
    const oriented_sign found = step_of(factors.rest);
    return found.orientation * parameter(found.parameter);
}

// One parameter for arguments that are equal up to a constant factor.
step_collector::oriented_sign step_collector::step_of(const expression& u) {
    for (const step_function& each : steps_) {
        const int relative = each.kind == step_kind::sign ? relative_sign(each.argument, u) : 0;
        if (relative != 0) {
            return {each.parameter, relative};
        }
    }
    // Of h <= 0 the argument is h, too.
    const bool opposite = u.kind() == node_kind::product && u.left().is(-1);
    return {added({.kind = step_kind::sign, .argument = opposite ? u.right() : u, .text = text_, .at = at_}),
            opposite ? -1 : 1};
}

expression step_collector::floor(const expression& u, const number& divisor) {
    for (const step_function& each : steps_) {
        if (each.kind == step_kind::floor && same_form(each.argument, u) && same_form(each.divisor, divisor)) {
            return parameter(each.parameter);
        }
    }
    return parameter(added({.kind = step_kind::floor, .argument = u, .divisor = divisor, .text = text_, .at = at_}));
}

const std::string& step_collector::added(step_function made) {
    made.parameter = "step " + std::to_string(steps_.size() + 1);
    steps_.push_back(std::move(made));
    return steps_.back().parameter;
}

}  // namespace libration::ode
