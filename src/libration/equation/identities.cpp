#include "libration/equation/identities.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

constexpr std::size_t most_terms = 4000;
constexpr int largest_power = 32;

// The exponents of the indeterminates, by their indices.
using monomial = std::map<std::size_t, int>;
using polynomial = std::map<monomial, number>;

// Expressions as polynomials in leaves and other subexpressions, equal forms being one indeterminate.
class expander {
public:
    // std::nullopt for more than most_terms terms.
    std::optional<polynomial> expanded(const expression& e) {
        switch (e.kind()) {
            case node_kind::constant: return of_constant(e.constant());
            case node_kind::sum: return sum_of(e);
            case node_kind::product: return product(expanded(e.left()), expanded(e.right()));
            case node_kind::quotient: return product(expanded(e.left()), indeterminate(1 / e.right()));
            case node_kind::power: return power_of(e);
            case node_kind::variable:
            case node_kind::unknown:
            case node_kind::parameter:
            case node_kind::function: break;
        }
        return indeterminate(e);
    }

private:
    static polynomial of_constant(const number& value) {
        return is_exactly_zero(value) ? polynomial() : polynomial{{monomial(), value}};
    }

    // False also if it is not decided.
    static bool is_exactly_zero(const number& value) {
        try {
            return value.sign() == 0;
        } catch (const error&) {
            return false;
        }
    }

    polynomial indeterminate(const expression& e) {
        auto found = std::ranges::find_if(known_, [&](const expression& each) { return same_form(each, e); });
        if (found == known_.end()) {
            known_.push_back(e);
            found = known_.end() - 1;
        }
        return {{{{static_cast<std::size_t>(found - known_.begin()), 1}}, number(rational(1))}};
    }

    static void add(polynomial& to, const monomial& of, const number& coefficient) {
        const auto [place, is_new] = to.emplace(of, coefficient);
        if (is_new) {
            return;
        }
        place->second = place->second + coefficient;
        if (is_exactly_zero(place->second)) {
            to.erase(place);
        }
    }

    std::optional<polynomial> sum_of(const expression& e) {
        auto total = expanded(e.left());
        const auto more = total ? expanded(e.right()) : std::nullopt;
        if (!more || total->size() + more->size() > most_terms) {
            return std::nullopt;
        }
        for (const auto& [of, coefficient] : *more) {
            add(*total, of, coefficient);
        }
        return total;
    }

    static std::optional<polynomial> product(const std::optional<polynomial>& a, const std::optional<polynomial>& b) {
        if (!a || !b || a->size() * b->size() > most_terms) {
            return std::nullopt;
        }
        polynomial result;
        for (const auto& [left, of_left] : *a) {
            for (const auto& [right, of_right] : *b) {
                monomial both = left;
                for (const auto& [index, exponent] : right) {
                    both[index] += exponent;
                }
                add(result, both, of_left * of_right);
            }
        }
        return result;
    }

    std::optional<polynomial> power_of(const expression& e) {
        const auto exponent = e.right().fraction();
        if (!exponent || denominator(*exponent) != 1 || *exponent < 0 || *exponent > largest_power) {
            return indeterminate(e);
        }
        const auto base = expanded(e.left());
        std::optional<polynomial> result = of_constant(number(rational(1)));
        for (int k = 0; k < *exponent && result; ++k) {
            result = product(result, base);
        }
        return result;
    }

    std::vector<expression> known_;
};

// Whether e = c u with a constant c.
bool is_multiple(const expression& e, const expression& u) {
    expander both;
    const auto first = both.expanded(e);
    const auto second = both.expanded(u);
    if (!first || !second || second->empty() || !first->contains(second->begin()->first)) {
        return false;
    }
    const number factor = first->at(second->begin()->first) / second->begin()->second;
    return is_identically_zero(e - expression(factor) * u);
}

// The value of a leaf for u = 0.
std::optional<expression> value_for_zero(const expression& u, const expression& leaf) {
    const expression slope = partial(u, leaf);
    if (slope.kind() != node_kind::constant || slope.constant().sign() == 0) {
        return std::nullopt;
    }
    const expression rest = replaced(
        u, [&](const expression& each) { return same_form(each, leaf) ? std::optional(expression()) : std::nullopt; });
    return -rest / slope;
}

}  // namespace

bool is_identically_zero(const expression& e) {
    const auto all = expander().expanded(e);
    return all && all->empty();
}

bool vanishes_with(const expression& e, const expression& u) try {
    if (is_identically_zero(e) || is_multiple(e, u)) {
        return true;
    }
    std::vector<expression> leaves;
    each_leaf(u, [&](const expression& leaf) { leaves.push_back(leaf); });
    return std::ranges::any_of(leaves, [&](const expression& leaf) {
        const auto value = value_for_zero(u, leaf);
        return value && is_identically_zero(replaced(
                            e, [&](const expression& each) { return same_form(each, leaf) ? value : std::nullopt; }));
    });
} catch (const error&) {  // an expression without a value there
    return false;
}

}  // namespace libration::ode
