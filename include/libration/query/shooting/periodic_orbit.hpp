// Periodic orbits, proved by Krawczyk's test (algebra/krawczyk.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "libration/equation/explicit_system.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// The unknowns and their lower derivatives on a section, one of them fixed at its initial value, and the period.
struct periodic_orbit {
    std::vector<std::string> names;
    std::vector<proved_decimal> start;
    proved_decimal period;
};

/// The index in names_of_state() of the unknown that is fixed: it changes fastest at the initial point, relative to its
/// size. Throws error for a point of rest.
std::size_t unknown_on_section(const explicit_system& system);

/// The periodic orbit near the initial values of an autonomous system: an unknown is fixed
/// (unknown_on_section), and the period is estimated from the nearest return among the first ones. Throws error like
/// proved_root; for orbits in families, as if there is a first integral, dF/dx is singular.
periodic_orbit proved_periodic_orbit(const explicit_system& system, long digits, const proof_route& route = {},
                                     const march_watch& watch = {});

}  // namespace libration::ode
