// The proof of a periodic orbit near a guess: its unknowns, the conditions that are left out, and its multipliers.
#pragma once

#include <vector>

#include "libration/query/shooting/periodic_orbit.hpp"
#include "orbit_map.hpp"

namespace libration::ode {

class orbit_proof {
public:
    orbit_proof(const first_order_form& form, const orbit_question& question,
                const std::vector<first_integral>& integrals)
        : form_(form), question_(question), integrals_(integrals) {}

    /// The digits of the unknowns, some more than requested where the rest of the proof needs them.
    long digits_of_root(bool in_family) const;
    /// The orbit near a guess of the unknowns of the map that is accurate to so many bits, as for proved_root. Throws error
    /// like it, and of the kind undecided if the conditions that are left out are not proved to hold, or if the
    /// multipliers are not enclosed.
    periodic_orbit orbit(const orbit_map& map, const std::vector<ball>& guess, long settled_bits) const;

private:
    std::vector<ball> root_of(const orbit_map& map, const std::vector<ball>& guess, long digits, long settled_bits,
                              std::vector<proved_decimal>& decimals) const;
    proved_decimal printed(const ball& x) const;
    void prove_rest(const orbit_map& map, std::vector<ball> root, long digits, periodic_orbit& orbit) const;
    bool add_multipliers(const orbit_map& map, const std::vector<ball>& root, long bits, periodic_orbit& orbit) const;

    const first_order_form& form_;
    const orbit_question& question_;
    const std::vector<first_integral>& integrals_;
};

}  // namespace libration::ode
