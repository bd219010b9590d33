// The closed solution on the separatrix in the notation of the paper.
#pragma once

#include "libration/pendulum/phase.hpp"
#include "libration/scalar/error.hpp"

namespace libration::pendulum {

/// w = e^t tan((theta0 + pi)/4), theta0 within its turn and in the direction of motion: theta = 4 arctan w - pi there.
/// Throws error for a motion with an energy not equal to 2.
template <scalar T>
T critical_growth(const motion& m, const T& t) {
    using std::exp;
    using std::tan;
    if (m.regime() != regime::separatrix) {
        throw error(error_kind::argument, "motion", "", "is not on the separatrix, whose solution (critical) is");
    }
    const T start = (from_exact<T>(*m.theta0()) - whole_turns<T>(m.turns())) * m.direction();
    return exp(t) * tan(T((start + pi<T>()) / 4));
}

/// theta = -pi + 4 arctan(e^t tan((theta0 + pi)/4)) at dimensionless time t [paper (critical)], which holds for
/// omega0 = +2 cos(theta0/2) and |theta0| < pi; here for every motion with E = 2, by reflection and whole turns. It
/// loses relative digits near theta = +-pi, where the arctangent saturates; exact_solution does not. Throws
/// error for a motion with another energy.
template <scalar T>
T critical_formula(const motion& m, const T& t) {
    using std::atan;
    return whole_turns<T>(m.turns()) + (atan(critical_growth(m, t)) * 4 - pi<T>()) * m.direction();
}

/// Its derivative by t, omega = 4 w/(1 + w^2), which keeps its relative digits. Throws as critical_formula.
template <scalar T>
T critical_speed(const motion& m, const T& t) {
    const T w = critical_growth(m, t);
    return 4 * w / (1 + w * w) * m.direction();
}

}  // namespace libration::pendulum
