#include "option/sweep_energy.hpp"

#include "libration/scalar/error.hpp"

#include <optional>
#include <stdexcept>

#include "libration/scalar/convert.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration {

namespace {

std::string derived_text(const rational& value) {
    if (const auto finite = to_finite_decimal(value)) {
        return *finite;
    }
    constexpr std::size_t longest_fraction = 50;
    if (std::string fraction = value.str(); fraction.size() <= longest_fraction) {
        return fraction;
    }
    const precision_scope scope(60);
    return to_decimal(from_rational<mpfr>(value), 50);
}

// As typed, and a formula as the fraction that it is.
std::string typed_text(const exact& number) { return number.composed ? derived_text(number.coefficient) : number.text; }

void require_energy(const exact& number, const rational& energy) {
    if (!number.is_fraction()) {
        throw error(error_kind::argument, "energies", "",
                    "has '" + number.text + "', which is not a decimal or a fraction");
    }
    if (energy < 0) {
        throw error(error_kind::argument, "energies", "", "has '" + number.text + "', which makes the energy negative");
    }
}

}  // namespace

sweep_energy energy_from(const exact& energy) {
    require_energy(energy, energy.coefficient);
    return {typed_text(energy), derived_text(rational(2 - energy.coefficient)), energy.coefficient};
}

sweep_energy energy_from_gap(const exact& gap) {
    const rational energy = 2 - gap.coefficient;
    require_energy(gap, energy);
    return {derived_text(energy), typed_text(gap), energy};
}

void refuse_limits(const std::vector<sweep_energy>& energies, const std::string& at_rest, const std::string& critical) {
    for (const sweep_energy& at : energies) {
        const std::string reason = at.value == 0 ? at_rest : at.value == 2 ? critical : "";
        if (!reason.empty()) {
            throw error(error_kind::argument, "energies", "", "has the energy " + at.energy + ", where " + reason);
        }
    }
}

}  // namespace libration
