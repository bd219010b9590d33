#include "libration/equation/choice.hpp"

#include <map>
#include <utility>

#include "libration/equation/defined_zero.hpp"
#include "libration/equation/equation_system.hpp"

namespace libration::ode {

namespace {

bool is_indicator_leaf(const expression& e) { return e.kind() == node_kind::parameter && is_indicator(e.name()); }

class parameter_writer {
public:
    parameter_writer(const parameter_value& value, bool all_defined) : value_(value), all_defined_(all_defined) {}

    expression written(const expression& e) {
        if (!e.has_parameters()) {
            return e;
        }
        const auto known = done_.find(e.identity());
        return known != done_.end() ? known->second.second
                                    : done_.emplace(e.identity(), std::pair(e, made(e))).first->second.second;
    }

private:
    // The products of choices are replaced by separate parameters, so that nothing else loses its factors.
    expression made(const expression& e) {
        std::map<std::string, expression> chosen;
        const expression open = with_nodes_replaced(e, [&](const expression& node) -> std::optional<expression> {
            const auto holds = node.kind() == node_kind::product ? value_of_indicator(node.left()) : std::nullopt;
            if (!holds) {
                return std::nullopt;
            }
            const std::string name = "chosen " + std::to_string(chosen.size());
            chosen.emplace(name, *holds         ? written(node.right())
                                 : all_defined_ ? zero_where_defined(written(node.right()))
                                                : expression());
            return parameter(name);
        });
        return replaced_as_written(open, [&](const expression& leaf) -> std::optional<expression> {
            if (leaf.kind() != node_kind::parameter) {
                return std::nullopt;
            }
            const auto found = chosen.find(leaf.name());
            return found != chosen.end() ? std::optional(found->second) : value_(leaf.name());
        });
    }

    // Of [u > 0] or [u >= 0], or of 1 minus such a value.
    std::optional<bool> value_of_indicator(const expression& e) const {
        if (is_indicator_leaf(e)) {
            const auto value = value_(e.name());
            return value && value->kind() == node_kind::constant ? std::optional(!value->is(0)) : std::nullopt;
        }
        const bool opposite = e.kind() == node_kind::sum && e.right().is(1) && e.left().kind() == node_kind::product &&
                              e.left().left().is(-1);
        const auto holds = opposite ? value_of_indicator(e.left().right()) : std::nullopt;
        return holds ? std::optional(!*holds) : std::nullopt;
    }

    const parameter_value& value_;
    bool all_defined_;
    std::map<const void*, std::pair<expression, expression>> done_;
};

}  // namespace

expression choice_between(const expression& holds, const expression& a, const expression& b) {
    return holds * a + (1 - holds) * b + unfolded_zero(holds);
}

expression with_parameters(const expression& e, const parameter_value& value, bool all_defined) {
    return parameter_writer(value, all_defined).written(e);
}

}  // namespace libration::ode
