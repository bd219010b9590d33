#include "removable_singularity.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "divided_difference.hpp"
#include "libration/equation/defined_zero.hpp"
#include "libration/equation/node_values.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr int most_zeros_removed = 8;
constexpr int deepest_factor = 16;
constexpr std::size_t most_factors = 64;
constexpr std::size_t most_directions = 8;
constexpr int most_searched_nodes = 300;

// A product of factors over divisors.
struct factored_quotient {
    std::vector<expression> above;
    std::vector<expression> below;
};

// The factors of products, quotients and whole powers, down to a depth.
void read_factors(factored_quotient& to, const expression& e, bool inverse, int depth) {
    auto& list = inverse ? to.below : to.above;
    if (depth < deepest_factor && to.above.size() + to.below.size() < most_factors && !e.is_unfolded_zero()) {
        if (e.kind() == node_kind::product || e.kind() == node_kind::quotient) {
            read_factors(to, e.left(), inverse, depth + 1);
            read_factors(to, e.right(), inverse != (e.kind() == node_kind::quotient), depth + 1);
            return;
        }
        const auto r = e.kind() == node_kind::power ? e.right().fraction() : std::nullopt;
        if (r && *r < 0) {
            (inverse ? to.above : to.below).push_back(pow(e.left(), expression(rational(-*r))));
            return;
        }
    }
    list.push_back(e);
}

expression product_of_all(const std::vector<expression>& factors) {
    expression product = 1;
    for (const expression& each : factors) {
        product = written_product(product, each);
    }
    return product;
}

// Calls seen(e) for the arguments of functions, the bases of powers and the leaves of an expression.
template <class Seen>
void each_inner(const expression& e, int& left, const Seen& seen) {
    if (--left < 0) {
        return;
    }
    if (e.kind() == node_kind::function || e.kind() == node_kind::power) {
        seen(e.left());
    }
    const operand_pair below = operands_of(e);
    if (below[0] == nullptr && e.kind() != node_kind::constant) {
        seen(e);
    }
    for (const expression* each : below) {
        if (each != nullptr) {
            each_inner(*each, left, seen);
        }
    }
}

// The expressions u, up to a factor and a summand, of which e may be a function.
std::vector<linear_sum> directions_of(const expression& e) {
    std::vector<linear_sum> found;
    int left = most_searched_nodes;
    const auto add = [&](const expression& inner) {
        auto form = linear_sum_of(inner);
        if (!form || form->terms.empty() || found.size() >= most_directions) {
            return;
        }
        const bool known = std::ranges::any_of(
            found, [&](const linear_sum& each) { return function_of_one(each).affine(inner).has_value(); });
        if (!known) {
            form->constant = number();
            found.push_back(*std::move(form));
        }
    };
    add(e);
    each_inner(e, left, add);
    return found;
}

// Numbers u0 that may be zeros.
std::vector<number> candidates(const std::vector<const expression*>& among, const linear_sum& u) {
    std::vector<number> all;
    const auto add = [&](const expression& inner) {
        const auto form = function_of_one(u).affine(inner);
        if (!form || is_proved_zero(form->first)) {
            return;
        }
        for (const number& special :
             {number(), number(rational(1)), number(rational(-1)), number(rational(1), unit::pi),
              number(rational(-1), unit::pi), number(rational(1, 2), unit::pi), number(rational(-1, 2), unit::pi)}) {
            all.push_back((special - form->second) / form->first);
        }
    };
    for (const expression* each : among) {
        int left = most_searched_nodes;
        add(*each);
        each_inner(*each, left, add);
    }
    return all;
}

// Two functions of u with a common zero, divided by u - u0 as often as both vanish there; std::nullopt if the divisor
// is nonzero at u0, or has a zero of higher order.
std::optional<std::pair<expression, expression>> divided_pair(expression above, expression below, const linear_sum& u,
                                                              const number& u0) {
    function_of_one of(u);
    bool changed = false;
    for (int i = 0; i < most_zeros_removed; ++i) {
        const auto divisor = of.value(below, u0);
        if (!divisor) {
            return std::nullopt;
        }
        if (!is_proved_zero(*divisor)) {
            return changed && divisor->sign() != 0 ? std::optional(std::pair(above, below)) : std::nullopt;
        }
        const auto numerator = of.value(above, u0);
        if (!numerator || !is_proved_zero(*numerator)) {
            return std::nullopt;
        }
        const auto a = of.difference(above, u0);
        const auto b = a ? of.difference(below, u0) : std::nullopt;
        if (!b) {
            return std::nullopt;
        }
        above = *a;
        below = *b;
        changed = true;
    }
    return std::nullopt;
}

