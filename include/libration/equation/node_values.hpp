// Traversal of expressions of any depth: an explicit stack instead of recursion; each node is visited once, however
// often it is shared.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "libration/equation/expression.hpp"

namespace libration::ode {

/// At most two expressions; null pointers if there are fewer.
using operand_pair = std::array<const expression*, 2>;

/// The operands of a node: none for a constant or a leaf, the argument for a function, otherwise left and right.
inline operand_pair operands_of(const expression& e) {
    switch (e.kind()) {
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter: return {};
        case node_kind::function: return {&e.left()};
        case node_kind::sum:
        case node_kind::product:
        case node_kind::quotient:
        case node_kind::power: break;
    }
    return {&e.left(), &e.right()};
}

/// Nodes are the same if they are copies of one object.
struct same_object {
    struct hash {
        std::size_t operator()(const expression& e) const { return std::hash<const void*>()(e.identity()); }
    };
    struct equal {
        bool operator()(const expression& a, const expression& b) const { return a.identity() == b.identity(); }
    };
};
/// Nodes are the same if same_form() returns true.
struct same_expression {
    struct hash {
        std::size_t operator()(const expression& e) const { return e.hash(); }
    };
    struct equal {
        bool operator()(const expression& a, const expression& b) const {
            return a.identity() == b.identity() || same_form(a, b);
        }
    };
};

/// Values of the nodes of expressions, computed once for nodes that are the same; the nodes are kept alive, so that
/// their identities remain unique. Memory: one entry per node.
template <class Value, class Same = same_object>
class node_values {
public:
    /// The value of e. `compute(node)` is called for each node below e that has no value yet, after its operands, the
    /// left one first, and reads their values by at(), or by another call of of() that returns them without further
    /// depth. `operands(node)` are the subexpressions of a node whose values `compute` reads. Exceptions of `compute`
    /// propagate; values already computed are kept. References remain valid.
    template <class Compute, class Operands>
    const Value& of(const expression& e, const Compute& compute, const Operands& operands) {
        if (const Value* const known = find(e)) {
            return *known;
        }
        std::vector<std::pair<const expression*, bool>> open{{&e, false}};
        while (!open.empty()) {
            const auto [node, has_operands] = open.back();
            if (has_operands || find(*node) != nullptr) {
                open.pop_back();
                if (has_operands) {
                    done_.emplace(*node, compute(*node));
                }
                continue;
            }
            open.back().second = true;
            const operand_pair below = operands(*node);
            for (std::size_t k = below.size(); k-- > 0;) {
                if (below[k] != nullptr) {
                    open.emplace_back(below[k], false);
                }
            }
        }
        return at(e);
    }
    template <class Compute>
    const Value& of(const expression& e, const Compute& compute) {
        return of(e, compute, operands_of);
    }

    /// The value of an expression that has been computed.
    const Value& at(const expression& e) const { return done_.at(e); }

private:
    const Value* find(const expression& e) const {
        const auto found = done_.find(e);
        return found == done_.end() ? nullptr : &found->second;
    }

    std::unordered_map<expression, Value, typename Same::hash, typename Same::equal> done_;
};

/// The node with the values of its operands in their place, and with nodes of the order of a function replaced.
expression with_operands(const expression& e, const node_values<expression>& done, const replacement& by);

}  // namespace libration::ode
