// Initial values that lead to a given asymptotic behaviour, found by shooting in floating-point arithmetic.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/series/power_series.hpp"

namespace libration::far {

mpfr ten_to(long exponent);
series::power_series<mpfr> polynomial(std::vector<mpfr> coefficients);
/// The value of a parameter.
mpfr parameter_of(const ode::equation_system& given, const std::string& name);
mpfr start_of(const ode::explicit_system& system, std::size_t unknown, std::size_t derivative);
/// The first unknown and its lower derivatives at a time.
std::vector<mpfr> state_at(const ode::equation_system& given, const mpfr& time);

/// A condition at a distance from the start: 0 for the state of the solution that satisfies the one at infinity.
using far_condition = std::function<mpfr(const std::vector<mpfr>& state, const mpfr& distance)>;

struct found_start {
    ode::equation_system system;
    mpfr value;
    mpfr distance;
    std::vector<mpfr> state;
};

/// The value of the parameter `free` for which the condition holds at distances that grow by half until little(state)
/// at the last one is below 10^-digits. Throws error if that does not converge.
found_start reach(const ode::equation_system& given, const std::string& free, const far_condition& condition,
                  const far_condition& little, const mpfr& first, long digits);

/// The value of S after an epidemic from s0: a/r ln(S/S0) + S0 + rest - S = 0 below ratio = a/r.
mpfr left_of_epidemic(const mpfr& ratio, const mpfr& s0, const mpfr& rest);

}  // namespace libration::far
