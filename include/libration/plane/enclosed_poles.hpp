// All poles of a solution in a covered disc: theorem P.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "libration/plane/charted_covering.hpp"

namespace libration::ode {

/// The only zero of the coordinate with simple zeros (regular_coordinates::simple_zero) in |Re (z - centre)|, |Im (z - centre)| <= half_side,
/// which is a zero of v.
struct pole_box {
    std::complex<double> centre;
    double half_side = 0;
    std::size_t piece = 0;
    complex_ball place;  ///< an enclosure of it, relative to the initial point
    bool real = false;   ///< whether it is real, by the symmetry of the box

    bool holds(std::complex<double> z, double margin) const;
    bool contains(const complex_ball& z) const;
};

/// All poles of the function of a covering without slits in |t - t0| <= rho and Im t >= 0, possibly with some outside: each cell in chart
/// 1 excludes a zero of v or lies in a box in which interval Newton proves exactly one (is_pole_near has the test). A box that
/// meets the real axis is symmetric to it, so that its zero is real. Throws error of the kind undecided with the place if one of them
/// is not decided.
std::vector<pole_box> enclosed_poles(const chart_atlas& atlas, const charted_covering& covering, double rho);

/// A pole to the precision of the working bits: its place, and c_1 .. c_o of y = sum c_j (t - t*)^-j + an analytic function.
struct pole_terms {
    complex_ball place;
    std::vector<complex_ball> principal;
    bool real = false;
};

/// From the initial point straight to the pole in a box, in the charts of the atlas; y is single-valued in the covered disc, so
/// that any other path leads to the same pole. At the pole v = 0 and, at poles of order 2, p = 0 hold exactly; at those of order 1 of
/// an equation of second order p^2 = a3/2. Throws precision_exhausted if the working precision is not sufficient.
pole_terms terms_of_pole(const explicit_system& system, const chart_atlas& atlas, const pole_box& box);

}  // namespace libration::ode
