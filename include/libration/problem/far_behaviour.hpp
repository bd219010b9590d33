// How a solution behaves far from its start, which no text of equations says: what asymptotic approximants need.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libration/ode/equation_system.hpp"
#include "libration/ode/explicit_system.hpp"
#include "libration/scalar/mpfr.hpp"
#include "libration/series/power_series.hpp"

namespace libration {

/// The forms of approximant/asymptotic/.
enum class far_form {
    power,                   ///< line + c/(1 + sum A_n t^n): power_approximant
    exponential,             ///< limit + sum A_j e^(-j rate t): exponential_approximant
    reciprocal_exponential,  ///< limit/(1 + sum A_j e^(-j rate t))
    damped,                  ///< e^(-rate t) (1 + t)^-1/2 P/Q: damped_pade
    damped_logarithm,        ///< exp(log limit + e^(-rate t) P/Q)
    branch                   ///< (1 - (t/end)^2)^(2/5) sum A_n t^n: branch_approximant
};

/// The far behaviour of one unknown of a problem, to so many digits, each of them heuristic.
struct far_behaviour {
    std::string problem;
    std::string unknown;
    far_form form;
    ode::explicit_system system;      ///< its free start is the one that reaches the far end
    series::power_series<mpfr> line;  ///< what the unknown tends to, of degree 0 or 1
    mpfr rate;                        ///< of the exponential, per unit of the variable; 0 for power and branch
    mpfr end;  ///< where the unknown has come to its far behaviour within 10^-digits; of a branch the branch point
    std::map<std::string, mpfr> values;  ///< numbers that belong to it, by the names of the literature

    /// Of the unknown in the system.
    int index() const;
};

/// The approximant that has the series f, a_0 .. a_N, at the start: a function of the variable. std::nullopt where a
/// Pade approximant does not exist.
std::optional<std::function<mpfr(const mpfr&)>> asymptotic_approximant(const far_behaviour& far,
                                                                       const series::power_series<mpfr>& f);

}  // namespace libration
