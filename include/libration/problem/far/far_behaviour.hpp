// How solutions of the catalogue behave far from their start, which no text says: what asymptotic approximants need.
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

/// The problems of the catalogue that have one, by name.
const std::vector<std::string>& problems_with_far_behaviour();

/// The far behaviour of one of these, with other parameters where these have been changed. A free start (s of
/// falkner_skan, G of sakiadis, w0 of flierl_petviashvili; or `free` in its place, as b) is a first guess: the one that
/// meets the condition at infinity is found from it by the secant method at growing distances, in mpfr of 2 digits +
/// 20. Throws error for another problem and where that does not converge.
far_behaviour far_behaviour_of(const std::string& problem, const ode::equation_system& given, long digits,
                               const std::string& free = "");

/// The approximant that has the series f, a_0 .. a_N, at the start: a function of the variable. std::nullopt where a
/// Pade approximant does not exist.
std::optional<std::function<mpfr(const mpfr&)>> asymptotic_approximant(const far_behaviour& far,
                                                                       const series::power_series<mpfr>& f);

/// What the approximant of the layer of Sakiadis predicts from `known` coefficients, where f''(0) and f(inf) are both
/// unknown: with n = known - 2 exponentials as many conditions are left [Barlow2017].
struct sakiadis_prediction {
    mpfr wall_shear;  ///< f''(0)
    mpfr limit;       ///< f(inf)
    mpfr amplitude;   ///< G of f ~ f(inf) + G e^(-f(inf) t/2)
};

/// By Newton's method from (-0.45, 1.6), in the working precision. Throws error for known < 4.
sakiadis_prediction predicted_sakiadis(const ode::equation_system& given, int known);

}  // namespace libration
