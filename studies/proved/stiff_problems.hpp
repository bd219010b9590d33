// Stiff problems of the catalogue, and the ends of their intervals in the literature.
#pragma once

#include <string>
#include <vector>

#include "../shared/catalogue_system.hpp"
#include "libration/equation/text/parse.hpp"

namespace libration::studies::proved {

struct stiff_problem {
    std::string name;
    std::string end;
    int factor;                             ///< of successive times
    std::string catalogue = {};             ///< its name there; empty: the same
    std::vector<std::string> changes = {};  ///< of parameters and initial values

    ode::equation_system equations() const { return catalogue_system(catalogue.empty() ? name : catalogue, changes); }

    /// end, end/factor, end/factor^2, .., so many of them in ascending order, after the initial time.
    std::vector<ode::number> times(int count) const {
        const ode::number start = ode::explicit_system(equations()).point();
        std::vector<ode::number> all;
        rational part = 1;
        for (int k = 0; k < count; ++k) {
            all.insert(all.begin(), start + ode::parse_constant(end).constant() * ode::number(part));
            part /= factor;
        }
        return all;
    }
};

/// Autonomous ones.
inline const std::vector<stiff_problem>& stiff_problems() {
    static const std::vector<stiff_problem> all{
        {"robertson", "1e11", 10},
        {"stiff_e5", "1e13", 10},
        {"oregonator", "360", 2},
        {"hires", "421.8122", 2},
        {"van_der_pol_1000", "2000", 2, "van_der_pol", {"m = 1000"}},
        {"stiff_d4", "50", 2},
    };
    return all;
}

}  // namespace libration::studies::proved
