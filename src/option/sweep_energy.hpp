// Energies as a person types them: E itself, or the gap 2 - E.
#pragma once

#include <string>
#include <vector>

#include "libration/scalar/exact.hpp"

namespace libration {

/// An energy of a sweep as it was typed: E itself, or the gap 2 - E.
struct sweep_energy {
    std::string energy;  ///< as typed, or 2 - gap: exact as a decimal or a short fraction, else to 50 digits
    std::string gap;     ///< likewise
    rational value;      ///< E
};

/// The energy E, or the one that a gap means. Throws error of the kind argument for what is not an energy (negative, with
/// pi).
sweep_energy energy_from(const exact& energy);
sweep_energy energy_from_gap(const exact& gap);

/// Refuses E = 0 and E = 2, before any work, where a study has no answer: throws error "has the energy 0,
/// where ..." with the reasons; an empty reason lets that energy pass.
void refuse_limits(const std::vector<sweep_energy>& energies, const std::string& at_rest, const std::string& critical);

}  // namespace libration
