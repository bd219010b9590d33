// The asymptotic behaviour of a solution, known in addition to its equations: required by asymptotic approximants.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libration/equation/equation_system.hpp"
#include "libration/equation/explicit_system.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/series/power_series.hpp"

namespace libration {

/// The forms of approximant/asymptotic/.
enum class far_form {
    power,                   ///< line + c/(1 + sum A_n t^n): power_approximant
    algebraic,               ///< c (1 + sum A_n s^n)^(-rate root/N), s^root = t: power_approximant
    exponential,             ///< limit + sum A_j e^(-j rate t): exponential_approximant
    reciprocal_exponential,  ///< limit/(1 + sum A_j e^(-j rate t))
    damped,                  ///< e^(-rate t) (1 + t)^-1/2 P/Q: damped_pade
    damped_logarithm,        ///< exp(log limit + e^(-rate t) P/Q)
    branch                   ///< (1 - (t/end)^2)^(2/5) sum A_n t^n: branch_approximant
};

/// The asymptotic behaviour of one unknown of a problem, to a given number of digits, each of them heuristic.
struct far_behaviour {
    std::string problem;
    std::string unknown;
    far_form form;
    ode::explicit_system system;      ///< its free initial value is the one that reaches the asymptotic regime
    series::power_series<mpfr> line;  ///< the asymptote of the unknown, of degree 0 or 1
    mpfr rate;  ///< of the exponential, per unit of t; m of a decay like t^-m; 0 for power and branch
    mpfr end;   ///< where the unknown is within 10^-digits of its asymptotic behaviour; of a branch the branch point
    std::map<std::string, mpfr> values;  ///< related numbers, by the names of the literature
    int root = 1;                        ///< the series is in powers of s, s^root = t

    /// Of the unknown in the system.
    int index() const;
};

/// The approximant of the series f, a_0 .. a_N, at the start: a function of the variable. std::nullopt if a
/// Pade approximant does not exist.
std::optional<std::function<mpfr(const mpfr&)>> asymptotic_approximant(const far_behaviour& far,
                                                                       const series::power_series<mpfr>& f);

}  // namespace libration
