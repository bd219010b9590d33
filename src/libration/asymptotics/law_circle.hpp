// The circle of a law: its radius between the moduli of singularities that a search found. Nothing here is proved.
#pragma once

#include <optional>
#include <vector>

#include "libration/plane/singularity_map.hpp"

namespace libration::ode {

struct law_circle {
    double rho = 0;
    /// The singularities inside, not below the real axis.
    std::vector<found_singularity> inside;
    /// The distance of the nearest one, 0 if there is none, and the size of the unknown `shown` at it.
    double nearest = 0;
    double size = 0;
};

/// Near sqrt(a b), with as many bits as that takes.
double few_bits_between(double a, double b);

/// With rho as given or between the moduli, with a logarithmic gap on both sides. Throws error of the kind undecided if none is
/// found and no rho is given.
law_circle circle_for(const explicit_system& system, std::size_t shown, const std::optional<double>& within,
                      const plane_watch& watch);

}  // namespace libration::ode
