#include "small_divisor.hpp"

#include <map>
#include <optional>
#include <utility>

#include "../equation/formula_text.hpp"
#include "libration/equation/first_order_form.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/ball/decimal.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

namespace {

// At which the node, or a derivative of it, has no value if it is 0.
std::optional<expression> divisor_of(const expression& e) {
    switch (e.kind()) {
        case node_kind::quotient: return e.right();
        case node_kind::power: {
            const auto exponent = e.right().fraction();
            const bool whole = exponent && denominator(*exponent) == 1 && *exponent > 0;
            return whole ? std::nullopt : std::optional(e.left());
        }
        case node_kind::function: {
            const bool has_end = e.function() == function_kind::log || e.function() == function_kind::sqrt;
            return has_end ? std::optional(e.left()) : std::nullopt;
        }
        case node_kind::constant:
        case node_kind::variable:
        case node_kind::unknown:
        case node_kind::parameter:
        case node_kind::sum:
        case node_kind::product: break;
    }
    return std::nullopt;
}

// x of a divisor x^n, sqrt(x).
expression base_of(expression e) {
    while (e.kind() == node_kind::power || (e.kind() == node_kind::function && e.function() == function_kind::sqrt)) {
        e = expression(e.left());
    }
    return e;
}

// The first quotient with this divisor, if the numerators of all of them are about 0 there, too: at most 2^20 in size.
std::optional<expression> quotient_of_zeros(const std::vector<expression>& slopes, const expression& base,
                                            expression_values<ball>& values) {
    constexpr long largest = 20;
    std::optional<expression> found;
    bool pole = false;
    node_values<bool> seen;
    for (const expression& slope : slopes) {
        seen.of(slope, [&](const expression& e) {
            if (e.kind() == node_kind::quotient && same_form(base_of(e.right()), base)) {
                const ball above = values.of(e.left());
                const ball below = values.of(e.right());
                pole = pole || !is_finite(above) || magnitude(below).shifted(largest) < magnitude(above);
                found = found.value_or(e);
            }
            return true;
        });
    }
    return pole ? std::nullopt : found;
}

}  // namespace

bool has_no_value_below_zero(const expression& e) {
    const auto exponent = e.kind() == node_kind::power ? e.right().fraction() : std::nullopt;
    return (exponent && denominator(*exponent) != 1 && *exponent > 0) ||
           (e.kind() == node_kind::function && e.function() == function_kind::sqrt);
}

std::string small_divisor_text(const explicit_system& system, const ball& time, const std::vector<ball>& state) {
    constexpr std::size_t longest = 60;
    const first_order_form form(system);
    expression_values<ball> values(form.leaves, time);
    for (const ball& each : state) {
        values.push_back(each);
    }
    std::optional<std::pair<magnitude, expression>> smallest;
    bool ends = false;
    node_values<bool> seen;
    for (const expression& slope : form.slopes) {
        seen.of(slope, [&](const expression& e) {
            if (const auto divisor = divisor_of(e); divisor && divisor->kind() != node_kind::constant) {
                const expression base = base_of(*divisor);
                const ball value = values.of(base);
                if (is_finite(value) && (!smallest || magnitude(value) < smallest->first)) {
                    smallest = {magnitude(value), base};
                    ends = has_no_value_below_zero(e);
                } else if (smallest && !has_no_value_below_zero(e) && same_form(base, smallest->second)) {
                    ends = false;  // it divides, too
                }
            }
            return true;
        });
    }
    if (!smallest || !(smallest->first < magnitude(1U).shifted(-10))) {
        return "";
    }
    std::map<std::string, std::string> names;
    const auto of_state = names_of_state(system);
    for (std::size_t k = 0; k < form.leaves.size(); ++k) {
        names.emplace(form.leaves[k].name(), of_state[k]);
    }
    const std::string text = formula_text(smallest->second, system.variable(), names);
    if (text.size() > longest) {
        return "";
    }
    std::string of_zeros;
    if (const auto quotient = quotient_of_zeros(form.slopes, smallest->second, values)) {
        const std::string name = formula_text(*quotient, system.variable(), names);
        of_zeros = name.size() > longest ? ""
                                         : ", and the numerator of " + name + " is as small" +
                                               ": solutions cross only common zeros of elementary functions of one "
                                               "expression, as of sin(x)/x; write it without the common zero";
    }
    return "there |" + text + "| <= " + upper_bound_text(values.of(smallest->second)) + of_zeros +
           (ends ? ", of which a root has no real value below 0: if it remains 0, as of an empty store, write "
                   "if(" +
                       text + " > 0, .., 0) with the terms that end there"
                 : "");
}

}  // namespace libration::ode
