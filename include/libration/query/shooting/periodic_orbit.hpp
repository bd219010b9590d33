// Periodic orbits, proved by Krawczyk's test (algebra/krawczyk.hpp).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libration/digits/known_value.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/query/states.hpp"
#include "libration/scalar/printed_number.hpp"

namespace libration::ode {

/// What the Floquet multipliers prove.
enum class orbit_stability {
    undecided,
    attracting,  ///< all but one are less than 1 in absolute value: asymptotically stable with a phase
    on_circle,   ///< those that are not 1 by integrals and symmetries are simple and of absolute value 1
    unstable     ///< one is greater than 1 in absolute value
};

/// A multiplier: exactly 1, by an integral, a symmetry or the direction of the orbit; else its proved parts.
struct floquet_multiplier {
    known_value real, imaginary;
    std::string reason = {};  ///< why it is exactly 1; empty for others
    bool is_real = false;
};

/// The unknowns and their lower derivatives at the initial point, and the period.
struct periodic_orbit {
    std::vector<std::string> names;
    std::vector<proved_decimal> start;  ///< "0" with an uncertainty for one that is not distinguished from 0
    proved_decimal period;
    /// The names of those that keep their initial values, and "period", if that is given and kept: an orbit of a family.
    std::vector<std::string> held = {};
    /// The integrals by which conditions were left out.
    std::vector<std::string> integrals = {};
    bool by_reversal = false;         ///< proved at half the period, by a reversal of time
    bool is_shortest_period = false;  ///< no shorter time is proved to be a period; else it is not known
    std::vector<floquet_multiplier> multipliers = {};
    orbit_stability stability = orbit_stability::undecided;
};

/// A question about a periodic orbit.
struct orbit_question {
    long digits = 50;
    std::optional<number> period = {};  ///< of an orbit of a family; else near which the period is searched
    bool multipliers = false;
};

/// The index in names_of_state() of the unknown that is fixed: it changes fastest at the initial point, relative to its
/// size. Throws error for a point of rest.
std::size_t unknown_on_section(const explicit_system& system);

/// Whether the system has integrals, so that its periodic orbits come in families.
bool has_families_of_orbits(const explicit_system& system);

/// The periodic orbit near the initial values of an autonomous system. Without integrals an unknown is fixed
/// (unknown_on_section), and the period is estimated from the nearest return among the first ones, or near a given
/// period. With the integrals that are found exactly (momenta, angular momenta, energies, and others: first_integral),
/// as many conditions are left out by theorem O (docs/theorems/equations.md), and so many unknowns keep their
/// initial values that the others are determined: the period itself, if it is given. All conditions are proved to hold.
/// Multipliers are the eigenvalues of the derivative of the flow over one period. Throws error like proved_root.
periodic_orbit proved_periodic_orbit(const explicit_system& system, const orbit_question& question,
                                     const proof_route& route = {}, const march_watch& watch = {});
periodic_orbit proved_periodic_orbit(const explicit_system& system, long digits, const proof_route& route = {},
                                     const march_watch& watch = {});

}  // namespace libration::ode
