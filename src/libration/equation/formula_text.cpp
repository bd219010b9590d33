#include "formula_text.hpp"

#include "bound_text.hpp"
#include "libration/equation/node_values.hpp"

namespace libration::ode {

namespace {

formula_part text_of_sum(const formula_part& a, const formula_part& b) {
    const bool minus = b.text.starts_with('-');
    return {a.text + (minus ? " - " + b.text.substr(1) : " + " + b.text), binding::sum};
}

formula_part text_of_product(const expression& e, const formula_part& a, const formula_part& b) {
    const std::string right = b.within(binding::product);
    if (e.left().is(-1)) {
        return {"-" + right, binding::sum};
    }
    const bool negative = e.left().kind() == node_kind::constant && a.text.starts_with('-');
    return {(negative ? a.text : a.within(binding::product)) + "*" + right, negative ? binding::sum : binding::product};
}

formula_part text_of_constant_number(const number& value) {
    if (const auto q = value.fraction()) {
        return text_of_fraction(*q);
    }
    const std::string text = text_of_time(value);
    return {text, text.starts_with('-') ? binding::sum : binding::operand};
}

}  // namespace

formula_part text_of_fraction(const rational& q) {
    return {q.str(), q < 0 ? binding::sum : denominator(q) == 1 ? binding::operand : binding::product};
}

formula_part text_of_arithmetic(const expression& e, const formula_part& left, const formula_part& right) {
    if (e.kind() == node_kind::sum) {
        return text_of_sum(left, right);
    }
    return e.kind() == node_kind::product
               ? text_of_product(e, left, right)
               : formula_part{left.within(binding::product) + "/" + right.within(binding::power), binding::product};
}

formula_part text_of_power(const formula_part& base, const formula_part& exponent) {
    return {base.within(binding::operand) + "^" + exponent.within(binding::operand), binding::power};
}

std::string formula_text(const expression& e, const std::string& variable,
                         const std::map<std::string, std::string>& names) {
    node_values<formula_part> done;
    const auto part = [&](const expression& each) -> formula_part {
        switch (each.kind()) {
            case node_kind::constant: return text_of_constant_number(each.constant());
            case node_kind::variable: return {variable};
            case node_kind::unknown:
            case node_kind::parameter: {
                const auto found = names.find(each.name());
                return {found == names.end() ? each.name() : found->second};
            }
            case node_kind::sum:
            case node_kind::product:
            case node_kind::quotient: return text_of_arithmetic(each, done.at(each.left()), done.at(each.right()));
            case node_kind::power: return text_of_power(done.at(each.left()), done.at(each.right()));
            case node_kind::function: break;
        }
        const std::string order = each.has_order() ? done.at(each.right()).text + ", " : "";
        return {std::string(name_of(each.function())) + "(" + order + done.at(each.left()).text + ")"};
    };
    // The order is written, too.
    const auto written = [](const expression& each) {
        return each.has_order() ? operand_pair{&each.right(), &each.left()} : operands_of(each);
    };
    return done.of(e, part, written).text;
}

}  // namespace libration::ode
