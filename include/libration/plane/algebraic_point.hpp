// An algebraic branch point of a solution with its local expansion, proved: B1 of docs/asymptotics.md.
#pragma once

#include <complex>
#include <vector>

#include "libration/plane/chart_atlas.hpp"
#include "libration/plane/uniformizing_chart.hpp"

namespace libration::ode {

/// Near `place` = t* - t0 the solution, continued from t0 along the ray to t*, is
///     y = sum over j >= -p of c_j x^j,  0 < |x| < reach,  |c_j| <= size reach^-(j+p),  x = (1 - (t - t0)/place)^(1/q)
/// with the principal root off the ray beyond t*.
struct algebraic_point {
    complex_ball place;
    int sheets = 2;
    int pole = 0;
    std::vector<complex_ball> coefficients;  ///< c_j, j = -p, -p + 1, ..
    ball reach, size;                        ///< exact
    std::complex<double> base;               ///< t - t0 on the ray where the expansion is that of the path
    bool real = false;                       ///< whether the place is real

    const complex_ball& coefficient(int j) const { return coefficients[static_cast<std::size_t>(j + pole)]; }
    int last() const { return static_cast<int>(coefficients.size()) - 1 - pole; }
    /// An upper bound of |y| for |x| in a ball of positive numbers below `reach`; infinite outside.
    magnitude bound_over(const ball& x) const;
};

/// The branch point near a place, with c_j up to `last`, at the working precision. By discs along the ray to a base before it, then in
/// the time s of the chart by Newton's method to its zero s*, one in a ball by interval Newton, on a path in the disc about s*; there t - t* = T_q sigma^q (1 +
/// om(sigma)), sigma = s - s*, |om| < 1 for |sigma| <= s_1 by norms and the tail of theorem T. Hence x = x_1 sigma (1 + om)^(1/q) takes
/// each value |xi| < |x_1| s_1 (1 - |om|)^(1/q) = reach once there (Rouche), y x^p is analytic in x, c_j follow by Lagrange's inversion,
/// and the root x_1 is the one for which x is principal at the base: arg (1 + om)^(1/q) is below pi/(2q). Throws precision_exhausted if
/// that is not shown.
algebraic_point algebraic_point_near(const explicit_system& system, const chart_atlas& atlas,
                                     const uniformizing_chart& chart, const complex_ball& near, int last);

}  // namespace libration::ode
