// What a radius test says of a series in powers of a root of the variable, said of the variable.
#pragma once

#include <algorithm>
#include <string>

#include "libration/convergence/estimate/radius_estimate.hpp"
#include "libration/scalar/complex_number.hpp"
#include "libration/scalar/text/decimal.hpp"

namespace libration::convergence {

/// The answer to a list in powers of s = t^(1/q), q >= 1, as one in t: the radius and the position are raised to the
/// power q, the uncertainty u to (R + u)^q - R^q; exponents stay, for t - t0 is linear in s - s0 where s0 is not 0.
/// Several singularities in s may stand at one t, on
/// different sheets: the note of a verdict says where in s. Rounds as a power does.
template <rounding_scalar T>
radius_estimate<T> in_powers_of_root(radius_estimate<T> of, int q) {
    const auto raised = [q](const T& x) {
        T power(1);
        for (int i = 0; i < q; ++i) {
            power *= x;
        }
        return power;
    };
    if (q == 1 || !of.radius) {
        return of;
    }
    const T radius = raised(*of.radius);
    of.uncertainty = T(raised(T(*of.radius + of.uncertainty)) - radius);
    of.nearer = T(radius - raised(T(std::max(T(0), T(*of.radius - of.nearer)))));
    std::string note = "in powers of t^(1/" + std::to_string(q) + ")";
    if (of.position) {
        const complex_number<T> root = *of.position;
        note += ", where the singularity stands at " + to_decimal(root.re, 4) +
                (root.im == 0 ? "" : " + " + to_decimal(root.im, 4) + "i");
        for (int i = 1; i < q; ++i) {
            of.position = *of.position * root;
        }
    }
    of.radius = radius;
    if (of.method == "verdict") {
        of.note += (of.note.empty() ? "" : "; ") + note;
    }
    return of;
}

}  // namespace libration::convergence
