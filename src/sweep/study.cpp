#include "sweep/study.hpp"

#include <stdexcept>

#include "libration/scalar/decimal.hpp"

namespace libration {

namespace {

// A fraction whose decimals do not end stays a fraction.
std::string exact_text(const rational& value) { return to_finite_decimal(value).value_or(value.str()); }

void require_energy(const exact& number, const rational& energy) {
    if (number.measure != unit::one) {
        throw std::invalid_argument("has '" + number.text + "', which is not a decimal or a fraction");
    }
    if (energy < 0) {
        throw std::invalid_argument("has '" + number.text + "', which makes the energy negative");
    }
}

}  // namespace

sweep_energy energy_from(const exact& energy) {
    require_energy(energy, energy.coefficient);
    return {energy.text, exact_text(rational(2 - energy.coefficient)), energy.coefficient};
}

sweep_energy energy_from_gap(const exact& gap) {
    const rational energy = 2 - gap.coefficient;
    require_energy(gap, energy);
    return {exact_text(energy), gap.text, energy};
}

}  // namespace libration
