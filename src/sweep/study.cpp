#include "sweep/study.hpp"

#include <stdexcept>

#include "libration/scalar/decimal.hpp"
#include "sweep/grid.hpp"

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
    return {energy.text, derived_text(rational(2 - energy.coefficient)), energy.coefficient};
}

sweep_energy energy_from_gap(const exact& gap) {
    const rational energy = 2 - gap.coefficient;
    require_energy(gap, energy);
    return {derived_text(energy), gap.text, energy};
}

void refuse_limits(const std::vector<sweep_energy>& energies, const std::string& at_rest, const std::string& critical) {
    for (const sweep_energy& at : energies) {
        const std::string reason = at.value == 0 ? at_rest : at.value == 2 ? critical : "";
        if (!reason.empty()) {
            throw std::domain_error("has the energy " + at.energy + ", where " + reason);
        }
    }
}

sweep_period_rule read_period_rule(std::string_view text) {
    constexpr int largest_order = 100'000;
    if (text == "agm") {
        return {{period_method::agm, 0}, std::string(text)};
    }
    const auto colon = text.find(':');
    const std::string_view method = text.substr(0, colon);
    if (colon == std::string_view::npos || (method != "series" && method != "resummed")) {
        throw std::invalid_argument("has '" + std::string(text) + "', which is not agm, series:N or resummed:N");
    }
    const auto way = method == "series" ? period_method::series : period_method::resummed;
    return {{way, read_count(text.substr(colon + 1), largest_order)}, std::string(text)};
}

}  // namespace libration
