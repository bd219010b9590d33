// Values with derivatives that are part of the state.
#pragma once

#include <algorithm>

#include "libration/equation/hybrid_system.hpp"

namespace libration::ode {

/// Whether an expression contains a leaf of which the state has a derivative with respect to a number: nearby solutions
/// have other values of it.
inline bool is_varied(const hybrid_system& system, const expression& e) {
    bool varied = false;
    each_leaf(e, [&](const expression& leaf) {
        for (std::size_t k = 0; k < system.leaves().size(); ++k) {
            varied = varied || (same_form(leaf, system.leaves()[k]) &&
                                std::ranges::any_of(system.variations(),
                                                    [&](const state_variation& each) { return each[k].has_value(); }));
        }
    });
    return varied;
}

}  // namespace libration::ode
