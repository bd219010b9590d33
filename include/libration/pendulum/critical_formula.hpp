// The closed solution on the separatrix as the paper writes it.
#pragma once

#include <stdexcept>

#include "libration/pendulum/phase.hpp"

namespace libration {

/// theta = -pi + 4 arctan(e^t tan((theta0 + pi)/4)) at dimensionless time t [paper (critical)], which holds for
/// omega0 = +2 cos(theta0/2) and |theta0| < pi; here for every motion with E = 2, by reflection and whole turns. It loses
/// relative digits next to theta = +-pi, where the arctangent saturates; exact_solution does not.
/// Throws std::domain_error for a motion with another energy.
template <scalar T>
T critical_formula(const motion& m, const T& t) {
    using std::atan;
    using std::exp;
    using std::tan;
    if (m.regime() != regime::separatrix) {
        throw std::domain_error("(critical) is the solution for E = 2");
    }
    const int d = m.direction();
    const T turned = whole_turns<T>(m.turns());
    const T start = (from_exact<T>(*m.theta0()) - turned) * d;
    return turned + (atan(T(exp(t) * tan(T((start + pi<T>()) / 4)))) * 4 - pi<T>()) * d;
}

}  // namespace libration
