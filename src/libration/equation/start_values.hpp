// Exact values of expressions at an initial point.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "libration/equation/explicit_system.hpp"
#include "libration/equation/node_values.hpp"

namespace libration::ode {

/// The value of a leaf at the initial point: the variable or an unknown; std::nullopt if it has no value there.
using leaf_value = std::function<std::optional<number>(const expression& leaf)>;

/// Evaluates expressions at an initial point and rejects those that are not analytic there.
class start_values {
public:
    explicit start_values(leaf_value of_leaf) : of_leaf_(std::move(of_leaf)) {}

    /// The reason why the expression is not analytic at the initial point ("takes the root of 0"); std::nullopt if it
    /// is.
    std::optional<std::string> refusal_of(const expression& e);

    /// The value of an expression that is analytic there. Throws error for any other expression.
    number value_of(const expression& e);

private:
    number computed(const expression& e) const;
    number of_leaf(const expression& leaf) const;
    number of_operation(const expression& e) const;
    static void require_analytic(const expression& e, const number& argument);

    leaf_value of_leaf_;
    node_values<number, same_expression> done_;
};

/// The values of t, s = 0 and the unknowns at the initial point of a system, which must outlive the result.
leaf_value leaves_at_start(const explicit_system& of);

/// Two initial values of the same unknown or derivative, `of`: names the places of the first two.
[[noreturn]] void refuse_second_start(const equation_system& given, const expression& of);

}  // namespace libration::ode
