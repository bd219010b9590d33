#include "exact_zeros.hpp"

#include <optional>

#include "../equation/bound_text.hpp"
#include "../equation/divided_difference.hpp"
#include "libration/equation/identities.hpp"
#include "libration/scalar/ball/predicates.hpp"
#include "libration/scalar/error.hpp"

namespace libration::ode {

namespace {

// The constant factors of two leaves in a slope that is a sum of both; std::nullopt if it is not.
std::optional<std::pair<number, number>> factors_of(const expression& slope, const expression& a, const expression& b) {
    const expression by_a = partial(slope, a);
    const expression by_b = partial(slope, b);
    if (by_a.kind() != node_kind::constant || by_b.kind() != node_kind::constant ||
        !is_identically_zero(slope - by_a * a - by_b * b)) {
        return std::nullopt;
    }
    return std::pair(by_a.constant(), by_b.constant());
}

// The other leaf in a slope, if there is exactly one, and the variable does not occur.
std::optional<std::size_t> partner_of(std::size_t k, const first_order_form& form) {
    std::optional<std::size_t> other;
    bool one = true;
    each_leaf(form.slopes[k], [&](const expression& leaf) {
        std::size_t j = 0;
        while (j < form.leaves.size() && !same_form(form.leaves[j], leaf)) {
            ++j;
        }
        one = one && j < form.leaves.size() && (j == k || !other || *other == j);
        other = j == k ? other : j;
    });
    return one ? other : std::nullopt;
}

}  // namespace

exact_zeros::exact_zeros(const explicit_system& of) : point_(of.point()) {
    if (of.singular()) {
        return;
    }
    const first_order_form form(of);
    for (std::size_t k = 0; k < form.leaves.size() && k < form.starts.size(); ++k) {
        const auto j = partner_of(k, form);
        const auto own = j ? factors_of(form.slopes[k], form.leaves[k], form.leaves[*j]) : std::nullopt;
        const auto others = own ? factors_of(form.slopes[*j], form.leaves[k], form.leaves[*j]) : std::nullopt;
        if (others && is_proved_zero(own->first + others->second)) {
            const number square = -(own->first * own->first) - own->second * others->first;
            known_.emplace(
                k, oscillation{form.starts[k], own->first * form.starts[k] + own->second * form.starts[*j], square});
        }
    }
}

bool exact_zeros::is_zero(std::size_t k, const number& time) const try {
    const oscillation& of = known_.at(k);
    if (of.square.sign() <= 0) {
        return false;
    }
    const number rate = apply(function_kind::sqrt, of.square);
    const number turned = rate * (time - point_);
    return is_proved_zero(of.start * apply(function_kind::cos, turned) +
                          of.slope / rate * apply(function_kind::sin, turned));
} catch (const error&) {  // not decided
    return false;
}

void exact_zeros::put(std::vector<ball>& state, const number& time, const std::vector<bool>& trusted) {
    for (const auto& [k, of] : known_) {
        if (k >= state.size() || (!trusted.empty() && !trusted[k]) || !is_finite(state[k]) || is_exact(state[k]) ||
            !contains_zero(state[k])) {
            continue;
        }
        const auto [place, is_new] = decided_.emplace(std::pair(k, text_of_time(time)), false);
        if (is_new) {
            place->second = is_zero(k, time);
        }
        if (place->second) {
            state[k] = ball(0);
        }
    }
}

}  // namespace libration::ode
