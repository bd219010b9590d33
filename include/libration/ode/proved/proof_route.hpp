// How a proof is computed: what a second proof of the same statement does differently.
#pragma once

#include "libration/ode/ball/fast_product.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// Which integrator takes the steps to a time.
enum class integrator_choice {
    automatic,   ///< collocation where the steps of Taylor series are far shorter than the solution's scale
    taylor,      ///< Taylor series alone (theorem V)
    collocation  ///< collocation (theorem K) from the start on; Taylor series where that is not possible
};

/// The freedom that theorems T, S, V, L and C leave: any order, any step inside the radius, any enclosing product of
/// series. Two routes prove the same statements; what they share is in docs/proved.md.
struct proof_route {
    /// Added to the order of each Taylor polynomial, >= 0.
    int more_terms = 0;
    /// The length of each step in eighths of the one that the integrator chooses, 1 .. 8.
    unsigned long step_eighths = 8;
    /// The product of long series; null: term by term, quotients by their recurrence.
    const series::block_product<ball>* product = fast_product<ball>();
    integrator_choice integrator = integrator_choice::automatic;

    /// The route of --check: five more terms, steps of seven eighths, series term by term.
    static proof_route second() { return {5, 7, nullptr}; }

    /// That part of a length, rounded: the length itself where it is not shortened.
    magnitude shortened(const magnitude& length) const {
        return step_eighths == 8 ? length : length * magnitude::of(step_eighths, -3);
    }
};

/// The second proof is asked for so many more digits, and has other bits in every step.
inline constexpr long more_digits_of_second_proof = 7;

}  // namespace libration::ode
