// Parameters of the computation of a proof, which a second proof of the same statement varies.
#pragma once

#include "libration/expansion/fast_product.hpp"
#include "libration/integration/integrator.hpp"
#include "libration/integration/plane_watch.hpp"
#include "libration/scalar/ball/magnitude.hpp"

namespace libration::ode {

/// The choices that theorems T, S, V, L and C leave open: any order, any step inside the radius, any enclosing product
/// of series. Two routes prove the same statements; what they have in common is listed in docs/proved.md.
struct proof_route {
    /// Added to the order of each Taylor polynomial; it may be negative, for shorter steps.
    int more_terms = 0;
    /// The length of each step in eighths of the one that the integrator chooses, 1 .. 8.
    unsigned long step_eighths = 8;
    /// The product of long series; null: term by term, quotients by their recurrence.
    const series::block_product<ball>* product = fast_product<ball>();
    integrator_choice integrator = integrator_choice::automatic;
    /// Called for each disc of a path in the complex plane.
    plane_watch watch = {};
    /// Whether linear systems with constant coefficients are solved by the exponential of their matrix.
    bool matrix_exponential = true;
    /// Whether theorem G may be chosen for many unknowns.
    bool comparison = true;

    /// The route of --check: five more terms, steps of seven eighths, series term by term, no matrix exponential.
    static proof_route second() { return {5, 7, nullptr, integrator_choice::automatic, {}, false}; }

    /// That fraction of a length, rounded; the length itself if it is not shortened.
    magnitude shortened(const magnitude& length) const {
        return step_eighths == 8 ? length : length * magnitude::of(step_eighths, -3);
    }
};

/// Number of additional digits of the second proof, so that its precision differs in every step.
inline constexpr long more_digits_of_second_proof = 7;

}  // namespace libration::ode
