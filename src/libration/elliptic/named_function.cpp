#include "libration/elliptic/named_function.hpp"

#include <algorithm>
#include <array>

#include "named_values.hpp"

namespace libration::elliptic {

namespace {

constexpr auto functions = std::to_array<named_function>({
    {"am", "u", false, false, false, amplitude_value},  {"sn", "u", false, false, false, quotient_value},
    {"cn", "u", false, false, false, quotient_value},   {"dn", "u", false, false, false, quotient_value},
    {"cd", "u", false, false, false, quotient_value},   {"sd", "u", false, false, false, quotient_value},
    {"nd", "u", false, false, false, quotient_value},   {"dc", "u", false, false, false, quotient_value},
    {"nc", "u", false, false, false, quotient_value},   {"sc", "u", false, false, false, quotient_value},
    {"ns", "u", false, false, false, quotient_value},   {"ds", "u", false, false, false, quotient_value},
    {"cs", "u", false, false, false, quotient_value},   {"arcsn", "x", false, false, false, inverse_value},
    {"arccn", "x", false, false, false, inverse_value}, {"arcdn", "x", false, false, false, inverse_value},
    {"arccd", "x", false, false, false, inverse_value}, {"arcsd", "x", false, false, false, inverse_value},
    {"arcnd", "x", false, false, false, inverse_value}, {"arcdc", "x", false, false, false, inverse_value},
    {"arcnc", "x", false, false, false, inverse_value}, {"arcsc", "x", false, false, false, inverse_value},
    {"arcns", "x", false, false, false, inverse_value}, {"arcds", "x", false, false, false, inverse_value},
    {"arccs", "x", false, false, false, inverse_value}, {"K", "", false, false, false, integral_value},
    {"F", "phi", false, false, false, integral_value},  {"E", "phi", true, false, false, integral_value},
    {"D", "phi", true, false, false, integral_value},   {"Pi", "phi", true, true, false, integral_value},
    {"Zeta", "phi", false, false, false, zeta_value},   {"nome", "", false, false, false, nome_value},
    {"theta1", "z", false, false, true, theta_value},   {"theta2", "z", false, false, true, theta_value},
    {"theta3", "z", false, false, true, theta_value},   {"theta4", "z", false, false, true, theta_value},
});

}  // namespace

std::span<const named_function> named_functions() { return functions; }

const named_function* find_function(std::string_view name) {
    const auto* const found =
        std::find_if(functions.begin(), functions.end(), [&](const named_function& each) { return each.name == name; });
    return found == functions.end() ? nullptr : found;
}

}  // namespace libration::elliptic
