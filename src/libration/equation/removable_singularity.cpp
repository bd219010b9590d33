#include "removable_singularity.hpp"

#include <algorithm>
#include <iterator>
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
constexpr std::ptrdiff_t most_divided_summands = 8;

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

// Two functions of u with a common zero, divided by u - u0 as often as both vanish there; std::nullopt if they do not. A
// pole remains if the divisor has the zero of higher order.
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
            return changed && numerator && numerator->sign() != 0 ? std::optional(std::pair(above, below))
                                                                  : std::nullopt;
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

// The divisors from which zeros are removed, as they were.
std::vector<expression> remove_all(factored_quotient& of) {
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
    return removed;
}

// The quotient instead of e, from which it was made.
expression replacing(const expression& e, const factored_quotient& of, const std::vector<expression>& removed) {
    expression result = written_quotient(product_of_all(of.above), product_of_all(of.below));
    for (const expression& part : parts_lost({e}, {}, {result})) {
        result = result + zero_of_lost(part, removed);
    }
    return result;
}

expression without_singularities(const expression& e) {
    factored_quotient of;
    read_factors(of, e, false, 0);
    const auto removed = remove_all(of);
    return removed.empty() ? e : replacing(e, of, removed);
}

bool is_zero_at(function_of_one& functions, const std::vector<expression>& divisors, const number& u0) {
    return std::ranges::any_of(divisors, [&](const expression& each) {
        const auto value = functions.holds(each) ? functions.value(each, u0) : std::nullopt;
        return value && is_proved_zero(*value);
    });
}

// A number at which divisors of both are 0, as functions of one u.
std::optional<std::pair<linear_sum, number>> common_zero(const factored_quotient& a, const factored_quotient& b) {
    for (const expression& divisor : a.below) {
        for (const linear_sum& u : directions_of(divisor)) {
            function_of_one functions(u);
            for (const number& u0 : candidates({&divisor}, u)) {
                try {
                    if (is_zero_at(functions, {divisor}, u0) && is_zero_at(functions, b.below, u0)) {
                        return std::pair(u, u0);
                    }
                } catch (const error&) {
                    // No value there: another candidate.
                }
            }
        }
    }
    return std::nullopt;
}

// a + b over one divisor, without the singularity that both have at one place; std::nullopt if it is not removed.
std::optional<expression> without_common_singularity(const expression& a, const expression& b) {
    factored_quotient first;
    factored_quotient second;
    read_factors(first, a, false, 0);
    read_factors(second, b, false, 0);
    const auto zero = common_zero(first, second);
    if (!zero) {
        return std::nullopt;
    }
    factored_quotient both{{}, first.below};
    std::vector<expression> only_first = first.below;
    std::vector<expression> above_first = first.above;
    for (const expression& each : second.below) {
        const auto same =
            std::ranges::find_if(only_first, [&](const expression& other) { return same_form(each, other); });
        if (same != only_first.end()) {
            only_first.erase(same);
        } else {
            both.below.push_back(each);
            above_first.push_back(each);
        }
    }
    std::vector<expression> above_second = second.above;
    std::ranges::copy(only_first, std::back_inserter(above_second));
    both.above = {written_sum(product_of_all(above_first), product_of_all(above_second))};
    const auto removed = remove_all(both);
    function_of_one functions(zero->first);
    const bool regular = !removed.empty() && !is_zero_at(functions, both.below, zero->second);
    return regular ? std::optional(replacing(a + b, both, removed)) : std::nullopt;
}

void read_summands(std::vector<expression>& to, const expression& e, int depth) {
    if (e.kind() == node_kind::sum && depth < deepest_factor) {
        read_summands(to, e.left(), depth + 1);
        read_summands(to, e.right(), depth + 1);
    } else {
        to.push_back(e);
    }
}

// A sum of quotients, each of which is singular where the sum is not: coth(x) - 1/x.
expression sum_without_singularities(const expression& e) {
    std::vector<expression> summands;
    read_summands(summands, e, 0);
    const auto divided = [](const expression& each) {
        factored_quotient of;
        read_factors(of, each, false, 0);
        return std::ranges::any_of(of.below,
                                   [](const expression& divisor) { return divisor.kind() != node_kind::constant; });
    };
    if (std::ranges::count_if(summands, divided) > most_divided_summands) {
        return e;
    }
    bool changed = false;
    for (std::size_t i = 0; i < summands.size(); ++i) {
        for (std::size_t j = i + 1; j < summands.size() && divided(summands[i]);) {
            const auto made =
                divided(summands[j]) ? without_common_singularity(summands[i], summands[j]) : std::nullopt;
            if (made) {
                summands[i] = *made;
                summands.erase(summands.begin() + static_cast<std::ptrdiff_t>(j));
                changed = true;
            } else {
                ++j;
            }
        }
    }
    if (!changed) {
        return e;
    }
    expression sum;
    for (const expression& each : summands) {
        sum = written_sum(sum, each);
    }
    return sum;
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
        expression made = with_operands(node, done, {});
        if (node.kind() == node_kind::sum && !node.is_unfolded_zero()) {
            expression removed = sum_without_singularities(made);
            changed = changed || removed.identity() != made.identity();
            return removed;
        }
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