// Whether it contains a function or a root. A common factor that is typed, as in x*(1 - t)/(1 - t), is not removed, nor is
// one that is a function, as in 2*log(t)/log(t).
bool has_function(const expression& e) {
    int left = most_searched_nodes;
    bool found = false;
    const auto search = [&](const auto& self, const expression& node) -> void {
        if (--left < 0 || found) {
            return;
        }
        const auto r = node.kind() == node_kind::power ? node.right().fraction() : std::nullopt;
        found = node.kind() == node_kind::function || (r && denominator(*r) != 1);
        for (const expression* each : operands_of(node)) {
            if (each != nullptr) {
                self(self, *each);
            }
        }
    };
    search(search, e);
    return found;
}

// One divisor with the factors above it that are functions of the same u; false if nothing is removed.
bool remove_one(factored_quotient& of, std::size_t which) {
    const expression divisor = of.below[which];
    for (const linear_sum& u : directions_of(divisor)) {
        function_of_one functions(u);
        if (!functions.holds(divisor)) {
            continue;
        }
        factored_quotient parts;
        for (const expression& each : of.above) {
            (each.kind() != node_kind::constant && functions.holds(each) ? parts.above : parts.below).push_back(each);
        }
        if (parts.above.empty()) {
            continue;
        }
        const expression above = product_of_all(parts.above);
        const auto whole = linear_sum_of(divisor);
        const bool proportional = whole && function_of_one(*whole).affine(above);
        if (proportional || (!has_function(above) && !has_function(divisor))) {
            continue;
        }
        for (const number& u0 : candidates({&above, &divisor}, u)) {
            try {
                if (const auto made = divided_pair(above, divisor, u, u0)) {
                    of.above = parts.below;
                    of.above.push_back(made->first);
                    of.below[which] = made->second;
                    return true;
                }
            } catch (const error&) {
                // No value of one of the two there: another candidate.
            }
        }
    }
    return false;
}

// What a part that the result has lost requires: the reciprocals of divisors from which no root was removed.
expression zero_of_lost(const expression& part, const std::vector<expression>& removed) {
    const auto r = part.kind() == node_kind::power ? part.right().fraction() : std::nullopt;
    if (part.kind() != node_kind::quotient && !(r && *r < 0)) {
        return zero_where_defined(part);
    }
    factored_quotient of;
    read_factors(of, part, false, 0);
    expression zero;
    for (const expression& each : of.below) {
        const bool is_removed =
            std::ranges::any_of(removed, [&](const expression& divisor) { return same_form(each, divisor); });
        if (!is_removed && each.kind() != node_kind::constant) {
            zero = zero + zero_where_defined(1 / each);
        }
    }
    return zero;
}

expression without_singularities(const expression& e) {
    factored_quotient of;
    read_factors(of, e, false, 0);
    std::vector<expression> removed;
    int left = most_zeros_removed;
    for (std::size_t k = 0; k < of.below.size() && left > 0;) {
        const expression divisor = of.below[k];
        if (divisor.kind() != node_kind::constant && remove_one(of, k)) {
            removed.push_back(divisor);
            --left;  // the same divisor may have another zero
        } else {
            ++k;
        }
    }
    if (removed.empty()) {
        return e;
    }
    expression result = written_quotient(product_of_all(of.above), product_of_all(of.below));
    for (const expression& part : parts_lost({e}, {}, {result})) {
        result = result + zero_of_lost(part, removed);
    }
    return result;
}

bool has_divisor(const expression& e) {
    const auto r = e.kind() == node_kind::power ? e.right().fraction() : std::nullopt;
    return e.kind() == node_kind::quotient || (r && *r < 0);
}

}  // namespace

expression with_removed_singularities(const expression& e) {
    // Whether a factor of a node is a divisor, so that products without one are not read.
    node_values<bool> divides;
    bool any = false;
    divides.of(e, [&](const expression& each) {
        any = any || has_divisor(each);
        return has_divisor(each) ||
               (each.kind() == node_kind::product && (divides.at(each.left()) || divides.at(each.right())));
    });
    if (!any) {
        return e;
    }
    node_values<expression> done;
    bool changed = false;
    expression result = done.of(e, [&](const expression& node) {
        const bool product = node.kind() == node_kind::product;
        const expression made = with_operands(node, done, {});
        if (!divides.at(node) || node.is_unfolded_zero() || !(product || has_divisor(node))) {
            return made;
        }
        expression removed = without_singularities(made);
        changed = changed || removed.identity() != made.identity();
        return removed;
    });
    return changed ? result : e;
}

}  // namespace libration::ode
