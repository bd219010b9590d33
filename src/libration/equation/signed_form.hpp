// Signs taken out of differences, for products and powers in the polynomial form.
#pragma once

#include <string>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// An expression in leaves, with a - b and b - a in one form, so that what differs by the sign alone is computed once; changing
/// a sign rounds nothing.
struct signed_form {
    expression size;
    bool negative = false;

    expression value() const { return negative ? -size : size; }
};

inline bool is_minus_leaf(const expression& e) {
    return e.kind() == node_kind::product && e.left().is(-1) && e.right().kind() == node_kind::unknown;
}

/// The leaves are y0, y1, ..: the difference begins with the first one.
inline signed_form without_sign(const expression& e) {
    if (e.kind() == node_kind::product && e.left().is(-1)) {
        return {e.right(), true};
    }
    const bool is_difference =
        e.kind() == node_kind::sum && e.left().kind() == node_kind::unknown && is_minus_leaf(e.right());
    if (!is_difference) {
        return {e};
    }
    const std::string& first = e.left().name();
    const std::string& second = e.right().right().name();
    const bool ordered = first.size() < second.size() || (first.size() == second.size() && first < second);
    return ordered ? signed_form{e} : signed_form{e.right().right() - e.left(), true};
}

inline expression signed_product(const expression& a, const expression& b) {
    const signed_form left = without_sign(a);
    const signed_form right = without_sign(b);
    return signed_form{left.size * right.size, left.negative != right.negative}.value();
}

inline expression signed_power(const expression& u, const expression& exponent, int n) {
    const signed_form base = without_sign(u);
    return signed_form{pow(base.size, exponent), base.negative && n % 2 != 0}.value();
}

}  // namespace libration::ode
