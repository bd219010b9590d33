// Values of expressions at a start, exactly.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "libration/ode/explicit_system.hpp"
#include "libration/ode/node_values.hpp"

namespace libration::ode {

/// What a leaf is at the start: the variable or an unknown; nothing for what has no value there.
using leaf_value = std::function<std::optional<number>(const expression& leaf)>;

/// Evaluates expressions at a start and refuses what is not analytic there.
class start_values {
public:
    explicit start_values(leaf_value of_leaf) : of_leaf_(std::move(of_leaf)) {}

    /// Why the expression is not analytic at the start ("takes the root of 0"); nothing where it is.
    std::optional<std::string> refusal_of(const expression& e);

    /// The value of an expression that is analytic there. Throws error for any other.
    number value_of(const expression& e);

private:
    number computed(const expression& e) const;
    number of_leaf(const expression& leaf) const;
    number of_operation(const expression& e) const;
    static void require_analytic(const expression& e, const number& argument);

    leaf_value of_leaf_;
    node_values<number, same_expression> done_;
};

/// The values that the starts of a system give to t, s = 0 and the unknowns; the system has to outlive them.
leaf_value leaves_at_start(const explicit_system& of);

}  // namespace libration::ode
