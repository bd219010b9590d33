// The solution of a well that satisfies the condition at its right end, with the number of its zeros.
#pragma once

#include <optional>
#include <string>

#include "../../manifold/linear_series.hpp"
#include "../../manifold/regular_solution.hpp"
#include "well_equation.hpp"

namespace libration::ode {

/// The condition at an end: psi -> 0 at infinity, or value psi' = slope psi at a point.
struct well_end {
    std::optional<rational> point;  ///< of x; std::nullopt at infinity
    rational value = 0, slope = 1;  ///< psi and psi' there, up to a factor
    std::string text = {};          ///< as written
};

/// Of a solution, up to a positive factor: psi and dpsi/dx at the left point. Near the right end psi > 0.
struct end_state {
    ball value, slope;
    long zeros = 0;  ///< between the two, where they are counted
};

/// The part of a well from a point m to its right end.
///
/// Let Q = V - c E > 0 for all x >= h, seen where s = h + t makes all coefficients of the numerator and of the denominator of Q, as polynomials in t,
/// nonnegative. Then there is, up to a factor, exactly one solution that does not grow at infinity, and it has no
/// zero from h on, with z = psi'/psi < 0. If also, for all x >= H >= h, Q' >= 0 and 5 Q'^2 >= 4 Q Q'',
///     -sqrt(Q) - Q'/(4 Q) <= z(H) <= -sqrt(Q);
/// if q <= Q <= p there with q > 0, -sqrt(p) <= z(H) <= -sqrt(q) [docs/theorems/infinity.md, wells]. With the solutions
/// u, v with (u, u') = (1, z0), (v, v') = (0, 1) at H, |z(H) - z0| <= w and u > w |v| at h,
///     |z(h) - u'/u| <= w/(u (u - w |v|)).
/// Where Q is rational in s = exp(r x) and has a limit > 0, s = inf is a regular singular point, as is a pole of order 1
/// or 2 at a right end: the solution of the larger exponent is the decaying one.
class well_side {
public:
    /// m is exact. Throws error for a potential that tends to -infinity, and of the kind undecided for a pole at the right end at which psi = 0 does not determine a solution.
    well_side(const well_equation& of, well_end end, ball m);

    /// For an exact E, at the working precision; with the zeros in (m, end) if they are counted. std::nullopt if the precision is too low.
    /// Throws error of the kind undecided if Q > 0 is not seen at infinity, and at singular points.
    std::optional<end_state> at(const ball& e, bool counts_zeros) const;
    /// A bound above which no E is below the continuous spectrum: V/c at infinity; std::nullopt without one.
    std::optional<rational> continuum() const;
    /// V at a point s, roughly.
    double potential_near(double s) const;
    /// Whether s = x.
    bool is_in_x() const { return !well_.exponential; }

private:
    struct quotient_at {
        std::vector<ball> above, below;
    };
    struct pole {
        rational_polynomial above, below;  // of t^2 V, t the distance from the right end
    };
    void read_pole();
    quotient_at quotient(const ball& e) const;
    second_order_equation equation(const quotient_at& q) const;
    ball point_at(long k) const;
    ball speed(const ball& s) const;
    ball first_point(const quotient_at& q) const;
    ball far_point(const quotient_at& q, const ball& from, long bits) const;
    std::optional<ball> barrier(const quotient_at& q, const ball& far) const;
    std::optional<ball> regular_slope(const quotient_at& q, const ball& far) const;
    std::optional<end_state> at_pole(const ball& e, const second_order_equation& of, bool counts_zeros) const;
    std::optional<ball> slope_from_infinity(const quotient_at& q, const ball& from) const;
    bool tends_to_infinity() const;
    std::optional<end_state> carried(const second_order_equation& of, ball from, end_state state,
                                     bool counts_zeros) const;

    well_equation well_;
    well_end end_;
    ball m_;
    std::optional<pole> pole_;
};

}  // namespace libration::ode
