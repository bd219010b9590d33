#include "period_table.hpp"

#include <string>
#include <vector>

#include "libration/digits/printed_values.hpp"
#include "libration/scalar/decimal.hpp"

namespace libration {

using namespace elliptic;
using namespace pendulum;

namespace {

const std::vector<column> period_columns{{"energy", ""},    {"gap", ""},          {"method", ""},
                                         {"order", ""},     {"period", ""},       {"tstar", ""},
                                         {"error", ""},     {"regime", ""},       {"energy_typed", ""},
                                         {"gap_typed", ""}, {"theta0_typed", ""}, {"omega0_typed", ""}};

// T and T* in the motion's units.
template <class T>
std::vector<wide_t<T>> period_values(const period_request& request) {
    const motion& m = request.chosen.of;
    const T seconds = time_unit<T>(m);
    const T tstar = effective_period_by({request.method, request.order.value_or(0)}, energy_level_of<T>(m)) * seconds;
    return {widen(T(tstar * quarters_per_period(m.regime()))), widen(tstar)};
}

struct energy_texts {
    std::string energy;
    std::string gap;
};

struct period_texts {
    std::string period = "inf";
    std::string tstar = "inf";
    std::string error = "0";
};

// |T* as printed - true value|, the true value by the mean with more digits. It is nonzero: what is printed is
// rational, and T* at an algebraic energy is not [Schneider].
std::string error_of(const std::string& tstar, const period_request& request) {
    const motion& m = request.chosen.of;
    const auto difference = [&]<class T>() {
        const precision_scope more(request.numbers.digits + working_digits());
        const T truth = effective_period(energy_level_of<T>(m)) * time_unit<T>(m);
        return std::vector<T>{abs(from_exact<T>(read_exact(tstar)) - truth)};
    };
    return printed_right(request.numbers.scalar, error_digits, difference).front().text;
}

period_texts texts_of(const period_request& request) {
    const auto values =
        printed(request.numbers.scalar, request.numbers.digits, [&]<class T>() { return period_values<T>(request); });
    return {values[0].text, values[1].text, error_of(values[1].text, request)};
}

// Energy and gap as they were typed, or to this number of digits.
energy_texts printed_energies(const chosen_motion& chosen, const arithmetic& numbers) {
    if (chosen.energy && chosen.gap) {
        return {*chosen.energy, *chosen.gap};
    }
    const auto pair = printed_right(numbers.scalar, numbers.digits, [&]<class T>() {
        auto [energy, gap] = energies<T>(chosen.of);
        return std::vector<T>{std::move(energy), std::move(gap)};
    });
    return {pair[0].text, pair[1].text};
}

}  // namespace

table period_table(const period_request& request) {
    const chosen_motion& chosen = request.chosen;
    const regime r = chosen.of.regime();
    const energy_texts texts = printed_energies(chosen, request.numbers);
    period_texts found;
    if (!at_critical_energy(r)) {
        found = texts_of(request);
    }
    const std::string order = request.order ? std::to_string(*request.order) : "";
    return {period_columns,
            {{number_cell(texts.energy), number_cell(texts.gap), std::string(name_of(request.method)), read_cell(order),
              number_cell(found.period), number_cell(found.tstar), number_cell(found.error), std::string(name_of(r)),
              chosen.energy_typed, chosen.gap_typed, chosen.theta0_typed, chosen.omega0_typed}}};
}

}  // namespace libration
